// examples/Square_parameterization/polyhedron_square_border.cpp
//
// The one-call function on a Polyhedron_3: it splits chords, searches the corners and returns all it found.

#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <iostream>
#include <map>

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor Vertex;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/three_peaks.off"), mesh)) {
    std::cerr << "cannot read the surface\n";
    return EXIT_FAILURE;
  }
  std::map<Vertex, Kernel::Point_2> uv;
  const auto result = CGAL_ext::parameterize_onto_square(mesh, boost::make_assoc_property_map(uv));
  if(result.status != SMP::OK) {
    std::cerr << result.message << '\n';
    return EXIT_FAILURE;
  }
  std::cout << result.chords_split << " chords split, " << result.search.evaluations << " candidates evaluated; L2 "
            << result.measures.l2 << ", Linf " << result.measures.linf << "; corners at";
  for(Vertex corner : result.corners)
    std::cout << " (" << corner->point() << ')';
  std::cout << '\n';
  return EXIT_SUCCESS;
}
