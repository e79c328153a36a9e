// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_ON_THREADS_H
#define CGAL_EXT_ON_THREADS_H

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

/// while it lives, what works with the current team has so many threads; 0 for all cores
class On_threads
{
public:
  explicit On_threads(unsigned int threads) : m_team(threads), m_scope(m_team) {}

private:
  CGAL_ext::internal::Thread_team m_team;
  CGAL_ext::internal::Thread_team::Scope m_scope;
};

#endif // CGAL_EXT_ON_THREADS_H
