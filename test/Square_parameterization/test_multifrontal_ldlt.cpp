// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The multifrontal factorization against Eigen's, on random matrices and on those of patches.

#include "make_patch_of.h"
#include "map_cases.h"
#include "weight_cases.h"

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Convex_combination_system.h>
#include <CGAL_ext/Square_parameterization/internal/iteration/Multifrontal_ldlt.h>
#include <CGAL_ext/Square_parameterization/internal/minimization/Axis_matrix.h>

#include <Eigen/SparseCholesky>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <set>
#include <utility>
#include <vector>

using namespace CGAL_ext;
using namespace CGAL_ext::internal;

namespace {

using Eigen_ldlt = Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int>>;

/// the upper triangle of a symmetric matrix with about so many entries per row beside the diagonal, which dominates. A
/// third of the diagonal is negative unless the matrix is to be definite.
Sparse_matrix random_matrix(int n, double row_entries, bool is_definite, Random_numbers& random)
{
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> sum(n, 1);
  for(int k = 0; k < row_entries * n / 2; ++k) {
    const int i = random.below(n), j = random.below(n);
    if(i == j)
      continue;
    entries.emplace_back((std::min)(i, j), (std::max)(i, j), random(-1, 1));
    sum[i] += std::abs(entries.back().value());
    sum[j] += std::abs(entries.back().value());
  }
  for(int i = 0; i < n; ++i)
    entries.emplace_back(i, i, is_definite || i % 3 != 0 ? sum[i] : -sum[i]);
  Sparse_matrix upper(n, n);
  upper.setFromTriplets(entries.begin(), entries.end());
  return upper;
}

/// factors and solves, and compares with Eigen and with the equations
void check_factorization(const Sparse_matrix& upper, Multifrontal_ldlt<double>& ldlt, Random_numbers& random)
{
  const Right_hand_sides b = Right_hand_sides::NullaryExpr(upper.rows(), 2, [&] { return random(-1, 1); });
  ldlt.factorize(upper);
  REQUIRE(ldlt.info() == Eigen::Success);
  const Right_hand_sides x = ldlt.solve(b), expected = Eigen_ldlt(upper).solve(b);
  CHECK((x - expected).cwiseAbs().maxCoeff() < 1e-12 * expected.cwiseAbs().maxCoeff());
  const auto residual = [&](const Right_hand_sides& solution) {
    const Right_hand_sides left = upper.selfadjointView<Eigen::Upper>() * solution - b;
    return left.cwiseAbs().maxCoeff();
  };
  CHECK(residual(x) < 3 * residual(expected) + 1e-14); // what rounding leaves depends on the matrix
}

/// patches whose systems have from one unknown to some thousand
std::vector<Patch> patches_to_factor()
{
  return {make_patch_of(saddle(2)), make_patch_of(cone(3)), make_patch_of(hemisphere()),
          make_patch_of(noisy_height_field(65))};
}

/// the columns that have entries in each column of the factor, from dense elimination of the pattern alone
std::vector<std::set<int>> dense_elimination(const Sparse_matrix& upper, const std::vector<int>& places)
{
  std::vector<std::set<int>> rows(upper.cols());
  for(int k = 0; k < upper.cols(); ++k)
    for(Sparse_matrix::InnerIterator entry(upper, k); entry; ++entry) {
      const auto [i, j] = std::minmax(places[entry.row()], places[k]);
      rows[i].insert(j);
    }
  for(std::size_t j = 0; j < rows.size(); ++j)
    for(const int i : rows[j])
      if(i > int(j))
        rows[i].insert(rows[j].lower_bound(i), rows[j].end());
  return rows;
}

} // namespace

TEST_CASE("the multifrontal factorization solves what Eigen's solves, whatever the pattern")
{
  Random_numbers random(1);
  for(const int n : {1, 2, 3, 5, 17, 64, 200})
    for(const double row_entries : {0., 0.7, 2., 4., 30.}) // from diagonal and separate trees to nearly dense
      for(const bool is_definite : {true, false}) {
        CAPTURE(n, row_entries, is_definite);
        const Sparse_matrix upper = random_matrix(n, row_entries, is_definite, random);
        Multifrontal_ldlt<double> ldlt;
        ldlt.analyzePattern(upper);
        check_factorization(upper, ldlt, random);
      }
}

