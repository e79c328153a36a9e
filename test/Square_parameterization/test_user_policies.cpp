// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a user may plug in: searches, base weights, solvers, visitors and callbacks, each written from its page in the
// reference alone.

#include "Thread_watcher.h"
#include "make_patch_of.h"
#include "mesh_types.h"
#include "square_map_case.h"

#include <CGAL_ext/Square_parameterization/Bracketing_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Brute_force_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Hybrid_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimizing_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_optimal_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/base_weights.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

using namespace CGAL_ext;

namespace {

typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
typedef Surface_mesh::Property_map<vertex_descriptor, Point_2> Uv_map;

/// what the concept CornerSearch asks for, and nothing more: no default constructor, no assignment. Asks for one
/// candidate, counted from the end of the border when it is negative.
class One_candidate_corner_search
{
public:
  explicit One_candidate_corner_search(int candidate) : m_candidate(candidate) {}
  One_candidate_corner_search(const One_candidate_corner_search&) = default;
  One_candidate_corner_search& operator=(const One_candidate_corner_search&) = delete;

  Candidate_set candidate_set() const { return Candidate_set::FULL; }

  void operator()(const Corner_search_problem& problem) const
  {
    problem.objective_of({m_candidate < 0 ? problem.number_of_candidates + m_candidate : m_candidate});
  }

private:
  int m_candidate;
};

/// does what it is told
struct Any_corner_search
{
  Candidate_set candidate_set() const { return Candidate_set::FULL; }

  void operator()(const Corner_search_problem& problem) const { ask(problem); }

  std::function<void(const Corner_search_problem&)> ask;
};

template <class Search>
using Border_with = Square_border_corner_search_parameterizer_3<Surface_mesh, Search>;

Surface_mesh bent_mesh()
{
  return make_mesh<Surface_mesh>(noisy_height_field(7));
}

/// the status of mapping, and whether anything was written: the map is filled with a point that no map has
template <class Parameterizer>
std::pair<SMP::Error_code, bool> status_and_writing(Surface_mesh& mesh, const Parameterizer& parameterizer)
{
  const Point_2 nowhere(-7, -7);
  Uv_map uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
  for(vertex_descriptor v : mesh.vertices())
    uvmap[v] = nowhere;
  const SMP::Error_code status = SMP::parameterize(mesh, parameterizer, first_border_halfedge_of(mesh), uvmap);
  bool is_written = false;
  for(vertex_descriptor v : mesh.vertices())
    is_written = is_written || uvmap[v] != nowhere;
  return {status, is_written};
}

/// checks that a border is refused, without a trace, by the parameterizers of this package and of CGAL
template <class Border>
void check_refused(const Border& border)
{
  Surface_mesh mesh = bent_mesh();
  const std::pair<SMP::Error_code, bool> refused(SMP::ERROR_WRONG_PARAMETER, false);
  CHECK(status_and_writing(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(border)) == refused);
  CHECK(status_and_writing(mesh, Stretch_optimal_parameterizer_3<Surface_mesh, Border>(border)) == refused);
  CHECK(status_and_writing(mesh, SMP::Mean_value_coordinates_parameterizer_3<Surface_mesh, Border>(border)) == refused);
}

} // namespace

TEST_CASE("the named border parameterizers are the general one with their searches")
{
  typedef Surface_mesh Mesh;
  CHECK(std::is_same_v<Brute_force_square_border_parameterizer_3<Mesh>, Border_with<Brute_force_corner_search>>);
  CHECK(std::is_same_v<Bracketing_square_border_parameterizer_3<Mesh>, Border_with<Bracketing_corner_search>>);
  CHECK(std::is_same_v<Border_with<CGAL::Default>::Corner_search, Hybrid_corner_search>);
  // every argument may be left out, also with braces
  const Square_search_options options;
  Surface_mesh mesh = bent_mesh();
  typedef Stretch_minimizing_parameterizer_3<Mesh, Border_with<CGAL::Default>> By_default;
  typedef Hybrid_square_border_parameterizer_3<Mesh> Hybrid;
  typedef Stretch_minimizing_parameterizer_3<Mesh, Hybrid> By_name;
  CHECK(parameterize(mesh, By_default()).uv == parameterize(mesh, By_name(Hybrid({}, options, {}))).uv);
}

