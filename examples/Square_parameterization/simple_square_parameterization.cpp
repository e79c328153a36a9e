// examples/Square_parameterization/simple_square_parameterization.cpp
//
// Maps a disk onto the unit square: CGAL's parameterize() with the parameterizer of this package.

#include <CGAL_ext/Square_parameterization/Brute_force_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimizing_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

typedef CGAL_ext::Brute_force_square_border_parameterizer_3<Mesh> Border;
typedef CGAL_ext::Stretch_minimizing_parameterizer_3<Mesh, Border> Parameterizer;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "cannot read a surface with border from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  const SMP::Error_code status = SMP::parameterize(mesh, Parameterizer(), bhd, uvmap);
  if(status != SMP::OK) {
    std::cerr << CGAL_ext::error_message(status) << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "L2 stretch " << CGAL_ext::measure_stretch(mesh, uvmap).l2 << std::endl;
  std::ofstream out("square.off"); // the flat mesh
  out.precision(17);
  SMP::IO::output_uvmap_to_off(mesh, bhd, uvmap, out);
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
