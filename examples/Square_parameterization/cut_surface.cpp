// examples/Square_parameterization/cut_surface.cpp
//
// A closed surface, cut to a disk where it stretches least on the square, as a mesh of its own.

#include <CGAL_ext/Square_parameterization/cut_along_seams.h>
#include <CGAL_ext/Square_parameterization/mark_seams.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off"), mesh))
    return EXIT_FAILURE;
  const auto seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;

  CGAL_ext::Cut_options options;
  options.cut_weight = 0.1; // a shorter cut than that of the default
  const CGAL_ext::Seam_result seams =
      CGAL_ext::mark_seams(mesh, seam_edges, seam_vertices, CGAL_ext::parameters::options(options));
  if(seams.status != CGAL::Surface_mesh_parameterization::OK) {
    std::cerr << seams.message << '\n';
    return EXIT_FAILURE;
  }
  for(const CGAL_ext::Cut_step& step : seams.cut.history)
    std::cout << "score " << step.score << ", L2 stretch " << step.stretch << ", length " << step.length << '\n';

  const Mesh disk = CGAL_ext::cut_along_seams(mesh, seam_edges);
  std::cout << seams.cut.seam_edges << " seams; " << disk.number_of_vertices() - mesh.number_of_vertices()
            << " vertices were doubled\n";
  return argc > 2 && !CGAL::IO::write_polygon_mesh(argv[2], disk) ? EXIT_FAILURE : EXIT_SUCCESS;
}
