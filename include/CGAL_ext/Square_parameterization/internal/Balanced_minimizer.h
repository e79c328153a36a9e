// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BALANCED_MINIMIZER_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BALANCED_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/Balanced_energy.h>
#include <CGAL_ext/Square_parameterization/internal/Minimized_map.h>
#include <CGAL_ext/Square_parameterization/internal/sparse_pattern.h>

#include <memory>
#include <vector>

namespace CGAL_ext {
namespace internal {

/// which coordinates of the vertices may move: #V by 2
typedef Eigen::Matrix<bool, Eigen::Dynamic, 2, Eigen::RowMajor> Free_coordinates;

/// the interior moves; the border stays, or slides along the sides of the unit square with its corners fixed
inline Free_coordinates free_coordinates(const Patch& patch, const Uv_coordinates& uv, bool is_border_sliding)
{
  Free_coordinates is_free = Free_coordinates::Constant(uv.rows(), 2, true);
  for(int v : patch.border)
    for(int axis = 0; axis < 2; ++axis) {
      const double across = uv(v, 1 - axis), along = uv(v, axis);
      is_free(v, axis) = is_border_sliding && (across == 0 || across == 1) && along > 0 && along < 1;
    }
  return is_free;
}

/// the largest t for which no uv triangle loses its area on the way from uv to uv + t direction; infinite when none
/// does
inline double largest_step(const Patch& patch, const Uv_coordinates& uv, const Uv_coordinates& direction)
{
  double largest = std::numeric_limits<double>::infinity();
  for(const auto& t : patch.triangles) {
    const Eigen::RowVector2d a = uv.row(t[1]) - uv.row(t[0]), b = uv.row(t[2]) - uv.row(t[0]);
    const Eigen::RowVector2d da = direction.row(t[1]) - direction.row(t[0]),
                             db = direction.row(t[2]) - direction.row(t[0]);
    const auto cross = [](const Eigen::RowVector2d& p, const Eigen::RowVector2d& q) {
      return p.x() * q.y() - q.x() * p.y();
    };
    // twice the area is constant + linear t + quadratic t^2; its least positive root, without cancellation
    const double quadratic = cross(da, db), linear = cross(a, db) + cross(da, b), constant = cross(a, b);
    const double discriminant = linear * linear - 4 * quadratic * constant;
    if(discriminant < 0 || (linear >= 0 && quadratic >= 0))
      continue;
    const double root = std::sqrt(discriminant);
    largest = (std::min)(largest, linear < 0 ? 2 * constant / (root - linear) : -(linear + root) / (2 * quadratic));
  }
  return largest;
}

/// the numbers of the minimizer; see `Stretch_optimal_parameterizer_3` for their meaning and defaults
struct Balanced_options
{
  double balance = 0.3;
  bool is_border_sliding = true;
  double tolerance = 1e-4;
  unsigned int maximum_iterations = 200;
};

/// minimises the balanced energy by a projected Newton method from a map without flips, and never leaves the maps
/// without flips.
///
/// Each step solves with the Hessian of clamped element Hessians (2 V unknowns; fixed ones have a unit row, so that one
/// sparsity pattern and one symbolic analysis serve every border), goes at most nine tenths of the way to the first
/// triangle without area, and searches the line: backtracking by halves, or doubling while the energy falls.
class Balanced_minimizer
{
public:
  /// the memory of one thread
  struct Workspace
  {
    Sparse_matrix matrix;
    Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> solver;
    bool is_analyzed = false;
    Eigen::VectorXd right_hand_side;
    Uv_coordinates gradient, direction, trial;
  };

  Balanced_minimizer(const Patch& patch, const Balanced_options& options)
    : m_energy(patch, options.balance),
      m_options(options),
      m_rank(fill_reducing_order(patch.number_of_vertices(), patch.edges))
  {
    build_pattern(patch);
  }

  /// \pre \p start has no flips and its border lies on the unit square
  Minimized_map minimize(Uv_coordinates start, Workspace& workspace) const
  {
    const Patch& patch = m_energy.patch();
    const Free_coordinates is_free = free_coordinates(patch, start, m_options.is_border_sliding);
    Minimized_map map{std::move(start), {}};
    Minimization_report& report = map.report;
    report.stop_reason = Stop_reason::MAXIMUM_ITERATIONS;
    report.objective = m_energy.gradient(map.uv, workspace.gradient);
    clear_fixed(is_free, workspace.gradient);
    report.history.push_back(report.objective);
    while(report.iterations < m_options.maximum_iterations) {
      if(!find_direction(map.uv, is_free, workspace)) {
        report.stop_reason = Stop_reason::CANNOT_SOLVE;
        break;
      }
      const double slope = workspace.gradient.cwiseProduct(workspace.direction).sum();
      if(-slope / 2 <= m_options.tolerance * report.objective) {
        report.stop_reason = Stop_reason::CONVERGED;
        break;
      }
      if(!search_line(report.objective, slope, map.uv, workspace)) {
        report.stop_reason = Stop_reason::NO_LOWER_MAP;
        break;
      }
      report.best_iteration = ++report.iterations;
      report.objective = m_energy.gradient(map.uv, workspace.gradient);
      clear_fixed(is_free, workspace.gradient);
      report.history.push_back(report.objective);
    }
    report.gradient_norm = workspace.gradient.norm();
    report.l2 = std::sqrt(stretch_energy(patch, map.uv));
    return map;
  }

private:
  int unknown(int vertex, int axis) const { return 2 * m_rank[vertex] + axis; }

