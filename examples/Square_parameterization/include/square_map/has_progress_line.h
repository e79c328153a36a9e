// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_HAS_PROGRESS_LINE_H
#define SQUARE_MAP_HAS_PROGRESS_LINE_H

#include <atomic>

namespace square_map {

/// indicates whether the terminal shows a line of `Progress`, behind which a message begins on a line of its own
inline std::atomic<bool> has_progress_line{false};

} // namespace square_map

#endif // SQUARE_MAP_HAS_PROGRESS_LINE_H
