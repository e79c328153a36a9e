// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTIGRID_PRECONDITIONER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTIGRID_PRECONDITIONER_H

#include <CGAL_ext/Square_parameterization/internal/minimization/Axis_preconditioner.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Matrix_sweep.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Vertex_interpolation.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/rows_by_ranges.h>

#include <optional>
#include <utility>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// solves with the matrices of `Axis_matrix`: by their factors on small patches, and on large ones approximately, by one
/// V-cycle over the coarser patches (Briggs, Henson, McCormick, A Multigrid Tutorial, chapter 3), in linear time and
/// memory. The coarser patches have matrices of their own, at their own maps.
///
/// One sweep of Gauss and Seidel before the coarse correction and one after it, in the other direction, keep the
/// approximate inverse symmetric and positive definite. They visit the blocks of the division at a time, on the threads of
/// the current team, and then the separators.
class Multigrid_preconditioner
{
public:
  /// the memory of one thread, for one patch
  struct Memory
  {
    bool is_set = false;       ///< `factorize()` has succeeded since this was last false
    Memory* coarser = nullptr; ///< of the next coarser patch, if there is one

    std::optional<Axis_preconditioner::Factors> factors; // of a small patch
    Axis_matrix::Matrix matrix;                          // of a large one
    Free_coordinates is_free;
    Uv_coordinates residual, solution, coarse;
  };

  /// of a patch that is small
  /// \param division of the patch, which must live as long
  Multigrid_preconditioner(const Patch& patch, const Patch_division& division) { m_direct.emplace(patch, &division); }

  /// of a patch that is large; `set_coarser()` is to follow
  /// \pre the patch is in the order of the division
  static Multigrid_preconditioner of_large(const Patch& patch, const Patch_division& division)
  {
    Multigrid_preconditioner result;
    result.m_matrix.emplace(patch, division.ranks(), &division);
    result.m_sweep.emplace(division, result.m_matrix->make());
    return result;
  }

  /// tells how the rows of the next coarser patch move those of this one, and what is for it
  void set_coarser(Vertex_interpolation interpolation, const Multigrid_preconditioner& coarser)
  {
    m_interpolation.emplace(std::move(interpolation));
    m_coarser = &coarser;
  }

  /// indicates whether it solves by factors
  bool is_direct() const { return m_direct.has_value(); }

  /// takes the matrices at \p uv; false when they are singular
  /// \param area_multiple see `Balanced_energy::hessian_blocks()`
  bool factorize(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                 Memory& memory, double area_multiple = Balanced_energy::AREA_MULTIPLE) const
  {
    memory.is_free = is_free;
    if(m_direct && !memory.factors)
      memory.factors.emplace();
    memory.is_set = m_direct ? m_direct->factorize(energy, uv, is_free, *memory.factors, area_multiple)
                             : set_matrix(energy, uv, is_free, area_multiple, memory);
    return memory.is_set;
  }

  /// takes the matrices of the last call with fewer coordinates that may move; false when they are singular
  bool factorize_fewer(const Free_coordinates& is_free, Memory& memory) const
  {
    if(m_direct) {
      memory.is_set = m_direct->factorize_fewer(memory.is_free, is_free, *memory.factors);
    } else {
      m_matrix->fix(is_free, memory.matrix);
      memory.is_set = Matrix_sweep::has_positive_diagonal(memory.matrix);
    }
    memory.is_free = is_free;
    return memory.is_set;
  }

  /// replaces \p x, which is zero where coordinates may not move, by the solution
  void apply(Memory& memory, Uv_coordinates& x) const
  {
    if(m_direct)
      m_direct->apply(*memory.factors, x);
    else
      cycle(memory, x);
  }

private:
  Multigrid_preconditioner() = default;

  bool set_matrix(const Balanced_energy& energy, const Uv_coordinates& uv, const Free_coordinates& is_free,
                  double area_multiple, Memory& memory) const
  {
    if(memory.matrix.nonZeros() == 0)
      memory.matrix = m_matrix->make();
    m_matrix->set(energy, uv, is_free, memory.matrix, area_multiple);
    return Matrix_sweep::has_positive_diagonal(memory.matrix);
  }

  void cycle(Memory& memory, Uv_coordinates& x) const
  {
    m_sweep->from_zero(memory.matrix, x, memory.solution, memory.residual);
    if(memory.coarser != nullptr && memory.coarser->is_set)
      correct_on_coarser(memory);
    m_sweep->subtract_product(memory.matrix, memory.solution, x);
    m_sweep->back(memory.matrix, x);
    set_rows(x, x.rows(), [&](const auto& rows) { return rows(x) + rows(memory.solution); });
  }

  /// adds to the solution what the coarser patch makes of the residual
  void correct_on_coarser(Memory& memory) const
  {
    Memory& coarser = *memory.coarser;
    m_interpolation->restrict_to_coarse(memory.residual, memory.coarse);
    memory.coarse = coarser.is_free.select(memory.coarse, 0.);
    m_coarser->apply(coarser, memory.coarse);
    Uv_coordinates& correction = memory.residual; // which is no longer needed
    m_interpolation->prolong(memory.coarse, correction);
    set_rows(memory.solution, memory.solution.rows(), [&](const auto& rows) {
      return rows(memory.solution) + rows(memory.is_free).select(rows(correction), 0.);
    });
  }

  const Multigrid_preconditioner* m_coarser = nullptr;
  std::optional<Axis_preconditioner> m_direct;         // of a small patch
  std::optional<Axis_matrix> m_matrix;                 // of a large one
  std::optional<Vertex_interpolation> m_interpolation; // of a large one
  std::optional<Matrix_sweep> m_sweep;                 // of a large one
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_MULTIGRID_PRECONDITIONER_H
