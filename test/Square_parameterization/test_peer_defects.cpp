// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Defects found in other libraries, each turned into a test that this library passes.

#include "mesh_types.h"
#include "reference_stretch.h"

#include <CGAL_ext/Square_parameterization/Circular_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_distortion.h>

#include <catch2/catch.hpp>

#include <iostream>
#include <set>
#include <sstream>

using namespace CGAL_ext;

namespace {

typedef boost::graph_traits<Surface_mesh>::vertex_descriptor vertex_descriptor;
typedef Surface_mesh::Property_map<vertex_descriptor, Point_2> Uv_map;
typedef Square_border_arc_length_parameterizer_3<Surface_mesh> Square_border;

/// a fan whose border edges have the given lengths, up to a common factor: on a circle wide enough, closed by bisection
Flat_mesh fan_of(const std::vector<double>& lengths)
{
  const auto angle_of = [](double length, double radius) { return 2 * std::asin(std::min(1., length / (2 * radius))); };
  const auto total_angle = [&](double radius) {
    double sum = 0;
    for(double length : lengths)
      sum += angle_of(length, radius);
    return sum;
  };
  double low = *std::max_element(lengths.begin(), lengths.end()) / 2, high = 1e3 * low;
  for(int i = 0; i < 200; ++i)
    (total_angle((low + high) / 2) > 2 * PI ? low : high) = (low + high) / 2;
  Flat_mesh mesh;
  mesh.points.emplace_back(0, 0, low);
  double angle = 0;
  const int n = static_cast<int>(lengths.size());
  for(int k = 0; k < n; ++k) {
    mesh.points.emplace_back(high * std::cos(angle), high * std::sin(angle), 0);
    angle += angle_of(lengths[k], high);
    mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
    mesh.border.push_back(1 + k);
  }
  return mesh;
}

/// a map given by a function of the points
template <class Function>
Uv_map map_by(Surface_mesh& mesh, Function f)
{
  Uv_map uvmap = mesh.add_property_map<vertex_descriptor, Point_2>("v:uv").first;
  for(vertex_descriptor v : mesh.vertices())
    uvmap[v] = f(mesh.point(v));
  return uvmap;
}

/// what is written to a stream while this lives
class Captured_stream
{
public:
  explicit Captured_stream(std::ostream& stream) : m_stream(stream), m_buffer(stream.rdbuf(m_text.rdbuf())) {}
  ~Captured_stream() { m_stream.rdbuf(m_buffer); }

  std::string text() const { return m_text.str(); }

private:
  std::ostream& m_stream;
  std::ostringstream m_text;
  std::streambuf* m_buffer;
};

} // namespace

TEST_CASE("defect 1: automatic corners leave no border vertex outside the square")
{
  const std::vector<double> lengths =
      GENERATE(std::vector<double>{3, 3, 1, 1.5}, std::vector<double>{.499, .002, .003, .002, .002, .492});
  Surface_mesh mesh = make_mesh<Surface_mesh>(fan_of(lengths));
  for(auto h : mesh.halfedges()) {
    if(!mesh.is_border(h))
      continue;
    const Parameterization result =
        parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Square_border>(), h);
    REQUIRE(is_one_to_one(result, mesh.number_of_faces()));
    std::set<std::pair<double, double>> corners;
    for(std::size_t v = 1; v < result.uv.size(); ++v) {
      const double u = result.uv[v].x(), w = result.uv[v].y();
      CHECK((u >= 0 && u <= 1 && w >= 0 && w <= 1));
      CHECK((u == 0 || u == 1 || w == 0 || w == 1));
      if((u == 0 || u == 1) && (w == 0 || w == 1))
        corners.insert({u, w});
    }
    CHECK(corners.size() == 4);
  }
}

TEST_CASE("defect 2: every error code has a message of its own")
{
  std::set<std::string> messages;
  for(int code = SMP::OK; code <= SMP::ERROR_WRONG_PARAMETER; ++code) {
    const char* message = error_message(static_cast<SMP::Error_code>(code));
    REQUIRE(message != nullptr);
    CHECK(std::string(message) != "unknown error");
    messages.insert(message);
  }
  CHECK(messages.size() == SMP::ERROR_WRONG_PARAMETER - SMP::OK + 1);
  CHECK_THAT(error_message(SMP::ERROR_BORDER_TOO_SHORT), Catch::Matchers::Contains("border"));
  CHECK_THAT(error_message(SMP::ERROR_NON_TRIANGULAR_MESH), Catch::Matchers::Contains("triangle"));
  CHECK(std::string(error_message(static_cast<SMP::Error_code>(15))) == "unknown error");
}

TEST_CASE("defect 3: the L2 stretch is that of Sander et al., not a norm of area ratios")
{
  // a rectangle three times as long as wide, squeezed to a square: areas are kept but for a factor, lengths are not
  Surface_mesh mesh = make_mesh<Surface_mesh>(rectangle(6, 6, 3, 1, 1));
  const Uv_map uvmap = map_by(mesh, [](const Kernel::Point_3& p) { return Point_2(p.x() / 3, p.y()); });
  const Stretch_measures measures = measure_stretch(mesh, uvmap);
  CHECK(measures.l2 == Approx(std::sqrt(10 / 6.)).epsilon(1e-13));
  CHECK(measures.linf == Approx(std::sqrt(3)).epsilon(1e-12));
  CHECK(measures.symmetric_dirichlet == Approx((3 + 1 / 3.) / 2).epsilon(1e-12));
  CHECK(std::abs(SMP::compute_L2_stretch(mesh, uvmap) - measures.l2) > 0.1);
}