TEST_CASE("a search of a user works in CGAL's parameterize(), with the parameterizers of this package and of CGAL")
{
  typedef Border_with<One_candidate_corner_search> Border;
  Surface_mesh mesh = bent_mesh();
  const int candidates = 4 * 7;
  for(int candidate : {0, 5, candidates - 1}) {
    Recording_visitor visitor;
    Square_search_options options;
    options.visitor = &visitor;
    const Border border(One_candidate_corner_search(candidate), options);
    CHECK(is_one_to_one(parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(border)),
                        mesh.number_of_faces()));
    CHECK(is_one_to_one(parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh, Border>(border)),
                        mesh.number_of_faces()));
    typedef SMP::Mean_value_coordinates_parameterizer_3<Surface_mesh, Border> Mean_value;
    CHECK(is_one_to_one(parameterize(mesh, Mean_value(border)), mesh.number_of_faces()));
    REQUIRE(visitor.searches.size() == 3);
    for(const Search_report& report : visitor.searches)
      CHECK((report.best_candidate == candidate && report.evaluations == 1 && report.candidates == candidates));
  }
}

TEST_CASE("a search chosen at run time is a search like any other")
{
  Surface_mesh mesh = bent_mesh();
  typedef Border_with<Corner_search> Any;
  typedef Border_with<Bracketing_corner_search> Bracketing;
  const Any any(Corner_search(Bracketing_corner_search(4)));
  const Bracketing bracketing(Bracketing_corner_search(4));
  CHECK(parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh, Any>(any)).uv ==
        parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh, Bracketing>(bracketing)).uv);
}

TEST_CASE("a search that asks for a candidate that does not exist, or for none, is refused")
{
  for(int wrong : {28, -29, std::numeric_limits<int>::max()})
    check_refused(Border_with<One_candidate_corner_search>(One_candidate_corner_search(wrong)));
  for(const auto& ask : std::vector<std::function<void(const Corner_search_problem&)>>{
          [](const Corner_search_problem& problem) {
            problem.objective_from_neighbors({0, 28});
          },
          [](const Corner_search_problem& problem) { problem.corner_distances(-1); },
          [](const Corner_search_problem& problem) { problem.objective_of({}); }, [](const Corner_search_problem&) {}})
    check_refused(Border_with<Any_corner_search>(Any_corner_search{ask}));
}

TEST_CASE("the free function names the candidate that does not exist")
{
  Square_map_options<Surface_mesh> options;
  options.search = One_candidate_corner_search(1000);
  const Result refused = map_onto_square(noisy_height_field(7), options).result;
  CHECK(refused.status == SMP::ERROR_WRONG_PARAMETER);
  CHECK(refused.message == "the corner search asked for candidate 1000; the candidates are 0 to 27");
  options.search = One_candidate_corner_search(-1);
  const Result last = map_onto_square(noisy_height_field(7), options).result;
  CHECK(last.status == SMP::OK);
  CHECK((last.search.best_candidate == 27 && last.search.evaluations == 1));
}

TEST_CASE("a search with a number out of its range is refused")
{
  check_refused(Bracketing_square_border_parameterizer_3<Surface_mesh>(Bracketing_corner_search(2)));
  check_refused(Hybrid_square_border_parameterizer_3<Surface_mesh>(Hybrid_corner_search(-1)));
  Square_map_options<Surface_mesh> options;
  options.search = Bracketing_corner_search(0);
  const Result refused = map_onto_square(noisy_height_field(7), options).result;
  CHECK(refused.status == SMP::ERROR_WRONG_PARAMETER);
  CHECK(refused.message == "a number of the corner search is out of its range");
}

