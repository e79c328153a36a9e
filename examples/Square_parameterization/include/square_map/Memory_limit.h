// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_MEMORY_LIMIT_H
#define SQUARE_MAP_MEMORY_LIMIT_H

#include "Memory_in_use.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>

namespace square_map {

/// while it lives, the process may not allocate more than \p bytes: a file whose header promises billions then ends in
/// `std::bad_alloc`, and not in a machine without memory. Does nothing where there is no /proc.
class Memory_limit
{
public:
  explicit Memory_limit(std::size_t bytes)
  {
    const rlim_t used = Memory_in_use().address_space;
    if(used == 0 || getrlimit(RLIMIT_AS, &m_before) != 0)
      return;
    rlimit limit = m_before;
    limit.rlim_cur = std::min(limit.rlim_cur, used + bytes);
    m_is_set = setrlimit(RLIMIT_AS, &limit) == 0;
  }

  Memory_limit(const Memory_limit&) = delete;
  Memory_limit& operator=(const Memory_limit&) = delete;

  ~Memory_limit()
  {
    if(m_is_set)
      setrlimit(RLIMIT_AS, &m_before);
  }

private:
  rlimit m_before{};
  bool m_is_set = false;
};

} // namespace square_map

#endif // SQUARE_MAP_MEMORY_LIMIT_H
