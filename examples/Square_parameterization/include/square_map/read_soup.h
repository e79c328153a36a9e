// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_SOUP_H
#define SQUARE_MAP_READ_SOUP_H

#include "File_format.h"
#include "Malformed_file.h"
#include "Passed_over.h"
#include "Vertex_colors.h"

#include <CGAL_ext/Square_parameterization/internal/soup/Surface_soup.h>

#include <string>
#include <string_view>

namespace square_map {

// The definitions are in src/square_map/read_soup.cpp: the readers of all formats are compiled once.

/// reads points and polygons of a text, by the reader of its format
/// \throw Malformed_file with the reason alone
CGAL_ext::internal::Surface_soup parse_soup(std::string_view text, File_format format, Passed_over& passed_over,
                                            Vertex_colors* colors = nullptr);

/// refuses coordinates that are not finite and faces that have too few vertices or name one that does not exist
/// \throw Malformed_file with the reason alone
void check_well_formed(const CGAL_ext::internal::Surface_soup& soup);

/// reads points and polygons of a file or a pipe, which are well formed; "-" is standard input
/// \param format_name the format, in place of what the extension says; empty for none
/// \param passed_over what of the file was not used is added, unless it is null
/// \param colors receives the colors of the vertices, unless it is null; none for a file that has none
CGAL_ext::internal::Surface_soup read_soup(const std::string& path, const std::string& format_name = "",
                                           Passed_over* passed_over = nullptr, Vertex_colors* colors = nullptr);

} // namespace square_map

#endif // SQUARE_MAP_READ_SOUP_H
