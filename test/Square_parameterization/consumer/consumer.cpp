// Maps a mesh made of four triangles through the installed package.

#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Kernel::Point_3(0, 0, 0)), b = mesh.add_vertex(Kernel::Point_3(1, 0, 0)),
             c = mesh.add_vertex(Kernel::Point_3(1, 1, 0)), d = mesh.add_vertex(Kernel::Point_3(0, 1, 0)),
             e = mesh.add_vertex(Kernel::Point_3(0.5, 0.5, 0.5));
  mesh.add_face(a, b, e);
  mesh.add_face(b, c, e);
  mesh.add_face(c, d, e);
  mesh.add_face(d, a, e);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  auto done = mesh.add_property_map<Mesh::Vertex_index, bool>("v:done").first;
  auto index = mesh.add_property_map<Mesh::Vertex_index, int>("v:number").first;
  CGAL_ext::Square_border_arc_length_parameterizer_3<Mesh> border(a, b, c, d);
  const auto status = border.parameterize(mesh, mesh.opposite(mesh.halfedge(a, b)), uv, index, done);
  return status == CGAL::Surface_mesh_parameterization::OK && uv[c] == Kernel::Point_2(1, 1) ? 0 : 1;
}
