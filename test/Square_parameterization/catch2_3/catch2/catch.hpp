// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_CATCH2_3_CATCH_HPP
#define TEST_CATCH2_3_CATCH_HPP

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_predicate.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

// What the tests, which are written for Catch2 2, have of it under other names in Catch2 3.

using Catch::Approx;
using Catch::Matchers::Predicate;

namespace Catch {
namespace Matchers {

inline StringContainsMatcher Contains(const std::string& text)
{
  return ContainsSubstring(text);
}

} // namespace Matchers

using Matchers::Contains;

} // namespace Catch

#endif // TEST_CATCH2_3_CATCH_HPP