namespace {

/// a square with a flap, whose chord has both ends on one side for the first candidate: that has no map
Flat_mesh square_with_flap()
{
  Flat_mesh flat = unit_square(12);
  REQUIRE(flat.border[1] == 1);
  REQUIRE(flat.border[2] == 2);
  flat.points.emplace_back(flat.points[1] - Eigen::Vector3d(0, 0.1, 0));
  flat.points.emplace_back(flat.points[2] - Eigen::Vector3d(0, 0.1, 0));
  const int left = static_cast<int>(flat.points.size()) - 2, right = left + 1;
  flat.triangles.push_back({2, 1, left});
  flat.triangles.push_back({2, left, right});
  flat.border.insert(flat.border.begin() + 2, {left, right});
  return flat;
}

/// options with a search that tries the first candidate, and all others when it is called for the last time
/// \param calls counts those of the search
Square_map_options<Surface_mesh> with_first_candidate(int last_call, bool asks_for_work, int& calls)
{
  Square_map_options<Surface_mesh> options;
  options.chords = Chords::EARS;
  options.search_options.moves_corners = false;
  options.search = Any_corner_search{[last_call, asks_for_work, &calls](const Corner_search_problem& problem) {
    ++calls;
    problem.objective_of({0});
    if(asks_for_work)
      problem.work();
    if(calls == last_call) {
      std::vector<int> others(problem.number_of_candidates - 1);
      std::iota(others.begin(), others.end(), 1);
      problem.objective_of(others);
    }
  }};
  return options;
}

} // namespace

