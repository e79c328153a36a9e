// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_DISK_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_DISK_H

#include <CGAL_ext/Square_parameterization/internal/cut/cut_open.h>
#include <CGAL_ext/Square_parameterization/internal/patch/Patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/Surface_edits.h>
#include <CGAL_ext/Square_parameterization/internal/surface/make_disk_patch.h>
#include <CGAL_ext/Square_parameterization/internal/surface/split_edges.h>

#include <optional>
#include <utility>
#include <vector>

#include <CGAL_ext/Square_parameterization/internal/common/disable_warnings.h>

namespace CGAL_ext {
namespace internal {

/// a surface that has been made a disk ready to be mapped, and how
struct Opened_disk
{
  Numbered_triangles triangles;
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

/// the triangles of the surface when it is cut open
inline Numbered_triangles opened_triangles(const Triangle_surface& surface, const Surface_edits& edits)
{
  const int vertices = surface.number_of_vertices() + static_cast<int>(edits.copies.size());
  return edits.seams.empty() ? Numbered_triangles(vertices, surface.triangles, numbering_of(surface))
                             : Numbered_triangles(vertices, edits.opened);
}

/// splits edges of the disk at their midpoints
inline void split_edges(const std::vector<int>& edges, Opened_disk& disk)
{
  for(int e : edges)
    disk.edits.splits.push_back(disk.triangles.numbering.edges[e]);
  disk.triangles = split_edges(std::move(disk.triangles), edges);
}

/// cuts the surface open, gives a border of three edges a fourth, and splits chords
/// \pre the complement of the cut is a disk
inline Opened_disk open_disk(const Triangle_surface& surface, const Cut& cut, Chords chords)
{
  Surface_edits edits = cut_edits(surface, cut);
  Opened_disk disk{opened_triangles(surface, edits), std::move(edits)};
  const auto points = [&] { return points_after(disk.edits, surface.points); };
  if(const std::optional<int> longest = border_edge_to_split(disk.triangles, points)) {
    split_edges({*longest}, disk);
    disk.edits.border_splits = 1;
  }
  split_edges(chords_of(disk.triangles, chords), disk);
  return disk;
}

/// the disk as a patch with the given points; its border begins at the lowest border vertex. Throws `Unmappable` as
/// `make_patch()`, also for a sphere that is cut along one edge alone: its border of two vertices is none.
inline Patch patch_of_disk(Numbered_triangles disk, std::vector<Eigen::Vector3d> points)
{
  const std::vector<int> border_edges = disk.border_edges();
  const int lowest = border_edges.empty() ? -1 : disk.numbering.edges[border_edges.front()][0];
  std::vector<int> border = border_from(lowest, points.size(), disk.triangles, disk.numbering);
  return make_patch(std::move(points), std::move(disk.triangles), std::move(border), std::move(disk.numbering));
}

/// the patch that the surface is with a cut
inline Patch patch_of_cut(const Triangle_surface& surface, const Cut& cut)
{
  Opened_disk disk = open_disk(surface, cut, Chords::ALL);
  return patch_of_disk(std::move(disk.triangles), points_after(disk.edits, surface.points));
}

} // namespace internal
} // namespace CGAL_ext

#include <CGAL_ext/Square_parameterization/internal/common/enable_warnings.h>

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_CUT_OPEN_DISK_H
