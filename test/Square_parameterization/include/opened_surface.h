// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps from a surface and its cut to the disk that is mapped, one by one.

#ifndef CGAL_EXT_OPENED_SURFACE_H
#define CGAL_EXT_OPENED_SURFACE_H

#include <CGAL_ext/Square_parameterization/internal/cut/open_disk.h>

inline CGAL_ext::internal::Triangle_surface opened_surface(const CGAL_ext::internal::Triangle_surface& surface,
                                                           const CGAL_ext::internal::Cut& cut)
{
  return CGAL_ext::internal::opened_surface(surface, CGAL_ext::internal::cut_edits(surface, cut));
}

inline CGAL_ext::internal::Triangle_surface without_chords(const CGAL_ext::internal::Triangle_surface& surface)
{
  return split_surface_edges(surface, chords_of(surface, CGAL_ext::Chords::ALL));
}

/// with four border edges at least
inline CGAL_ext::internal::Triangle_surface with_long_border(const CGAL_ext::internal::Triangle_surface& surface)
{
  const auto longest = border_edge_to_split(surface);
  return longest ? split_surface_edges(surface, {*longest}) : surface;
}

#endif // CGAL_EXT_OPENED_SURFACE_H
