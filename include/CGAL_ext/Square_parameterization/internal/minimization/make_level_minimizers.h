// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_LEVEL_MINIMIZERS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_LEVEL_MINIMIZERS_H

#include <CGAL_ext/Square_parameterization/internal/coarsening/Coarse_patch.h>
#include <CGAL_ext/Square_parameterization/internal/common/Minimizer_numbers.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch_division.h>
#include <CGAL_ext/Square_parameterization/internal/patch/vertices_along_curve.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// ever coarser patches that one thread makes and another waits for
class Coarse_patch_stream
{
public:
  void add(const Coarse_patch& coarse) { put(&coarse); }

  /// tells that no more will come
  void end() { put(nullptr); }

  /// waits for the next patch; null after the last
  const Coarse_patch* next()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_has_come.wait(lock, [this] { return !m_waiting.empty(); });
    const Coarse_patch* const coarse = m_waiting.front();
    m_waiting.pop_front();
    return coarse;
  }

private:
  void put(const Coarse_patch* coarse)
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_waiting.push_back(coarse);
    }
    m_has_come.notify_one();
  }

  std::mutex m_mutex; // guards what follows
  std::deque<const Coarse_patch*> m_waiting;
  std::condition_variable m_has_come;
};

/// the vertices of a coarse patch in the order in which a curve visits them in the fine patch
inline std::vector<int> coarse_curve(const std::vector<int>& fine_curve, const Coarse_patch& coarse)
{
  std::vector<int> coarse_vertex(fine_curve.size(), -1);
  for(std::size_t v = 0; v < coarse.fine_vertex.size(); ++v)
    coarse_vertex[coarse.fine_vertex[v]] = static_cast<int>(v);
  std::vector<int> curve;
  for(int v : fine_curve)
    if(coarse_vertex[v] >= 0)
      curve.push_back(coarse_vertex[v]);
  return curve;
}

/// indicates whether all vertices are near the border, along edges: then a few vertices divide the patch wherever it is cut in
/// two (a planar graph of depth k has a treewidth below 3 k + 3), and its factors take linear time and memory
inline bool is_near_border(const Patch& patch)
{
  std::vector<int> distance(patch.points.size(), Minimizer_numbers::LARGEST_DEPTH_FACTORED + 1);
  for(int v : patch.border)
    distance[v] = 0;
  for(int reached = 0; reached < Minimizer_numbers::LARGEST_DEPTH_FACTORED; ++reached)
    for(const auto& [a, b] : patch.edges) {
      distance[a] = (std::min)(distance[a], distance[b] + 1);
      distance[b] = (std::min)(distance[b], distance[a] + 1);
    }
  return *std::max_element(distance.begin(), distance.end()) <= Minimizer_numbers::LARGEST_DEPTH_FACTORED;
}

/// makes the minimizers of a patch and of the coarser ones, each as soon as its patch is there; those of large patches
/// are still to be told of their coarser ones
/// \param options of the patch itself, \p coarse_options of the others
inline std::vector<std::unique_ptr<Balanced_minimizer>>
make_level_minimizers(const Patch& finest, Coarse_patch_stream& coarser, const Balanced_minimization& options,
                      const Balanced_minimization& coarse_options, const Deadline& deadline)
{
  std::vector<std::unique_ptr<Balanced_minimizer>> minimizers;
  std::vector<int> curve;
  if(Patch_division::is_large(finest))
    curve = vertices_along_curve(finest.points);
  const auto make = [&](const Patch& patch, bool has_coarser) {
    return std::make_unique<Balanced_minimizer>(Patch_division(patch, curve), has_coarser, patch,
                                                &patch == &finest ? options : coarse_options, deadline);
  };
  const auto is_to_be_factored = [](const Patch& patch) {
    return patch.number_of_vertices() <= Minimizer_numbers::LARGEST_FACTORED || is_near_border(patch);
  };
  minimizers.push_back(make(finest, !is_to_be_factored(finest)));
  while(const Coarse_patch* const coarse = coarser.next()) {
    curve = Patch_division::is_large(coarse->patch) ? coarse_curve(curve, *coarse) : std::vector<int>();
    minimizers.push_back(make(coarse->patch, !is_to_be_factored(coarse->patch)));
  }
  const Patch& coarsest = minimizers.back()->patch();
  if(!is_to_be_factored(coarsest)) // there was to be a coarser one
    minimizers.back() = make(coarsest, false);
  return minimizers;
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MAKE_LEVEL_MINIMIZERS_H
