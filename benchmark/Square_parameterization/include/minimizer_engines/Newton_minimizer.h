// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_BENCHMARK_NEWTON_MINIMIZER_H
#define CGAL_EXT_BENCHMARK_NEWTON_MINIMIZER_H

#include <CGAL_ext/Square_parameterization/internal/Balanced_minimizer.h>

#include <Eigen/Eigenvalues>

namespace minimizer_engines {

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

/// the whole Hessian of an element of the balanced energy
class Element_hessians
{
public:
  /// gradients of the hat functions of a triangle in its own plane: the Jacobian is K = sum_k p_k g_k^T
  typedef std::array<Eigen::Vector2d, 3> Hat_gradients;

  /// second derivatives of one triangle with respect to (u0, v0, u1, v1, u2, v2)
  typedef Eigen::Matrix<double, 6, 6> Element_hessian;

  Element_hessians(const Patch& patch, double balance) : m_patch(patch), m_balance(balance) {}

  /// the Hessian of triangle \p f, made positive semidefinite by clamping the negative of its closed-form eigenvalues
  /// (Smith, de Goes, Kim 2019).
  ///
  /// The total signed area of a map with fixed border, or with a border that slides along the square, is constant, so
  /// any multiple of det(K) may be added: the objective and its gradient stay, and fewer eigenvalues need clamping.
  Element_hessian hessian(int f, const Uv_coordinates& uv) const
  {
    constexpr double AREA_SHIFT = 2;
    const Hat_gradients g = hat_gradients(m_patch.shapes[f]);
    const Singular_values svd(jacobian(f, uv, g));
    const double s1 = svd.s1, s2 = svd.s2;
    const double cubes = 1 / (s1 * s1 * s1 * s2 * s2 * s2);
    const double twist = 2 * (m_balance - (s1 * s1 - s1 * s2 + s2 * s2) * cubes) + AREA_SHIFT;
    const double flip = 2 * (m_balance + (s1 * s1 + s1 * s2 + s2 * s2) * cubes) - AREA_SHIFT;
    Eigen::Matrix2d scaling;
    scaling << 6 / std::pow(s1, 4) + 2 * m_balance, AREA_SHIFT, AREA_SHIFT, 6 / std::pow(s2, 4) + 2 * m_balance;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> scaling_modes;
    scaling_modes.computeDirect(scaling);

    const Eigen::Matrix2d stretch_1 = svd.u1 * svd.v1.transpose(), stretch_2 = svd.u2 * svd.v2.transpose();
    const Eigen::Matrix2d shear_1 = svd.u2 * svd.v1.transpose(), shear_2 = svd.u1 * svd.v2.transpose();
    const double area = m_patch.shapes[f].area();
    Element_hessian hessian = Element_hessian::Zero();
    const auto add_mode = [&](double eigenvalue, const Eigen::Matrix2d& mode) {
      if(!(eigenvalue > 0))
        return;
      Eigen::Matrix<double, 6, 1> column;
      column << mode * g[0], mode * g[1], mode * g[2];
      hessian.noalias() += (area * eigenvalue) * column * column.transpose();
    };
    add_mode(twist, (shear_1 - shear_2) / std::sqrt(2.));
    add_mode(flip, (shear_1 + shear_2) / std::sqrt(2.));
    for(int i = 0; i < 2; ++i) {
      const Eigen::Vector2d mode = scaling_modes.eigenvectors().col(i);
      add_mode(scaling_modes.eigenvalues()[i], mode[0] * stretch_1 + mode[1] * stretch_2);
    }
    return hessian;
  }

private:
  /// singular value decomposition K = s1 u1 v1^T + s2 u2 v2^T of a matrix with positive determinant
  struct Singular_values
  {
    explicit Singular_values(const Eigen::Matrix2d& K)
    {
      const double sum = std::atan2(K(1, 0) - K(0, 1), K(0, 0) + K(1, 1));
      const double difference = std::atan2(K(1, 0) + K(0, 1), K(0, 0) - K(1, 1));
      const double left = (sum + difference) / 2, right = (difference - sum) / 2;
      u1 = {std::cos(left), std::sin(left)};
      u2 = {-u1.y(), u1.x()};
      v1 = {std::cos(right), std::sin(right)};
      v2 = {-v1.y(), v1.x()};
      s1 = (std::hypot(K(0, 0) + K(1, 1), K(1, 0) - K(0, 1)) + std::hypot(K(0, 0) - K(1, 1), K(1, 0) + K(0, 1))) / 2;
      s2 = K.determinant() / s1; // a difference of the two lengths would cancel
    }

    double s1, s2;
    Eigen::Vector2d u1, u2, v1, v2;
  };

  static Hat_gradients hat_gradients(const Flat_triangle& shape)
  {
    const Eigen::Vector2d first(1 / shape.x1, -shape.x2 / (shape.x1 * shape.y2)), second(0, 1 / shape.y2);
    return {-first - second, first, second};
  }

  Eigen::Matrix2d jacobian(int f, const Uv_coordinates& uv, const Hat_gradients& g) const
  {
    const auto& t = m_patch.triangles[f];
    return (uv.row(t[1]) - uv.row(t[0])).transpose() * g[1].transpose() +
           (uv.row(t[2]) - uv.row(t[0])).transpose() * g[2].transpose();
  }

  const Patch& m_patch;
  double m_balance;
};

/// minimises the balanced energy by a projected Newton method from a map without flips, and never leaves the maps
/// without flips.
///
/// Each step solves with the Hessian of clamped element Hessians (2 V unknowns; fixed ones have a unit row, so that one
/// sparsity pattern and one symbolic analysis serve every border), goes at most nine tenths of the way to the first
/// triangle without area, and searches the line: backtracking by halves, or doubling while the energy falls.
class Newton_minimizer
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

  Newton_minimizer(const Patch& patch, const Balanced_options& options)
    : m_energy(patch, options.balance),
      m_hessians(patch, options.balance),
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
      const Element_hessians::Element_hessian hessian = m_hessians.hessian(f, uv);
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
  Element_hessians m_hessians;
  Balanced_options m_options;
  std::vector<int> m_rank; // #V: place in the elimination order; the two unknowns of a vertex stay together
  Sparse_matrix m_pattern;
  std::vector<std::array<int, 36>> m_slots; // #F: only entries on or above the diagonal are set
  std::vector<int> m_diagonal;              // one per unknown
};

} // namespace minimizer_engines

#endif // CGAL_EXT_BENCHMARK_NEWTON_MINIMIZER_H