TEST_CASE("the multifrontal factorization solves the systems of patches, one after the other")
{
  Random_numbers random(2);
  for(const Patch& patch : patches_to_factor())
    for(const Weight_case& weight_case : all_weights()) {
      const Edge_weights weights = weight_case.weights(patch);
      if(!weights.is_symmetric)
        continue;
      CAPTURE(weight_case.name, patch.number_of_vertices());
      const Convex_combination_system system(patch, weights);
      Convex_combination_system::Equations equations;
      std::vector<double> factors(patch.points.size(), 1.);
      Multifrontal_ldlt<double> ldlt;
      for(int repetition = 0; repetition < 3; ++repetition) {
        system.assemble(factors, square_border_of(patch, 0), equations);
        if(repetition == 0)
          ldlt.analyzePattern(equations.matrix);
        check_factorization(equations.matrix, ldlt, random);
        Multifrontal_ldlt<double> copy = ldlt;
        const Right_hand_sides b = equations.right_hand_sides;
        copy.factorize(equations.matrix);
        CHECK(copy.solve(b) == ldlt.solve(b));
        for(double& factor : factors)
          factor *= random(0.5, 2);
      }
    }
}

TEST_CASE("the multifrontal factorization of two matrices of one pattern solves both, and fails where one is singular")
{
  Random_numbers random(4);
  for(const int n : {1, 3, 4, 5, 60, 300})
    for(const double row_entries : {0., 3., 30.}) {
      CAPTURE(n, row_entries);
      const Sparse_matrix u = random_matrix(n, row_entries, true, random);
      Sparse_matrix v = u;
      for(int j = 0; j < n; ++j)
        for(Sparse_matrix::InnerIterator entry(v, j); entry; ++entry)
          entry.valueRef() *= entry.row() == j ? random(1, 2) : random(-1, 1);
      Axis_matrix::Matrix both = u.cast<Number_per_axis>();
      const Right_hand_sides b = Right_hand_sides::NullaryExpr(n, 2, [&] { return random(-1, 1); });
      Axis_matrix::Vector right_hand_side(n);
      for(int i = 0; i < n; ++i)
        right_hand_side[i] = {b(i, 0), b(i, 1)};
      for(int k = 0; k < both.nonZeros(); ++k)
        both.valuePtr()[k] = {u.valuePtr()[k], v.valuePtr()[k]};
      Multifrontal_ldlt<Number_per_axis> ldlt;
      ldlt.analyzePattern(both);
      ldlt.factorize(both);
      REQUIRE(ldlt.info() == Eigen::Success);
      const Axis_matrix::Vector x = ldlt.solve(right_hand_side);
      const std::array<Eigen::VectorXd, 2> expected{Eigen_ldlt(u).solve(b.col(0)), Eigen_ldlt(v).solve(b.col(1))};
      for(int i = 0; i < n; ++i)
        for(int axis = 0; axis < 2; ++axis)
          CHECK(std::abs(x[i][axis] - expected[axis][i]) < 1e-12 * expected[axis].cwiseAbs().maxCoeff());
      for(int axis = 0; axis < 2; ++axis)
        for(const double value : {0., std::numeric_limits<double>::quiet_NaN()}) {
          Axis_matrix::Matrix bad = both;
          for(int k = 0; k < bad.nonZeros(); ++k)
            bad.valuePtr()[k][axis] *= value;
          ldlt.factorize(bad);
          CHECK(ldlt.info() == Eigen::NumericalIssue);
        }
    }
}

