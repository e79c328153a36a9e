// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_COMPILED_CORE_H
#define CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_COMPILED_CORE_H

// The package is header-only by default: a header `x.h` whose functions cost much to compile includes their
// definitions, which stand beside it in `x_impl.h`. With CGAL_EXT_COMPILED_CORE defined the declarations alone are
// seen, and the definitions are those of the library CGAL_ext_core, which is made of the same files: compiled once, for
// all programs that link with it. Both ways the functions are the same.

/// stands before the definition of a function in an `_impl.h`
#ifdef CGAL_EXT_COMPILED_CORE
#define CGAL_EXT_INLINE_FUNCTION
#else
#define CGAL_EXT_INLINE_FUNCTION inline
#endif

#endif // CGAL_EXT_SQUARE_PARAMETERIZATION_INTERNAL_COMMON_COMPILED_CORE_H
