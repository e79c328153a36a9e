// examples/Square_parameterization/user_defined_corner_search.cpp
//
// A search strategy of one's own, a progress visitor, and a search that stops when a map is good enough.

#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

/// evaluates four candidates spread over the quarter, then halves the distance to the best of them again and again
struct Halving_corner_search
{
  CGAL_ext::Candidate_set candidate_set() const { return CGAL_ext::Candidate_set::QUARTER; }
  void operator()(const CGAL_ext::Corner_search_problem& problem) const
  {
    const int m = problem.number_of_candidates;
    int best = 0;
    for(int distance = (m + 3) / 4, round = 0; distance > 0; distance /= 2, ++round) {
      std::vector<int> batch{best, (best + distance) % m, (best + m - distance % m) % m};
      if(round == 0)
        batch.push_back((best + 2 * distance) % m);
      const std::vector<double> stretch = problem.objective_of(batch); // concurrently; known candidates cost nothing
      best = batch[std::min_element(stretch.begin(), stretch.end()) - stretch.begin()];
    }
  }
};

struct Progress : CGAL_ext::Search_visitor
{
  void after_evaluation(const CGAL_ext::Search_report::Sample& sample) override
  {
    least = (std::min)(least, sample.objective);
    std::cout << "candidate " << sample.candidate << ": " << sample.objective << '\n';
  }

  double least = std::numeric_limits<double>::infinity();
};

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/mushroom.off"), mesh))
    return EXIT_FAILURE;
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  Progress progress;
  CGAL_ext::Square_map_options<Mesh> options;
  options.search = Halving_corner_search();
  options.search_options.visitor = &progress;
  options.search_options.callback = [&](double) { return progress.least > 1.01; }; // good enough
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uvmap, CGAL_ext::parameters::options(options));
  std::cout << "L2 " << result.measures.l2 << " after " << result.search.evaluations << " evaluations"
            << (result.search.is_cancelled ? ", stopped early\n" : "\n");
  return result.status == CGAL::Surface_mesh_parameterization::OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
