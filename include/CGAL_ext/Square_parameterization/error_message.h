// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_ERROR_MESSAGE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_ERROR_MESSAGE_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

namespace CGAL_ext {

/// \ingroup PkgSquareParameterizationResults
///
/// returns one sentence that says what an error code means. Never null. (The function of the same purpose in CGAL is
/// off by one from `ERROR_NO_TOPOLOGICAL_BALL` on.)
inline const char* error_message(CGAL::Surface_mesh_parameterization::Error_code code)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  switch(code) { // no default: a compiler warns when CGAL adds a code
  case SMP::OK:
    return "success";
  case SMP::ERROR_EMPTY_MESH:
    return "the mesh is empty";
  case SMP::ERROR_NON_TRIANGULAR_MESH:
    return "the mesh has a face that is not a triangle";
  case SMP::ERROR_NO_TOPOLOGICAL_DISC:
    return "the mesh is not a topological disk";
  case SMP::ERROR_NO_TOPOLOGICAL_BALL:
    return "the mesh is not a topological ball";
  case SMP::ERROR_BORDER_TOO_SHORT:
    return "the border has fewer vertices than the parameterization needs, or is none";
  case SMP::ERROR_NON_CONVEX_BORDER:
    return "the parameterization needs a convex border";
  case SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return "a linear system could not be solved";
  case SMP::ERROR_NO_1_TO_1_MAPPING:
    return "no one-to-one map was found";
  case SMP::ERROR_WRONG_PARAMETER:
    return "a parameter, or a coordinate of the mesh, is out of its range";
  }
  return "unknown error";
}

} // namespace CGAL_ext

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_ERROR_MESSAGE_H
