// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_PAGE_TEMPLATE_H
#define SQUARE_MAP_PAGE_TEMPLATE_H

#include <string_view>

namespace square_map {

// The page of `--report`, put together by CMake from the folder page/ and from three.js, before and after its data.

std::string_view page_before_data();
std::string_view page_after_data();

} // namespace square_map

#endif // SQUARE_MAP_PAGE_TEMPLATE_H
