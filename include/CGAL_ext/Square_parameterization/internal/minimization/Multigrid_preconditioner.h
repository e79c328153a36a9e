// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTIGRID_PRECONDITIONER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTIGRID_PRECONDITIONER_H

#include <CGAL_ext/Square_parameterization/internal/minimization/Axis_preconditioner.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Vertex_interpolation.h>

#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// solves with the matrices of `Axis_matrix`: by their factors on small patches, and on large ones approximately, by one
/// V-cycle over the coarser patches (Briggs, Henson, McCormick, A Multigrid Tutorial, chapter 3), in linear time and
/// memory. The coarser patches have matrices of their own, at their own maps.
///
/// One sweep of Gauss and Seidel before the coarse correction and one after it, in the other direction, keep the
/// approximate inverse symmetric and positive definite.
class Multigrid_preconditioner
{
public:
  /// the memory of one thread, for one patch
  struct Memory
  {
    bool is_set = false;       ///< `factorize()` has succeeded since this was last false
    Memory* coarser = nullptr; ///< of the next coarser patch, if there is one

    Axis_preconditioner::Factors factors; // of a small patch
    Axis_matrix::Matrix matrix;           // of a large one
    Free_coordinates is_free;
    Uv_coordinates residual, solution, correction, coarse;
  };

  /// of a patch that is small
  explicit Multigrid_preconditioner(const Patch& patch) { m_direct.emplace(patch); }

  /// of a patch that is large
  Multigrid_preconditioner(const Patch& patch, const Coarse_patch& to_coarser, const Multigrid_preconditioner& coarser)
    : m_coarser(&coarser)
  {
    std::vector<int> rank(patch.number_of_vertices());
    std::iota(rank.begin(), rank.end(), 0);
    m_matrix.emplace(patch, std::move(rank));
    m_interpolation.emplace(patch, to_coarser);
  }

  /// takes the matrices at \p uv; false when they are singular
  bool factorize(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                 Memory& memory) const
  {
    memory.is_free = is_free;
    memory.is_set =
        m_direct ? m_direct->factorize(energy, uv, is_free, memory.factors) : set_matrix(energy, uv, is_free, memory);
    return memory.is_set;
  }

  /// replaces \p x, which is zero where coordinates may not move, by the solution
  void apply(Memory& memory, Uv_coordinates& x) const
  {
    if(m_direct)
      m_direct->apply(memory.factors, x);
    else
      cycle(memory, x);
  }

private:
  bool set_matrix(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                  Memory& memory) const
  {
    if(memory.matrix.nonZeros() == 0)
      memory.matrix = m_matrix->make();
    m_matrix->set(energy, uv, is_free, memory.matrix);
    for(Eigen::Index j = 0; j < memory.matrix.cols(); ++j)
      if(const Number_per_axis d = diagonal(memory.matrix, j); !(d[0] > 0 && d[1] > 0))
        return false;
    return true;
  }

  // the entries of a column of the upper triangle end with the one on the diagonal

  static const Number_per_axis& diagonal(const Axis_matrix::Matrix& matrix, Eigen::Index j)
  {
    return matrix.valuePtr()[matrix.outerIndexPtr()[j + 1] - 1];
  }

  template <class Visit>
  static void for_above_diagonal(const Axis_matrix::Matrix& matrix, Eigen::Index j, const Visit& visit)
  {
    for(int k = matrix.outerIndexPtr()[j], end = matrix.outerIndexPtr()[j + 1] - 1; k < end; ++k)
      visit(matrix.innerIndexPtr()[k], matrix.valuePtr()[k]);
  }

  static Number_per_axis at(const Uv_coordinates& uv, Eigen::Index v) { return {uv(v, 0), uv(v, 1)}; }

  static void put(const Number_per_axis& p, Eigen::Index v, Uv_coordinates& uv)
  {
    uv(v, 0) = p[0];
    uv(v, 1) = p[1];
  }

  void cycle(Memory& memory, Uv_coordinates& x) const
  {
    sweep_from_zero(memory.matrix, x, memory.solution, memory.residual);
    if(memory.coarser != nullptr && memory.coarser->is_set)
      correct_on_coarser(memory);
    subtract_product(memory.matrix, memory.solution, x);
    sweep_back(memory.matrix, x);
    x += memory.solution;
  }

  /// one sweep from zero for the right hand side \p x. The residual that it leaves comes from what is later in the order.
  static void sweep_from_zero(const Axis_matrix::Matrix& matrix, const Uv_coordinates& x, Uv_coordinates& solution,
                              Uv_coordinates& residual)
  {
    solution.resize(x.rows(), 2);
    residual.setZero(x.rows(), 2);
    for(Eigen::Index j = 0; j < x.rows(); ++j) {
      Number_per_axis here = at(x, j);
      for_above_diagonal(matrix, j, [&](int i, const Number_per_axis& a) { here -= a * at(solution, i); });
      here /= diagonal(matrix, j);
      put(here, j, solution);
      for_above_diagonal(matrix, j,
                         [&](int i, const Number_per_axis& a) { put(at(residual, i) - a * here, i, residual); });
    }
  }

  /// adds to the solution what the coarser patch makes of the residual
  void correct_on_coarser(Memory& memory) const
  {
    Memory& coarser = *memory.coarser;
    m_interpolation->restrict_to_coarse(memory.residual, memory.coarse);
    memory.coarse = coarser.is_free.select(memory.coarse, 0.);
    m_coarser->apply(coarser, memory.coarse);
    memory.correction.resize(memory.solution.rows(), 2);
    m_interpolation->prolong(memory.coarse, memory.correction);
    memory.solution += memory.is_free.select(memory.correction, 0.);
  }

  /// x becomes x - A y
  static void subtract_product(const Axis_matrix::Matrix& matrix, const Uv_coordinates& y, Uv_coordinates& x)
  {
    for(Eigen::Index j = 0; j < x.rows(); ++j) {
      const Number_per_axis here = at(y, j);
      Number_per_axis sum = diagonal(matrix, j) * here;
      for_above_diagonal(matrix, j, [&](int i, const Number_per_axis& a) {
        sum += a * at(y, i);
        put(at(x, i) - a * here, i, x);
      });
      put(at(x, j) - sum, j, x);
    }
  }

  /// one sweep from zero in the other direction: x, a right hand side, becomes its result
  static void sweep_back(const Axis_matrix::Matrix& matrix, Uv_coordinates& x)
  {
    for(Eigen::Index j = x.rows(); j-- > 0;) {
      const Number_per_axis here = at(x, j) / diagonal(matrix, j);
      put(here, j, x);
      for_above_diagonal(matrix, j, [&](int i, const Number_per_axis& a) { put(at(x, i) - a * here, i, x); });
    }
  }

  const Multigrid_preconditioner* m_coarser = nullptr;
  std::optional<Axis_preconditioner> m_direct;         // of a small patch
  std::optional<Axis_matrix> m_matrix;                 // of a large one
  std::optional<Vertex_interpolation> m_interpolation; // of a large one
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTIGRID_PRECONDITIONER_H
