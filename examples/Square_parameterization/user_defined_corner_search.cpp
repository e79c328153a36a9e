// examples/Square_parameterization/user_defined_corner_search.cpp
//
// A search strategy of one's own in CGAL's parameterize(), a progress visitor, and a search that stops when a map is
// good enough.

#include <CGAL_ext/Square_parameterization/Square_border_corner_search_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_optimal_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

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
      const std::vector<double> objective = problem.objective_of(batch); // concurrently; known candidates cost nothing
      best = batch[std::min_element(objective.begin(), objective.end()) - objective.begin()];
    }
  }
};

struct Progress : CGAL_ext::Search_visitor
{
  void after_evaluation(const CGAL_ext::Search_report::Sample& sample) override
  {
    least_l2 = (std::min)(least_l2, sample.l2);
    std::cout << "candidate " << sample.candidate << ": L2 " << sample.l2 << '\n';
  }

  void end_search(const CGAL_ext::Search_report& report) override
  {
    std::cout << report.evaluations << " evaluations" << (report.is_cancelled ? ", stopped early\n" : "\n");
  }

  double least_l2 = std::numeric_limits<double>::infinity();
};

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL_ext::Square_border_corner_search_parameterizer_3<Mesh, Halving_corner_search> Border;
typedef CGAL_ext::Stretch_optimal_parameterizer_3<Mesh, Border> Parameterizer;

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

  Progress progress;
  CGAL_ext::Square_search_options options;
  options.visitor = &progress;
  options.callback = [&](double) { return progress.least_l2 > 1.178; }; // good enough
  const Border border(Halving_corner_search(), options);
  const SMP::Error_code status = SMP::parameterize(mesh, Parameterizer(border), bhd, uvmap);
  if(status != SMP::OK) {
    std::cerr << CGAL_ext::error_message(status) << '\n';
    return EXIT_FAILURE;
  }
  std::cout << "L2 " << CGAL_ext::measure_stretch(mesh, uvmap).l2 << '\n';
  return EXIT_SUCCESS;
}
