// examples/Square_parameterization/single_highest_square_border.cpp
//
// Puts the border vertex of highest stretch on the circle onto a corner.

#include "include/Print_search.h"

#include <CGAL_ext/Square_parameterization/Single_highest_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimizing_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/error_message.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL_ext::Single_highest_square_border_parameterizer_3<Mesh> Border;
typedef CGAL_ext::Stretch_minimizing_parameterizer_3<Mesh, Border> Parameterizer;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/mushroom.off"), mesh) ||
     CGAL::is_closed(mesh)) {
    std::cerr << "cannot read a surface with border\n";
    return EXIT_FAILURE;
  }
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  Print_search visitor;
  CGAL_ext::Square_search_options options;
  options.visitor = &visitor;
  const Border border(CGAL_ext::Single_highest_corner_search(), options);
  const SMP::Error_code status = SMP::parameterize(mesh, Parameterizer(border), bhd, uvmap);
  if(status != SMP::OK)
    std::cerr << CGAL_ext::error_message(status) << '\n';
  return status == SMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
