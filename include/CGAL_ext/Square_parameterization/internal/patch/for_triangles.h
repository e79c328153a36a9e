// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FOR_TRIANGLES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FOR_TRIANGLES_H

#include <CGAL_ext/Square_parameterization/internal/common/ranges.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// calls `visit(i, value)` for i = begin, ..., end - 1, in this order
/// \tparam N triangles of which the values are computed at a time
/// \param triangle returns the number of the i-th triangle
/// \param values_of returns the values of N triangles; at the end the last one may be among them several times
template <std::size_t N, class Triangle, class ValuesOf, class Visit>
void for_triangles(std::size_t begin, std::size_t end, const Triangle& triangle, const ValuesOf& values_of,
                   const Visit& visit)
{
  for(std::size_t i = begin; i < end; i += N) {
    std::array<int, N> faces;
    for(std::size_t k = 0; k < N; ++k)
      faces[k] = triangle((std::min)(i + k, end - 1));
    const auto values = values_of(faces);
    for(std::size_t k = 0; k < N && i + k < end; ++k)
      visit(i + k, values[k]);
  }
}

/// computes something of each triangle of a divided patch and adds it up at the vertices, on the threads of the current
/// team: `add(f, value, sum)` is called for triangles of different blocks at a time, and in a fixed order for the
/// triangles at one vertex
/// \tparam N, \param values_of see `for_triangles()`
/// \param sum what `add()` adds up for the whole patch
template <std::size_t N, class Sum, class ValuesOf, class Add>
void for_divided_triangles(const Patch_division& division, Sum& sum, const ValuesOf& values_of, const Add& add)
{
  typedef typename std::invoke_result_t<ValuesOf, std::array<int, N>>::value_type Value;
  const std::vector<int>& joints = division.joints();
  const std::size_t blocks = division.number_of_blocks(), ranges = (joints.size() + RANGE - 1) / RANGE;
  std::vector<Sum> sums(blocks, Sum(0));
  std::vector<Value> at_joints(joints.size());
  Thread_team::current()(blocks + ranges, [&](std::size_t i) {
    if(i < blocks) {
      const auto [begin, end] = division.triangles_of_block(static_cast<int>(i));
      const auto triangle = [&division](std::size_t place) { return division.triangle(static_cast<int>(place)); };
      Sum sum_of_block(0);
      for_triangles<N>(begin, end, triangle, values_of,
                       [&](std::size_t place, const Value& value) { add(triangle(place), value, sum_of_block); });
      sums[i] = sum_of_block;
    } else {
      const std::size_t begin = (i - blocks) * RANGE, end = (std::min)(joints.size(), begin + RANGE);
      for_triangles<N>(
          begin, end, [&](std::size_t k) { return joints[k]; }, values_of,
          [&](std::size_t k, const Value& value) { at_joints[k] = value; });
    }
  });
  for(const Sum& sum_of_block : sums)
    sum += sum_of_block;
  for(std::size_t k = 0; k < joints.size(); ++k)
    add(joints[k], at_joints[k], sum);
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_PATCH_FOR_TRIANGLES_H
