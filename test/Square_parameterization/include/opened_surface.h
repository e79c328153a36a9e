// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps from a surface and its cut to the disk that is mapped, one by one.

#ifndef CGAL_EXT_OPENED_SURFACE_H
#define CGAL_EXT_OPENED_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>

#include <vector>

inline CGAL_ext::internal::Triangle_surface opened_surface(const CGAL_ext::internal::Triangle_surface& surface,
                                                           const CGAL_ext::internal::Cut& cut)
{
  const CGAL_ext::internal::Surface_edits edits = CGAL_ext::internal::cut_edits(surface, cut);
  return edits.seams.empty()
             ? surface
             : CGAL_ext::internal::make_triangle_surface(points_after(edits, surface.points), edits.opened);
}

inline CGAL_ext::internal::Numbered_triangles numbered(const CGAL_ext::internal::Triangle_surface& surface)
{
  return {surface.number_of_vertices(), surface.triangles, numbering_of(surface)};
}

inline CGAL_ext::internal::Triangle_surface with_edges_split(const CGAL_ext::internal::Triangle_surface& surface,
                                                             const std::vector<int>& edges)
{
  CGAL_ext::internal::Surface_edits edits;
  for(int e : edges)
    edits.splits.push_back(surface.edges[e]);
  return CGAL_ext::internal::make_triangle_surface(points_after(edits, surface.points),
                                                   split_edges(numbered(surface), edges).triangles);
}

inline CGAL_ext::internal::Triangle_surface without_chords(const CGAL_ext::internal::Triangle_surface& surface)
{
  return with_edges_split(surface, chords_of(numbered(surface), CGAL_ext::Chords::ALL));
}

/// with four border edges at least
inline CGAL_ext::internal::Triangle_surface with_long_border(const CGAL_ext::internal::Triangle_surface& surface)
{
  const auto longest = border_edge_to_split(numbered(surface), [&surface] { return surface.points; });
  return longest ? with_edges_split(surface, {*longest}) : surface;
}

#endif // CGAL_EXT_OPENED_SURFACE_H
