// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Included after the other includes of a header; `enable_warnings.h` ends what it begins, as the headers of the same
// names do in CGAL. No include guard: each header needs it anew.
//
// Vertices, edges and faces are numbered by `int`, as rows are by Eigen, and -1 stands for none. Clang takes such a
// number in the brackets of a vector for a possible mistake where -Wconversion is asked for (g++ does not); casts in
// every bracket would hide what is computed.
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wsign-conversion"
#endif
