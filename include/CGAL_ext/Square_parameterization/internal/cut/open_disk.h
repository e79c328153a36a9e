// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_DISK_H

#include <CGAL_ext/Square_parameterization/internal/cut/cut_open.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_edits.h>
#include <CGAL_ext/Square_parameterization/internal/surface/split_surface_edges.h>

#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a surface that has been made a disk ready to be mapped, and how
struct Opened_disk
{
  Triangle_surface surface;
  Surface_edits edits;
};

/// the points of the disk, made of those of the uncut surface as `apply_edits()` makes them
inline std::vector<Eigen::Vector3d> points_after(const Surface_edits& edits, std::vector<Eigen::Vector3d> points)
{
  for(int original : edits.copies)
    points.push_back(Eigen::Vector3d(points[original]));
  for(const auto& [a, b] : edits.splits)
    points.push_back(Eigen::Vector3d(points[a] / 2 + points[b] / 2));
  return points;
}

/// the surface cut open, with adjacency of its own
inline Triangle_surface opened_surface(Triangle_surface surface, const Surface_edits& edits)
{
  return edits.seams.empty() ? std::move(surface)
                             : make_triangle_surface(points_after(edits, std::move(surface.points)), edits.opened);
}

/// splits edges of the disk at their midpoints
inline void split_edges(const std::vector<int>& edges, Opened_disk& disk)
{
  for(int e : edges)
    disk.edits.splits.push_back(disk.surface.edges[e]);
  disk.surface = split_surface_edges(std::move(disk.surface), edges);
}

/// the edits that cut a surface open
inline Surface_edits cut_edits(const Triangle_surface& surface, const Cut& cut)
{
  Surface_edits edits;
  for(int e : cut.edges())
    edits.seams.push_back(surface.edges[e]);
  if(edits.seams.empty())
    return edits;
  Opened_triangles opened = cut_open(surface, cut);
  edits.opened = std::move(opened.triangles);
  edits.copies.assign(opened.originals.begin() + surface.number_of_vertices(), opened.originals.end());
  return edits;
}

/// cuts the surface open, gives a border of three edges a fourth, and splits chords
/// \pre the complement of the cut is a disk
inline Opened_disk open_disk(Triangle_surface surface, const Cut& cut, Chords chords)
{
  Opened_disk disk{std::move(surface), {}};
  disk.edits = cut_edits(disk.surface, cut);
  disk.surface = opened_surface(std::move(disk.surface), disk.edits);
  if(const std::optional<int> longest = border_edge_to_split(disk.surface)) {
    split_edges({*longest}, disk);
    disk.edits.border_splits = 1;
  }
  split_edges(chords_of(disk.surface, chords), disk);
  return disk;
}

/// the disk as a patch with the given points; its border begins at the lowest border vertex. Throws `Unmappable` as
/// `make_patch()`, also for a sphere that is cut along one edge alone: its border of two vertices is none.
inline Patch patch_of_disk(Triangle_surface disk, std::vector<Eigen::Vector3d> points)
{
  Edge_numbering numbering = numbering_of(disk);
  return make_patch(std::move(points), std::move(disk.triangles),
                    disk.border_loops.empty() ? std::vector<int>() : std::move(disk.border_loops.front()),
                    std::move(numbering));
}

/// the patch that the surface is with a cut
inline Patch patch_of_cut(const Triangle_surface& surface, const Cut& cut)
{
  Opened_disk disk = open_disk(surface, cut, Chords::ALL);
  std::vector<Eigen::Vector3d> points = std::move(disk.surface.points);
  return patch_of_disk(std::move(disk.surface), std::move(points));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_DISK_H