TEST_CASE("a strategy that asks what maps cost is asked once more when no start has led to a map")
{
  constexpr int STARTS = 9; // the chosen one and all others
  const Flat_mesh flat = square_with_flap();
  int calls = 0;
  const Result result = map_onto_square(flat, with_first_candidate(STARTS + 1, true, calls)).result;
  CHECK(result.status == SMP::OK);
  CHECK(result.start == Map_start::AS_CHOSEN);
  CHECK(calls == STARTS + 1);
  calls = 0;
  CHECK(map_onto_square(flat, with_first_candidate(STARTS + 1, false, calls)).result.status ==
        SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(calls == STARTS);
}

TEST_CASE("where it is stopped at another start, no more are tried")
{
  int calls = 0;
  auto options = with_first_candidate(2, true, calls);
  options.search_options.callback = [&calls](double) { return calls < 2; };
  CHECK(map_onto_square(square_with_flap(), options).result.status == SMP::ERROR_NO_1_TO_1_MAPPING);
  CHECK(calls == 2);
}

TEST_CASE("the visitor of the border is told of the search and, after it, of the minimization")
{
  Surface_mesh mesh = bent_mesh();
  typedef Brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  const auto check_told = [&mesh](auto parameterizer_of) {
    struct In_order : Recording_visitor
    {
      void start_minimization() override
      {
        CHECK(evaluations == 28);
        CHECK(searches.empty());
        ++started;
      }

      void end_minimization(const Minimization_report& report) override
      {
        CHECK(started == 1);
        CHECK(searches.size() == 1);
        Recording_visitor::end_minimization(report);
      }

      int started = 0;
    } visitor;
    Square_search_options options;
    options.visitor = &visitor;
    Uv_map uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
    REQUIRE(SMP::parameterize(mesh, parameterizer_of(Border({}, options)), first_border_halfedge_of(mesh), uvmap) ==
            SMP::OK);
    CHECK(visitor.starts == std::vector<std::size_t>{28});
    CHECK(visitor.evaluations == 28);
    REQUIRE(visitor.searches.size() == 1);
    REQUIRE(visitor.minimizations.size() == 1);
    CHECK(visitor.minimizations[0].objective == visitor.searches[0].best_objective);
    CHECK(visitor.minimizations[0].l2 == Approx(measure_stretch(mesh, uvmap).l2).epsilon(1e-9));
  };
  check_told([](const Border& border) { return Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(border); });
  check_told([](const Border& border) { return Stretch_optimal_parameterizer_3<Surface_mesh, Border>(border); });
}

TEST_CASE("candidates are mapped by as many threads as the options say")
{
  typedef Brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  Surface_mesh mesh = bent_mesh();
  const Uv_map uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
  for(std::size_t threads : {1u, 2u}) {
    Thread_watcher of_border, of_map;
    Square_search_options options;
    options.number_of_threads = static_cast<unsigned int>(threads);
    options.visitor = &of_border;
    std::map<vertex_descriptor, bool> marks;
    const auto bhd = first_border_halfedge_of(mesh);
    REQUIRE(Border({}, options).parameterize(mesh, bhd, uvmap, 0, boost::make_assoc_property_map(marks)) == SMP::OK);
    options.visitor = &of_map;
    const Stretch_minimizing_parameterizer_3<Surface_mesh, Border> parameterizer(Border({}, options));
    REQUIRE(SMP::parameterize(mesh, parameterizer, bhd, uvmap) == SMP::OK);
    CHECK(of_border.threads.size() == threads);
    CHECK(of_map.threads.size() == threads);
  }
}

TEST_CASE("the callback stops the search: the best so far is delivered, and without a map nothing")
{
  Surface_mesh mesh = bent_mesh();
  typedef Brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  for(int limit : {0, 1, 3}) {
    Recording_visitor visitor;
    std::atomic<int> asked{0};
    Square_search_options options;
    options.number_of_threads = 1;
    options.visitor = &visitor;
    options.callback = [&asked, limit](double) { return asked++ < limit; };
    const auto [status, is_written] =
        status_and_writing(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(Border({}, options)));
    CHECK(status == (limit == 0 ? SMP::ERROR_NO_1_TO_1_MAPPING : SMP::OK));
    CHECK(is_written == (limit > 0));
    REQUIRE(visitor.searches.size() == 1);
    CHECK(visitor.searches[0].is_cancelled);
    CHECK(visitor.searches[0].evaluations == std::size_t(limit));
  }
}

TEST_CASE("what a user's code throws comes out of parameterize(), and nothing is written")
{
  struct Failing_visitor : Search_visitor
  {
    void after_evaluation(const Search_report::Sample&) override { throw std::domain_error("of the user"); }
  } visitor;
  Square_search_options with_visitor, with_callback;
  with_visitor.visitor = &visitor;
  with_callback.callback = [](double) -> bool { throw std::domain_error("of the user"); };
  typedef Border_with<Any_corner_search> Border;
  const Any_corner_search failing{[](const Corner_search_problem& problem) {
    problem.objective_of({0, 1});
    throw std::domain_error("of the user");
  }};
  const Any_corner_search harmless{[](const Corner_search_problem& problem) { problem.objective_of({0, 1}); }};
  for(const Border& border : {Border(failing), Border(harmless, with_visitor), Border(harmless, with_callback)}) {
    Surface_mesh mesh = bent_mesh();
    Uv_map uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv", Point_2(-7, -7)).first;
    CHECK_THROWS_WITH(SMP::parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Border>(border),
                                        first_border_halfedge_of(mesh), uvmap),
                      "of the user");
    for(vertex_descriptor v : mesh.vertices())
      CHECK(uvmap[v] == Point_2(-7, -7));
  }
}

