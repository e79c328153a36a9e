// examples/Square_parameterization/fit_bspline_surface.cpp
//
// What a map with little stretch is good for: a bicubic B-spline surface is fitted to points that lie evenly on the
// mesh, each at its place on the square, by least squares. The same points are fitted with two maps of CGAL, on its
// square border, and with that of this package: the fewer control points a map wastes, the closer the surface comes.

#include "include/Bspline_surface.h"

#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdio>
#include <filesystem>
#include <sstream>

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> UV_map;
typedef SMP::Square_border_arc_length_parameterizer_3<Mesh> Border;

/// splits every face into as many rows of like triangles as it takes to have about \p count of them on the mesh; their
/// centers are samples
std::vector<Surface_sample> even_samples(const Mesh& mesh, UV_map uv, double count)
{
  const double total = PMP::area(mesh);
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const Eigen::Vector3d center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                               (box.zmin() + box.zmax()) / 2);
  std::vector<Surface_sample> samples;
  for(Mesh::Face_index f : mesh.faces()) {
    Eigen::Matrix<double, 5, 3> corners; // x, y, z, u and v
    int k = 0;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const Kernel::Point_3& p = mesh.point(v);
      corners.col(k++) << p.x() - center.x(), p.y() - center.y(), p.z() - center.z(), uv[v].x(), uv[v].y();
    }
    const double area = PMP::face_area(f, mesh);
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(area / total * count))));
    for(int i = 0; i < rows; ++i)
      for(int j = 0; j < 2 * (rows - i) - 1; ++j) { // upright triangles and those between them take turns
        const double third = (1 + j % 2) / 3., a = (i + third) / rows, b = (j / 2 + third) / rows;
        const Eigen::Matrix<double, 5, 1> s = corners * Eigen::Vector3d(1 - a - b, a, b);
        samples.push_back({s.head<3>(), s[3], s[4], area / (rows * rows)});
      }
  }
  return samples;
}

/// CGAL's iterative authalic map prints what it does, and leaves a file
SMP::Error_code map_by_iterative_authalic(Mesh& mesh, Mesh::Halfedge_index bhd, UV_map uv)
{
  const std::ostringstream nowhere;
  std::streambuf* const out = std::cout.rdbuf(nowhere.rdbuf());
  SMP::Iterative_authalic_parameterizer_3<Mesh, Border> parameterizer;
  const SMP::Error_code status = parameterizer.parameterize(mesh, bhd, uv, 15);
  std::cout.rdbuf(out);
  std::filesystem::remove("last_solve.off");
  return status;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/lion-head.off"), mesh) ||
     CGAL::is_closed(mesh)) {
    std::cerr << "cannot read a surface with border\n";
    return EXIT_FAILURE;
  }
  const auto map_named = [&mesh](const char* name) {
    return mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>(name).first;
  };
  const UV_map mean_value = map_named("v:mean_value"), authalic = map_named("v:authalic"), ours = map_named("v:uv");
  // first the one that may split edges, so that all have the same mesh
  if(CGAL_ext::parameterize_onto_square(mesh, ours).status != SMP::OK)
    return EXIT_FAILURE;
  const auto bhd = PMP::longest_border(mesh).first;
  if(SMP::parameterize(mesh, SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border>(), bhd, mean_value) != SMP::OK ||
     map_by_iterative_authalic(mesh, bhd, authalic) != SMP::OK)
    return EXIT_FAILURE;

  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  std::printf("RMS error, %% of the diagonal of the bounding box\n%12s%14s%20s%12s\n", "control net", "mean value",
              "iterative authalic", "CGAL_ext");
  for(int control_points : {8, 16, 32, 64}) {
    std::printf("%8d^2  ", control_points);
    for(const auto& [uv, width] :
        {std::make_pair(mean_value, 14), std::make_pair(authalic, 20), std::make_pair(ours, 12)}) {
      const std::vector<Surface_sample> samples = even_samples(mesh, uv, 1e5);
      std::printf("%*.4f", width, 100 * Bspline_surface(samples, control_points).rms_error(samples) / diagonal);
    }
    std::printf("\n");
  }
  return EXIT_SUCCESS;
}