TEST_CASE("a pivot that is zero or not finite ends the factorization, and the next one succeeds")
{
  Random_numbers random(3);
  const Sparse_matrix upper = random_matrix(50, 4, true, random);
  Multifrontal_ldlt<double> ldlt;
  ldlt.analyzePattern(upper);
  for(const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for(const int i : {0, 20, 49}) {
      Sparse_matrix bad = upper;
      bad.coeffRef(i, i) = value;
      ldlt.factorize(bad);
      CHECK(ldlt.info() == Eigen::NumericalIssue);
    }
  ldlt.factorize(0 * upper);
  CHECK(ldlt.info() == Eigen::NumericalIssue);
  check_factorization(upper, ldlt, random);
}

TEST_CASE("a matrix in which some entries have changed is factored as if all had, also after a failure")
{
  Random_numbers random(9);
  std::vector<Sparse_matrix> matrices;
  for(const int n : {1, 5, 60, 300})
    for(const double row_entries : {0., 3., 30.})
      matrices.push_back(random_matrix(n, row_entries, true, random));
  for(const int cells : {20, 65, 90}) {
    const Patch patch = make_patch_of(noisy_height_field(cells));
    const Convex_combination_system system(patch, Uniform_weights()(patch));
    Convex_combination_system::Equations equations;
    system.assemble(std::vector<double>(patch.points.size(), 1.), square_border_of(patch, 0), equations);
    matrices.push_back(equations.matrix);
    const Elimination_fronts fronts(equations.matrix);
    CHECK((fronts.parts().size() > 1) == (cells >= 65));
  }
  for(Sparse_matrix& upper : matrices) {
    CAPTURE(upper.rows(), upper.nonZeros());
    const Right_hand_sides b = Right_hand_sides::NullaryExpr(upper.rows(), 2, [&] { return random(-1, 1); });
    Multifrontal_ldlt<double> changing;
    changing.analyzePattern(upper);
    changing.factorize(upper);
    const auto change = [&](int entry, double value) {
      upper.valuePtr()[entry] = value;
      changing.refactorize(upper, {entry});
    };
    for(int repetition = 0; repetition < 5; ++repetition) {
      const int entry = random.below(static_cast<int>(upper.nonZeros()));
      change(entry, random(0.9, 1.1) * upper.valuePtr()[entry]);
      REQUIRE(changing.info() == Eigen::Success);
      Multifrontal_ldlt<double> afresh;
      afresh.analyzePattern(upper);
      afresh.factorize(upper);
      CHECK(changing.solve(b) == afresh.solve(b));
      const double value = upper.valuePtr()[0]; // that of the first row on the diagonal
      change(0, std::numeric_limits<double>::infinity());
      CHECK(changing.info() == Eigen::NumericalIssue);
      change(0, value);
      CHECK(changing.solve(b) == afresh.solve(b));
    }
  }
}

TEST_CASE("fronts hold the factor, children lie before their parents, and rows are found in the parent")
{
  for(const Patch& patch : patches_to_factor()) {
    const Convex_combination_system system(patch, Uniform_weights()(patch));
    Convex_combination_system::Equations equations;
    system.assemble(std::vector<double>(patch.points.size(), 1.), square_border_of(patch, 0), equations);
    const Elimination_fronts fronts(equations.matrix);
    const std::vector<std::set<int>> rows_of_column = dense_elimination(equations.matrix, fronts.places());
    const int columns = static_cast<int>(equations.matrix.cols());
    const auto row_itself = [&](int row) {
      while(row >= columns)
        row = fronts.originals()[row - columns];
      return row;
    };
    std::size_t in_factor = 0, in_fronts = 0;
    int first = 0;
    for(std::size_t f = 0; f < fronts.fronts().size(); ++f) {
      const Elimination_front& front = fronts.fronts()[f];
      const auto begin = fronts.rows().begin() + front.rows;
      std::vector<int> rows;
      std::transform(begin, begin + front.height, std::back_inserter(rows), row_itself);
      CHECK(front.first == first);
      CHECK(std::is_sorted(rows.begin(), rows.end()));
      for(int j = 0; j < front.width; ++j) {
        CHECK(rows[j] == front.first + j);
        const std::set<int>& needed = rows_of_column[front.first + j];
        CHECK(std::includes(rows.begin(), rows.end(), needed.begin(), needed.end()));
        in_factor += needed.size();
        in_fronts += front.height - j;
      }
      CHECK((front.parent < 0) == (front.height == front.width));
      for(int i = front.width; i < front.height; ++i) {
        const Elimination_front& parent = fronts.fronts()[front.parent];
        CHECK(front.parent > int(f));
        CHECK(row_itself(fronts.rows()[parent.rows + fronts.rows_in_parent()[front.rows + i]]) == rows[i]);
      }
      first += front.width;
    }
    CHECK(first == equations.matrix.cols());
    CHECK(in_fronts <= 2 * in_factor + 1000); // few zeros are stored
  }
}

TEST_CASE("fronts of a band cost hardly more than those of its best division")
{
  constexpr int n = 400;
  for(int band : {1, 2, 5, 20}) {
    const auto front_cost = [&](int width, int last) {
      return cost_of_front(width, width + (std::min)(band, n - 1 - last));
    };
    std::vector<double> least(n + 1, std::numeric_limits<double>::infinity()); // of the first columns
    least[0] = 0;
    for(int end = 1; end <= n; ++end)
      for(int width = 1; width <= end; ++width)
        least[end] = (std::min)(least[end], least[end - width] + front_cost(width, end - 1));
    Column_tree tree;
    for(int j = 0; j < n; ++j) {
      tree.parent.push_back(j + 1 < n ? j + 1 : -1);
      tree.rows_below.push_back((std::min)(band, n - 1 - j));
    }
    const std::vector<int> last = merged_columns(tree);
    double cost = 0;
    for(int j = 0; j < n; j = last[j] + 1)
      cost += front_cost(last[j] - j + 1, last[j]);
    INFO(band);
    CHECK(cost >= (1 - 1e-12) * least[n]);
    CHECK(cost <= 1.05 * least[n]);
  }
}

TEST_CASE("parts of the fronts share neither rows nor numbers, and come before those above them")
{
  std::size_t divided = 0;
  for(const Patch& patch : patches_to_factor()) {
    const Convex_combination_system system(patch, Uniform_weights()(patch));
    Convex_combination_system::Equations equations;
    system.assemble(std::vector<double>(patch.points.size(), 1.), square_border_of(patch, 0), equations);
    const Elimination_fronts fronts(equations.matrix);
    divided += fronts.stages().size() > 3 ? 1 : 0;
    std::vector<int> part_of(fronts.fronts().size(), -1), stage_of;
    for(std::size_t stage = 0; stage + 1 < fronts.stages().size(); ++stage)
      stage_of.resize(fronts.stages()[stage + 1], static_cast<int>(stage));
    REQUIRE(stage_of.size() == fronts.parts().size());
    for(std::size_t p = 0; p < fronts.parts().size(); ++p)
      for(int f : fronts.parts()[p].fronts) {
        CHECK(part_of[f] == -1);
        part_of[f] = static_cast<int>(p);
      }
    CHECK(std::count(part_of.begin(), part_of.end(), -1) == 0);
    std::vector<int> part_of_row(equations.matrix.cols() + fronts.originals().size(), -1);
    std::vector<std::pair<std::size_t, std::size_t>> numbers; // of the factor
    for(std::size_t f = 0; f < part_of.size(); ++f) {
      const Elimination_front& front = fronts.fronts()[f];
      if(front.parent >= 0 && part_of[front.parent] != part_of[f]) {
        CHECK(part_of[front.parent] == fronts.parts()[part_of[f]].parent);
        CHECK(stage_of[part_of[front.parent]] > stage_of[part_of[f]]);
      }
      numbers.emplace_back(front.values, front.values + front.factor_size());
      for(int i = 0; i < front.height; ++i) {
        int& part = part_of_row[fronts.rows()[front.rows + i]];
        CHECK((part == -1 || part == part_of[f]));
        part = part_of[f];
      }
    }
    std::sort(numbers.begin(), numbers.end());
    for(std::size_t f = 1; f < numbers.size(); ++f)
      CHECK(numbers[f - 1].second <= numbers[f].first);
  }
  CHECK(divided == 1);
}

TEST_CASE("separate systems are divided when they are large together, and not when they are small")
{
  Random_numbers random(9);
  const auto repeated = [](const Sparse_matrix& matrix, int times) { // along the diagonal
    std::vector<Eigen::Triplet<double>> entries;
    for(int i = 0; i < times; ++i)
      for(int k = 0; k < matrix.cols(); ++k)
        for(Sparse_matrix::InnerIterator entry(matrix, k); entry; ++entry)
          entries.emplace_back(i * matrix.rows() + entry.row(), i * matrix.rows() + k, entry.value());
    Sparse_matrix result(times * matrix.rows(), times * matrix.rows());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  };
  const Sparse_matrix one = random_matrix(100, 8, true, random);
  for(const int times : {1, 3, 60}) {
    CAPTURE(times);
    const Sparse_matrix upper = repeated(one, times);
    const std::size_t parts = Elimination_fronts(upper).parts().size();
    CHECK((parts == 1) == (times < 60));
    Multifrontal_ldlt<double> ldlt;
    ldlt.analyzePattern(upper);
    check_factorization(upper, ldlt, random);
  }
}

TEST_CASE("the multifrontal factorization gives the same numbers for any number of threads, and fails in any part")
{
  const Patch patch = make_patch_of(noisy_height_field(90));
  Random_numbers random(8);
  const Convex_combination_system system(patch, Uniform_weights()(patch));
  Convex_combination_system::Equations equations;
  std::vector<double> factors(patch.points.size());
  for(double& factor : factors)
    factor = random(0.5, 2);
  system.assemble(factors, square_border_of(patch, 0), equations);
  Multifrontal_ldlt<double> alone;
  alone.analyzePattern(equations.matrix);
  alone.factorize(equations.matrix);
  const Right_hand_sides b = equations.right_hand_sides, x = alone.solve(b);
  for(const unsigned int threads : {2u, 3u, 8u}) {
    Thread_team team(threads);
    const Thread_team::Scope scope(team);
    Multifrontal_ldlt<double> on_threads;
    on_threads.analyzePattern(equations.matrix);
    on_threads.factorize(equations.matrix);
    REQUIRE(on_threads.info() == Eigen::Success);
    CHECK(on_threads.solve(b) == x);
    for(const int column : {0, 1000, 4000, 7743}) {
      Sparse_matrix singular = equations.matrix;
      for(int k = 0; k < singular.cols(); ++k)
        for(Sparse_matrix::InnerIterator entry(singular, k); entry; ++entry)
          if(entry.row() == column || k == column)
            entry.valueRef() = 0;
      on_threads.factorize(singular);
      CHECK(on_threads.info() == Eigen::NumericalIssue);
    }
  }
}
