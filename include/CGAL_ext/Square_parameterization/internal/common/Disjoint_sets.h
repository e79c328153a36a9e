// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_DISJOINT_SETS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>

namespace CGAL_ext {
namespace internal {

/// disjoint sets of 0, 1, ..., n - 1, of which `find_set(i)` names one and `union_set(i, j)` joins two. Which member names
/// a set is not to be relied on.
typedef boost::disjoint_sets_with_storage<> Disjoint_sets;

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_DISJOINT_SETS_H
