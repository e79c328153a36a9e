// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_HESSIAN_MODES_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_HESSIAN_MODES_H

#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>

#include <array>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// the Jacobians of two triangles, entry by entry: what is computed of one is computed of both by the same instructions
struct Jacobians
{
  Eigen::Array2d xx, xy, yx, yy;
};

/// the eigenmodes of the balanced stretch f (see `Balanced_energy`) at K, with K = U diag(s1, s2) V^T, and its
/// eigenvalues, of which negative ones are clamped (Smith, de Goes, Kim 2019); of two triangles.
///
/// The modes are products of U, V^T and the four matrices diag(1, 1), diag(1, -1), [0 -1; 1 0] and [0 1; 1 0]: the
/// first and third depend on the angle of U V^T alone, the others on that of the reflection. f mixes the first two.
class Hessian_modes
{
public:
  typedef Eigen::Array2d Numbers; // of both triangles

  /// symmetric 2 by 2 matrices
  struct Form
  {
    Numbers xx, xy, yy;
  };

  /// \param area_multiple the multiple of det(K) that is added to f
  Hessian_modes(const Jacobians& K, double balance, double area_multiple)
  {
    const Numbers turn_cos = (K.xx + K.yy) / 2, turn_sin = (K.yx - K.xy) / 2;
    const Numbers mirror_cos = (K.xx - K.yy) / 2, mirror_sin = (K.yx + K.xy) / 2;
    const Numbers mean = (turn_cos * turn_cos + turn_sin * turn_sin).sqrt(); // (s1 + s2) / 2
    const Numbers half_difference = (mirror_cos * mirror_cos + mirror_sin * mirror_sin).sqrt();
    m_turn = {turn_cos / mean, turn_sin / mean};
    m_mirror = {mirror_cos / half_difference, mirror_sin / half_difference};
    for(int i = 0; i < 2; ++i)
      if(!(half_difference[i] > 0))
        m_mirror.cos[i] = 1, m_mirror.sin[i] = 0;
    const Numbers s1 = mean + half_difference, determinant = K.xx * K.yy - K.yx * K.xy;
    const Numbers s2 = determinant / s1; // mean - half_difference would cancel
    const Numbers i1 = 1 / (s1 * s1), i2 = 1 / (s2 * s2), cubes = i1 * i2 / (s1 * s2);
    const Numbers zero(0, 0);
    m_twist = zero.max(2 * (balance - (s1 * s1 - s1 * s2 + s2 * s2) * cubes) + area_multiple);
    m_flip = zero.max(2 * (balance + (s1 * s1 + s1 * s2 + s2 * s2) * cubes) - area_multiple);
    const Numbers h11 = 6 * i1 * i1 + 2 * balance, h22 = 6 * i2 * i2 + 2 * balance;
    m_scaling = clamped({(h11 + h22) / 2 + area_multiple, (h11 - h22) / 2, (h11 + h22) / 2 - area_multiple});
  }

  /// the quadratic forms on the two rows of a change of K, times 2.
  ///
  /// With (c, s) the turn and (d, e) the mirror the modes have the rows (c, -s) and (s, c), (d, e) and (e, -d); twist and
  /// flip have these pairs of rows exchanged, but for signs.
  std::array<Form, 2> forms_on_rows() const
  {
    const auto& [c, s] = m_turn;
    const auto& [d, e] = m_mirror;
    const auto& [xx, xy, yy] = m_scaling;
    const Numbers even = xx * c * c + yy * d * d + m_twist * s * s + m_flip * e * e;
    const Numbers odd = xx * s * s + yy * e * e + m_twist * c * c + m_flip * d * d;
    const Numbers even_mixed = 2 * xy * c * d, odd_mixed = 2 * xy * s * e;
    const Numbers mixed = xy * (c * e - s * d);
    const Numbers across = (yy - m_flip) * d * e - (xx - m_twist) * c * s;
    return {
        {{even + even_mixed, mixed + across, odd - odd_mixed}, {odd + odd_mixed, mixed - across, even - even_mixed}}};
  }

private:
  /// of an angle
  struct Direction
  {
    Numbers cos, sin;
  };

  /// symmetric matrices with a positive eigenvalue, of which a negative one is replaced by zero
  static Form clamped(Form form)
  {
    auto& [xx, xy, yy] = form;
    const Numbers mean = (xx + yy) / 2, half = (xx - yy) / 2, radius = (half * half + xy * xy).sqrt();
    for(int i = 0; i < 2; ++i) {
      if(radius[i] <= mean[i])
        continue;
      const double x = half[i] + radius[i], y = xy[i]; // the direction of the larger eigenvalue; half > 0 here
      const double factor = (mean[i] + radius[i]) / (x * x + y * y);
      xx[i] = factor * x * x;
      xy[i] = factor * x * y;
      yy[i] = factor * y * y;
    }
    return form;
  }

  Direction m_turn, m_mirror;
  Numbers m_twist, m_flip;
  Form m_scaling;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_ENERGY_HESSIAN_MODES_H
