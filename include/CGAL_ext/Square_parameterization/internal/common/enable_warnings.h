// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Ends what `disable_warnings.h` began. No include guard: each header needs it anew.
#if defined(__clang__)
#pragma clang diagnostic pop
#endif
