// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_UNMAPPABLE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_UNMAPPABLE_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <stdexcept>
#include <string>

namespace CGAL_ext {
namespace internal {

using CGAL::Surface_mesh_parameterization::Error_code;

/// thrown inside the package when a surface cannot be mapped; carries CGAL's error code and one sentence that
/// names the condition and the place. Public functions catch it and return the code: no exception leaves the package.
class Unmappable : public std::runtime_error
{
public:
  Unmappable(Error_code code, const std::string& message) : std::runtime_error(message), m_code(code) {}

  Error_code code() const { return m_code; }

private:
  Error_code m_code;
};

} // namespace internal
} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_UNMAPPABLE_H