  /// the pattern of the upper triangle, and for every triangle where its 36 entries go (only those of the upper
  /// triangle)
  void build_pattern(const Patch& patch)
  {
    const int n = 2 * patch.number_of_vertices();
    std::vector<Eigen::Triplet<double>> entries;
    for(int v = 0; v < patch.number_of_vertices(); ++v)
      for(const auto& [i, j] : {std::make_pair(0, 0), std::make_pair(0, 1), std::make_pair(1, 1)})
        entries.emplace_back(unknown(v, i), unknown(v, j), 1.);
    for(const auto& [a, b] : patch.edges) {
      const auto [first, second] = m_rank[a] < m_rank[b] ? std::make_pair(a, b) : std::make_pair(b, a);
      for(int i = 0; i < 2; ++i)
        for(int j = 0; j < 2; ++j)
          entries.emplace_back(unknown(first, i), unknown(second, j), 1.);
    }
    m_pattern.resize(n, n);
    m_pattern.setFromTriplets(entries.begin(), entries.end());
    m_pattern.makeCompressed();
    m_slots.resize(patch.triangles.size());
    for(std::size_t f = 0; f < patch.triangles.size(); ++f)
      for(int i = 0; i < 6; ++i)
        for(int j = i; j < 6; ++j) {
          const int p = unknown(patch.triangles[f][i / 2], i % 2), q = unknown(patch.triangles[f][j / 2], j % 2);
          m_slots[f][6 * i + j] = slot_of(m_pattern, (std::min)(p, q), (std::max)(p, q));
        }
    for(int i = 0; i < n; ++i)
      m_diagonal.push_back(slot_of(m_pattern, i, i));
  }

  static void clear_fixed(const Free_coordinates& is_free, Uv_coordinates& x) { x = is_free.select(x, 0.); }

  /// the Newton direction; false when the matrix cannot be factored
  bool find_direction(const Uv_coordinates& uv, const Free_coordinates& is_free, Workspace& workspace) const
  {
    assemble(uv, is_free, workspace);
    if(!workspace.is_analyzed)
      workspace.solver.analyzePattern(workspace.matrix);
    workspace.is_analyzed = true;
    workspace.solver.factorize(workspace.matrix);
    if(workspace.solver.info() != Eigen::Success)
      return false;
    workspace.right_hand_side.resize(m_pattern.rows());
    for(int v = 0; v < uv.rows(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        workspace.right_hand_side[unknown(v, axis)] = -workspace.gradient(v, axis);
    const Eigen::VectorXd solution = workspace.solver.solve(workspace.right_hand_side);
    workspace.direction.resize(uv.rows(), 2);
    for(int v = 0; v < uv.rows(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        workspace.direction(v, axis) = is_free(v, axis) ? solution[unknown(v, axis)] : 0;
    return workspace.direction.allFinite();
  }

  void assemble(const Uv_coordinates& uv, const Free_coordinates& is_free, Workspace& workspace) const
  {
    if(workspace.matrix.nonZeros() == 0)
      workspace.matrix = m_pattern;
    double* const values = workspace.matrix.valuePtr();
    std::fill(values, values + workspace.matrix.nonZeros(), 0.);
    for(int v = 0; v < uv.rows(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        if(!is_free(v, axis))
          values[m_diagonal[unknown(v, axis)]] = 1;
    const Patch& patch = m_energy.patch();
    for(int f = 0; f < patch.number_of_faces(); ++f) {
      const Balanced_energy::Element_hessian hessian = m_energy.hessian(f, uv);
      bool is_row_free[6];
      for(int i = 0; i < 6; ++i)
        is_row_free[i] = is_free(patch.triangles[f][i / 2], i % 2);
      for(int i = 0; i < 6; ++i)
        for(int j = i; j < 6; ++j)
          if(is_row_free[i] && is_row_free[j])
            values[m_slots[f][6 * i + j]] += hessian(i, j);
    }
  }

  /// moves \p uv along the direction to a lower energy; false when there is none
  bool search_line(double energy, double slope, Uv_coordinates& uv, Workspace& workspace) const
  {
    constexpr double SUFFICIENT_DECREASE = 1e-4, SAFETY = 0.9;
    constexpr int MAXIMUM_HALVINGS = 60;
    const double largest = SAFETY * largest_step(m_energy.patch(), uv, workspace.direction);
    const auto energy_at = [&](double step) {
      workspace.trial = uv + step * workspace.direction;
      return m_energy(workspace.trial);
    };
    double step = (std::min)(1., largest);
    double reached = energy_at(step);
    for(int i = 0; !(reached <= energy + SUFFICIENT_DECREASE * step * slope); ++i) {
      if(i == MAXIMUM_HALVINGS)
        return false;
      step /= 2;
      reached = energy_at(step);
    }
    while(2 * step <= largest) {
      const double further = energy_at(2 * step);
      if(!(further < reached))
        break;
      step *= 2;
      reached = further;
    }
    uv += step * workspace.direction;
    return reached < energy;
  }

  Balanced_energy m_energy;
  Balanced_options m_options;
  std::vector<int> m_rank; // #V: place in the elimination order; the two unknowns of a vertex stay together
  Sparse_matrix m_pattern;
  std::vector<std::array<int, 36>> m_slots; // #F: only entries on or above the diagonal are set
  std::vector<int> m_diagonal;              // one per unknown
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_BALANCED_MINIMIZER_H
