// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_NUMBER_PER_AXIS_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_NUMBER_PER_AXIS_H

#include <Eigen/Core>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a number for u and one for v. All arithmetic is done with both, so that as a scalar of Eigen it makes of two
/// matrices with entries at the same places one: indices are read once, and both numbers are computed by the same
/// instructions.
class Number_per_axis
{
public:
  Number_per_axis(double both = 0) : m_numbers(both, both) {}
  Number_per_axis(double u, double v) : m_numbers(u, v) {}
  explicit Number_per_axis(const Eigen::Array2d& numbers) : m_numbers(numbers) {}

  double& operator[](int axis) { return m_numbers[axis]; }
  double operator[](int axis) const { return m_numbers[axis]; }

  Number_per_axis operator-() const { return Number_per_axis(-m_numbers); }
  Number_per_axis& operator+=(const Number_per_axis& other) { return *this = *this + other; }
  Number_per_axis& operator-=(const Number_per_axis& other) { return *this = *this - other; }
  Number_per_axis& operator*=(const Number_per_axis& other) { return *this = *this * other; }
  Number_per_axis& operator/=(const Number_per_axis& other) { return *this = *this / other; }

  friend Number_per_axis operator+(const Number_per_axis& a, const Number_per_axis& b)
  {
    return Number_per_axis(a.m_numbers + b.m_numbers);
  }
  friend Number_per_axis operator-(const Number_per_axis& a, const Number_per_axis& b)
  {
    return Number_per_axis(a.m_numbers - b.m_numbers);
  }
  friend Number_per_axis operator*(const Number_per_axis& a, const Number_per_axis& b)
  {
    return Number_per_axis(a.m_numbers * b.m_numbers);
  }
  friend Number_per_axis operator/(const Number_per_axis& a, const Number_per_axis& b)
  {
    return Number_per_axis(a.m_numbers / b.m_numbers);
  }
  friend bool operator==(const Number_per_axis& a, const Number_per_axis& b)
  {
    return (a.m_numbers == b.m_numbers).all();
  }
  friend bool operator!=(const Number_per_axis& a, const Number_per_axis& b) { return !(a == b); }

  /// see `Multifrontal_ldlt`
  friend bool is_pivot(const Number_per_axis& a) { return a.m_numbers.isFinite().all() && (a.m_numbers != 0).all(); }

private:
  Eigen::Array2d m_numbers;
};

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

/// \cond SKIP_IN_MANUAL
namespace Eigen {

template <>
struct NumTraits<CGAL_ext::internal::Number_per_axis> : NumTraits<double>
{
  typedef CGAL_ext::internal::Number_per_axis Real;
  typedef CGAL_ext::internal::Number_per_axis NonInteger;
  typedef CGAL_ext::internal::Number_per_axis Nested;
  enum
  {
    RequireInitialization = 1
  };
};

} // namespace Eigen
/// \endcond

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_MINIMIZATION_NUMBER_PER_AXIS_H
