// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Part of the library CGAL_ext_core (see internal/common/compiled_core.h): the minimizers, with the weights and solvers of the iteration.

#include <CGAL_ext/Square_parameterization/internal/iteration/Stretch_iteration_impl.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/edge_weights_impl.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/linear_solvers_impl.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Balanced_minimizer_impl.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Multilevel_minimizer_impl.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_iteration_minimizer_impl.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/make_minimizer_impl.h>
