// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BSPLINE_SURFACE_H
#define BSPLINE_SURFACE_H

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <unsupported/Eigen/Splines>

#include <cmath>
#include <cstddef>
#include <vector>

/// a point of a surface, where it lies on the unit square, and the area that it stands for
struct Surface_sample
{
  Eigen::Vector3d point;
  double u, v, area;
};

/// a bicubic tensor product B-spline surface over the unit square, with as many control points along u as along v, and
/// uniform knots that are repeated at the ends
class Bspline_surface
{
public:
  /// fits the surface to samples by least squares, each with the weight of its area. Control points that the samples
  /// leave open are drawn, very weakly, to the origin.
  /// \param control_points along each side; 4 or more
  Bspline_surface(const std::vector<Surface_sample>& samples, int control_points) : m_size(control_points)
  {
    m_knots = Knots::LinSpaced(control_points + 4, -3, control_points).cwiseMax(0).cwiseMin(control_points - 3.) /
              (control_points - 3.);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d points(samples.size(), 3);
    for(std::size_t k = 0; k < samples.size(); ++k) {
      const double weight = std::sqrt(samples[k].area);
      points.row(static_cast<Eigen::Index>(k)) = weight * samples[k].point.transpose();
      for_each_basis_function(samples[k], [&](int control_point, double value) {
        entries.emplace_back(static_cast<int>(k), control_point, weight * value);
      });
    }
    Eigen::SparseMatrix<double> basis(points.rows(), m_size * m_size);
    basis.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double> normal = basis.transpose() * basis;
    const double mean = normal.diagonal().mean();
    for(int k = 0; k < m_size * m_size; ++k)
      normal.coeffRef(k, k) += 1e-9 * mean;
    m_control_points = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(normal).solve(basis.transpose() * points);
  }

  /// the distances of the samples from their places on the surface: the root of their mean square, by area
  double rms_error(const std::vector<Surface_sample>& samples) const
  {
    double sum = 0, area = 0;
    for(const Surface_sample& sample : samples) {
      Eigen::Vector3d place = Eigen::Vector3d::Zero();
      for_each_basis_function(sample, [&](int control_point, double value) {
        place += value * m_control_points.row(control_point).transpose();
      });
      sum += sample.area * (place - sample.point).squaredNorm();
      area += sample.area;
    }
    return std::sqrt(sum / area);
  }

private:
  typedef Eigen::Spline<double, 1, 3> Spline;
  typedef Spline::KnotVectorType Knots;

  /// calls `use(control point, value)` for the sixteen basis functions that do not vanish at the sample
  template <class Use>
  void for_each_basis_function(const Surface_sample& sample, const Use& use) const
  {
    const auto span_u = Spline::Span(sample.u, 3, m_knots), span_v = Spline::Span(sample.v, 3, m_knots);
    const auto along_u = Spline::BasisFunctions(sample.u, 3, m_knots);
    const auto along_v = Spline::BasisFunctions(sample.v, 3, m_knots);
    for(int j = 0; j < 4; ++j)
      for(int i = 0; i < 4; ++i)
        use(static_cast<int>((span_v - 3 + j) * m_size + span_u - 3 + i), along_u(i) * along_v(j));
  }

  int m_size;
  Knots m_knots;
  Eigen::MatrixX3d m_control_points;
};

#endif // BSPLINE_SURFACE_H
