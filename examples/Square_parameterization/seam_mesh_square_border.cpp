// examples/Square_parameterization/seam_mesh_square_border.cpp
//
// A closed surface, cut along a path of edges by CGAL's Seam_mesh, mapped onto the square.

#include "include/Print_search.h"

#include <CGAL_ext/Square_parameterization/Hybrid_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimizing_parameterizer_3.h>

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
typedef CGAL_ext::Hybrid_square_border_parameterizer_3<Mesh> Border;
typedef CGAL_ext::Stretch_minimizing_parameterizer_3<Mesh, Border> Parameterizer;

/// cuts the surface along a path with the fewest edges from vertex 0 to a vertex as far from it as any
void add_seam(const Surface& surface, Mesh& mesh)
{
  std::vector<Surface::Vertex_index> queue{Surface::Vertex_index(0)};
  std::vector<Surface::Vertex_index> previous(surface.number_of_vertices(), Surface::null_vertex());
  previous[0] = queue[0];
  for(std::size_t i = 0; i < queue.size(); ++i) // breadth-first
    for(Surface::Vertex_index v : surface.vertices_around_target(surface.halfedge(queue[i])))
      if(previous[v] == Surface::null_vertex()) {
        previous[v] = queue[i];
        queue.push_back(v);
      }
  for(Surface::Vertex_index v = queue.back(); v != previous[v]; v = previous[v])
    mesh.add_seam(v, previous[v]);
}

int main(int argc, char** argv)
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bear.off"), surface))
    return EXIT_FAILURE;
  Mesh mesh(surface, surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first,
            surface.add_property_map<Surface::Vertex_index, bool>("v:seam", false).first);
  add_seam(surface, mesh);
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uvmap = surface.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv").first; // split at the seam

  Print_search visitor;
  CGAL_ext::Square_search_options options;
  options.visitor = &visitor;
  const SMP::Error_code status = SMP::parameterize(mesh, Parameterizer(Border(0, options)), bhd, uvmap);
  return status == SMP::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
