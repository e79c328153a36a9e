// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COMMAND_LINE_CLOSED_H
#define TEST_COMMAND_LINE_CLOSED_H

#include "closed_meshes.h"
#include "test_command_line_mesh.h"

/// a surface as a file holds it
inline Soup soup_of(const Closed_mesh& mesh)
{
  Soup soup;
  for(const Eigen::Vector3d& p : mesh.points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& [a, b, c] : mesh.triangles)
    soup.faces.push_back({a, b, c});
  return soup;
}

#endif // TEST_COMMAND_LINE_CLOSED_H
