// examples/Square_parameterization/seam_mesh_square_border.cpp
//
// A closed surface, cut by CGAL's Seam_mesh along seams that leave little stretch, mapped onto the square.

#include "include/Print_search.h"

#include <CGAL_ext/Square_parameterization/Bracketing_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_optimal_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/mark_seams.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/properties_Seam_mesh.h>

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Surface;
typedef Surface::Property_map<Surface::Edge_index, bool> Seam_edges;
typedef Surface::Property_map<Surface::Vertex_index, bool> Seam_vertices;
typedef CGAL::Seam_mesh<Surface, Seam_edges, Seam_vertices> Mesh;
typedef CGAL_ext::Bracketing_square_border_parameterizer_3<Mesh> Border;
typedef CGAL_ext::Stretch_optimal_parameterizer_3<Mesh, Border> Parameterizer;

int main(int argc, char** argv)
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bear.off"), surface))
    return EXIT_FAILURE;
  const Seam_edges seam_edges = surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first;
  const Seam_vertices seam_vertices = surface.add_property_map<Surface::Vertex_index, bool>("v:seam", false).first;
  const CGAL_ext::Seam_result seams = CGAL_ext::mark_seams(surface, seam_edges, seam_vertices);
  if(seams.status != SMP::OK) {
    std::cerr << seams.message << '\n';
    return EXIT_FAILURE;
  }
  CGAL_ext::split_seam_chords(surface, seam_edges, seam_vertices); // every choice of corners then has a map
  std::cout << "cut along " << seams.cut.seam_edges << " edges, " << seams.cut.cut_length << " sqrt(area) long\n";
  Mesh mesh(surface, seam_edges, seam_vertices);
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uvmap = surface.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv").first; // split at the seam

  Print_search visitor;
  CGAL_ext::Square_search_options options;
  options.visitor = &visitor;
  const Border border(CGAL_ext::Bracketing_corner_search(), options);
  const SMP::Error_code status = SMP::parameterize(mesh, Parameterizer(border), bhd, uvmap);
  if(status != SMP::OK)
    std::cerr << CGAL_ext::error_message(status) << '\n';
  return status == SMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