TEST_CASE("one border parameterizer serves several threads at a time")
{
  const Hybrid_square_border_parameterizer_3<Surface_mesh> border;
  const auto map_border = [&border] {
    Surface_mesh mesh = bent_mesh();
    const Uv_map uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv", Point_2(-7, -7)).first;
    const bool is_mapped = border.parameterize(mesh, first_border_halfedge_of(mesh), uvmap,
                                               CGAL::Constant_property_map<vertex_descriptor, int>(0),
                                               CGAL::Constant_property_map<vertex_descriptor, bool>()) == SMP::OK;
    return is_mapped ? std::vector<Point_2>(uvmap.begin(), uvmap.end()) : std::vector<Point_2>();
  };
  const std::vector<Point_2> expected = map_border();
  REQUIRE(!expected.empty());
  std::vector<std::vector<Point_2>> results(4);
  std::vector<std::thread> threads;
  for(auto& result : results)
    threads.emplace_back([&result, &map_border] { result = map_border(); });
  for(std::thread& thread : threads)
    thread.join();
  for(const auto& result : results)
    CHECK(result == expected);
}

namespace {

/// what the concept BaseWeights asks for, and nothing more: half the cotangents of the angles opposite to an edge, from
/// the shapes of the faces
class Cotangents_of_user
{
public:
  explicit Cotangents_of_user(double factor) : m_factor(factor) {}
  Cotangents_of_user(const Cotangents_of_user&) = default;
  Cotangents_of_user& operator=(const Cotangents_of_user&) = delete;

  CGAL_ext::Edge_weights operator()(const CGAL_ext::Patch& patch) const
  {
    CGAL_ext::Edge_weights weights(patch, 0, true);
    for(int f = 0; f < patch.number_of_faces(); ++f) {
      const CGAL_ext::Flat_triangle& shape = patch.shapes[f];
      const double corners[3][2] = {{0, 0}, {shape.x1, 0}, {shape.x2, shape.y2}};
      for(int k = 0; k < 3; ++k) {
        const auto &p = corners[k], &q = corners[(k + 1) % 3], &r = corners[(k + 2) % 3];
        const double dot = (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1]);
        const double cotangent = m_factor * dot / (2 * shape.area()), half = cotangent / 2;
        const int edge = patch.triangle_edges[f][k];
        for(int end : {0, 1})
          weights.add(patch, edge, patch.edges[edge][end], half);
      }
    }
    return weights;
  }

private:
  double m_factor;
};

/// weights of a user that do not fit: too few, too many, or not symmetric though they are said to be
struct Wrong_weights
{
  Edge_weights operator()(const Patch& patch) const
  {
    Edge_weights weights(patch, 1, true);
    if(surplus == 0)
      weights.values[3] = {1, 1 + 1e-9};
    weights.values.resize(static_cast<std::size_t>(static_cast<int>(patch.edges.size()) + surplus), {1, 1});
    return weights;
  }

  int surplus = 0;
};

} // namespace

TEST_CASE("base weights that are written from their page alone are those that they imitate")
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  Surface_mesh mesh = make_mesh<Surface_mesh>(saddle(6));
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Harmonic_weights> Ours;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Cotangents_of_user> Theirs;
  const Parameterization expected = parameterize(mesh, Ours());
  REQUIRE(is_one_to_one(expected, mesh.number_of_faces()));
  for(double factor : {1., 3.}) // weights matter up to a common factor
    CHECK(largest_difference(parameterize(mesh, Theirs(Border(), Cotangents_of_user(factor))).uv, expected.uv) < 1e-9);

  // also where the balanced energy starts from, on coarser disks
  Balanced_minimization minimization;
  minimization.start.weights = Cotangents_of_user(1);
  CHECK(is_one_to_one(parameterize(mesh, Stretch_optimal_parameterizer_3<Surface_mesh, Border>(Border(), minimization)),
                      mesh.number_of_faces()));
}

TEST_CASE("base weights that do not fit the disk are refused")
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, Wrong_weights> Parameterizer;
  Surface_mesh mesh = bent_mesh();
  for(int surplus : {-1, 0, 1})
    CHECK(parameterize(mesh, Parameterizer(Border(), Wrong_weights{surplus})).status == SMP::ERROR_WRONG_PARAMETER);
  const Patch patch = make_patch_of(noisy_height_field(7));
  const std::string edges = std::to_string(patch.edges.size()), one_less = std::to_string(patch.edges.size() - 1);
  CHECK_THROWS_WITH(internal::checked(Wrong_weights{-1}(patch), patch),
                    "the base weights are for " + one_less + " edges; the surface has " + edges);
  CHECK_THROWS_WITH(internal::checked(Wrong_weights{0}(patch), patch),
                    "the base weights are said to be symmetric, but the two of edge 3 differ");
}

