// examples/Square_parameterization/cut_surface.cpp
//
// A closed surface, cut to a disk where it stretches least on the square, as a mesh of its own: once with the default
// weight of the length of the cut, once with a large one, which asks for a short cut.

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
  Mesh surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off"), surface))
    return EXIT_FAILURE;
  for(const double cut_weight : {CGAL_ext::Cut_options().cut_weight, 1.}) {
    Mesh mesh(surface);
    const auto seam_edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    const auto seam_vertices = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
    CGAL_ext::Cut_options options;
    options.cut_weight = cut_weight;
    const CGAL_ext::Seam_result seams =
        CGAL_ext::mark_seams(mesh, seam_edges, seam_vertices, CGAL_ext::parameters::options(options));
    if(seams.status != CGAL::Surface_mesh_parameterization::OK) {
      std::cerr << seams.message << '\n';
      return EXIT_FAILURE;
    }
    std::cout << "weight " << cut_weight << ": a cut " << seams.cut.cut_length
              << " sqrt(area) long leaves an L2 stretch of " << seams.cut.stretch << '\n';

    const Mesh disk = CGAL_ext::cut_along_seams(mesh, seam_edges);
    std::cout << seams.cut.seam_edges << " seams; " << disk.number_of_vertices() - mesh.number_of_vertices()
              << " vertices were doubled\n";
    if(argc > 2 && !CGAL::IO::write_polygon_mesh(argv[2], disk))
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