TEST_CASE("defect 3: the measures agree with an independent computation, per vertex too")
{
  const Flat_mesh flat = noisy_height_field(7);
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  const Uv_map uvmap =
      map_by(mesh, [](const Kernel::Point_3& p) { return Point_2(5 * p.x() + p.y() * p.y(), 3 * p.y()); });
  std::vector<Eigen::Vector2d> uv;
  for(vertex_descriptor v : mesh.vertices())
    uv.emplace_back(uvmap[v].x(), uvmap[v].y());
  auto vertex_stretch = mesh.add_property_map<vertex_descriptor, double>("v:stretch").first;

  const Stretch_measures measures =
      measure_stretch(mesh, uvmap, parameters::vertex_stretch_map(vertex_stretch).vertex_point_map(mesh.points()));
  const Reference_stretch expected = reference_stretch(flat.points, flat.triangles, uv);
  CHECK(measures.l2 == Approx(expected.l2).epsilon(1e-12));
  CHECK(measures.linf == Approx(expected.linf).epsilon(1e-12));
  double surface_area = 0;
  for(const auto& [a, b, c] : flat.triangles)
    surface_area += (flat.points[b] - flat.points[a]).cross(flat.points[c] - flat.points[a]).norm() / 2;
  const double scale = std::sqrt(measures.uv_area / surface_area);
  for(vertex_descriptor v : mesh.vertices())
    CHECK(vertex_stretch[v] == Approx(expected.vertex_l2[v] * scale).epsilon(1e-12));
  REQUIRE(measures.face_l2.size() == mesh.number_of_faces());
  for(double l2 : measures.face_l2)
    CHECK(l2 > 0);
}

TEST_CASE("defect 3: flipped and flat faces are counted exactly")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(rectangle(4, 4, 4, 4, 1, 0));
  Uv_map uvmap = map_by(mesh, [](const Kernel::Point_3& p) { return Point_2(p.x(), p.y()); });
  CHECK(measure_stretch(mesh, uvmap).flipped_faces == 0);
  CHECK(measure_stretch(mesh, uvmap).l2 == Approx(1).epsilon(1e-14));
  // one interior vertex is thrown far out: the faces around it that do not see it turn over
  uvmap[vertex_at(mesh, 12)] = Point_2(100, 2);
  std::size_t turned = 0;
  for(auto f : mesh.faces()) {
    std::vector<Eigen::Vector2d> p;
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      p.emplace_back(uvmap[v].x(), uvmap[v].y());
    turned += twice_area(p[0], p[1], p[2]) <= 0 ? 1 : 0; // small integers: exact
  }
  CHECK(turned > 0);
  const Stretch_measures measures = measure_stretch(mesh, uvmap);
  CHECK(measures.flipped_faces == turned);
  CHECK(std::isinf(measures.l2));
  // a mirrored map has no face that is right
  for(vertex_descriptor v : mesh.vertices())
    uvmap[v] = Point_2(mesh.point(v).y(), mesh.point(v).x());
  CHECK(measure_stretch(mesh, uvmap).flipped_faces == mesh.number_of_faces());
}

TEST_CASE("defect 4: the parameterizer is copyable, silent, and gives the same map every time")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(hemisphere());
  const Captured_stream out(std::cout), error(std::cerr), log(std::clog);
  const Stretch_minimizing_parameterizer_3<Surface_mesh> parameterizer;
  const Stretch_minimizing_parameterizer_3<Surface_mesh> copy(parameterizer);
  const std::vector<Eigen::Vector2d> first = parameterize(mesh, parameterizer).uv;
  REQUIRE(first.size() == mesh.number_of_vertices());
  for(int run = 0; run < 3; ++run) {
    CHECK(parameterize(mesh, parameterizer).uv == first);
    CHECK(parameterize(mesh, copy).uv == first);
  }
  CHECK((out.text() + error.text() + log.text()).empty());
}

TEST_CASE("defect 5: the square border does not mirror the map")
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(saddle(6));
  const auto walk = GENERATE(Walk::COUNTER_CLOCKWISE, Walk::CLOCKWISE);
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Square_border> Parameterizer;
  CHECK(is_one_to_one(parameterize(mesh, Parameterizer(Square_border(Corner_rule::NEAREST, walk))),
                      mesh.number_of_faces()));
  // what CGAL's border of the same name does
  typedef SMP::Square_border_arc_length_parameterizer_3<Surface_mesh> Mirroring_border;
  typedef Stretch_minimizing_parameterizer_3<Surface_mesh, Mirroring_border> Mirroring_parameterizer;
  CHECK(parameterize(mesh, Mirroring_parameterizer()).orientations.clockwise == mesh.number_of_faces());
}

TEST_CASE("defect 6: arc length on the circle belongs to the edge, not to the one beside it")
{
  const Flat_mesh flat = flat_disk(3, 11);
  Surface_mesh mesh = make_mesh<Surface_mesh>(flat);
  typedef Circular_border_arc_length_parameterizer_3<Surface_mesh> Circle;
  const Parameterization result = parameterize(mesh, Stretch_minimizing_parameterizer_3<Surface_mesh, Circle>());
  REQUIRE(is_one_to_one(result, mesh.number_of_faces()));
  const std::size_t n = flat.border.size();
  double total = 0;
  std::vector<double> lengths;
  for(std::size_t k = 0; k < n; ++k) {
    lengths.push_back((flat.points[flat.border[(k + 1) % n]] - flat.points[flat.border[k]]).norm());
    total += lengths.back();
  }
  for(std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector2d p = result.uv[flat.border[k]], q = result.uv[flat.border[(k + 1) % n]];
    const double angle = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    CHECK(angle == Approx(2 * PI * lengths[k] / total).epsilon(1e-12));
    CHECK(p.norm() == Approx(std::sqrt(1 / PI)).epsilon(1e-14));
  }
}