#ifndef NDEBUG // CGAL checks preconditions in debug mode alone
TEST_CASE("numbers of base weights out of their range break a precondition")
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for(double wrong : {0., -0.1, not_a_number, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(Clamped_cotangent_weights(wrong), CGAL::Precondition_exception);
    CHECK_THROWS_AS(Blended_weights(wrong), CGAL::Precondition_exception);
  }
  CHECK_THROWS_AS(Blended_weights(1.1), CGAL::Precondition_exception);
  CHECK_NOTHROW(Blended_weights(1));
}
#endif

namespace {

typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>
    Symmetric_solver_of_cgal;

/// a solver of CGAL with a memory: counts its calls, and those that overlap, for all its copies together
class Counting_solver : public Symmetric_solver_of_cgal
{
public:
  struct Counts
  {
    std::atomic<int> calls{0}, running{0}, overlaps{0};
  };

  Counting_solver() = default; // counts nothing: not the one that was given
  explicit Counting_solver(std::shared_ptr<Counts> counts) : m_counts(std::move(counts)) {}

  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d)
  {
    if(!m_counts)
      return Symmetric_solver_of_cgal::linear_solver(a, b, x, d);
    ++m_counts->calls;
    if(m_counts->running++ > 0)
      ++m_counts->overlaps;
    const bool is_solved = Symmetric_solver_of_cgal::linear_solver(a, b, x, d);
    --m_counts->running;
    return is_solved;
  }

private:
  std::shared_ptr<Counts> m_counts;
};

} // namespace

TEST_CASE("a solver object that is given solves all systems, one at a time")
{
  typedef Brute_force_square_border_parameterizer_3<Surface_mesh> Border;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, CGAL::Default, Counting_solver> Parameterizer;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border> Direct;
  Surface_mesh mesh = bent_mesh();
  const Parameterization expected = parameterize(mesh, Direct());
  Square_search_options four_threads;
  four_threads.number_of_threads = 4;
  const auto counts = std::make_shared<Counting_solver::Counts>();
  const Parameterizer given(Border({}, four_threads), Blended_weights(), 0.3, 1, 100, Counting_solver(counts));
  CHECK(largest_difference(parameterize(mesh, given).uv, expected.uv) < 1e-8);
  CHECK(counts->calls > 2 * 28); // two right-hand sides for each of several systems per candidate
  CHECK(counts->overlaps == 0);
  const int calls = counts->calls;
  CHECK(largest_difference(parameterize(mesh, Parameterizer(Border({}, four_threads))).uv, expected.uv) < 1e-8);
  CHECK(counts->calls == calls);
}

TEST_CASE("copies of a parameterizer with a given solver may map at the same time")
{
  typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Border;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Border, CGAL::Default, Counting_solver> Parameterizer;
  const auto counts = std::make_shared<Counting_solver::Counts>();
  const Parameterizer given(Border(), Blended_weights(), 0.3, 1, 100, Counting_solver(counts));
  Surface_mesh mesh = bent_mesh();
  const std::vector<Eigen::Vector2d> expected = parameterize(mesh, given).uv;
  std::vector<std::vector<Eigen::Vector2d>> results(4);
  std::vector<std::thread> threads;
  for(auto& result : results)
    threads.emplace_back([&result, &given] {
      Surface_mesh own_mesh = bent_mesh();
      result = parameterize(own_mesh, given).uv;
    });
  for(std::thread& thread : threads)
    thread.join();
  for(const auto& result : results)
    CHECK(result == expected);
  CHECK(counts->overlaps == 0);
}
