// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// benchmark/Square_parameterization/fixed_border_methods.cpp
//
// Compares the maps onto the square that CGAL's fixed-border parameterizers make with those of this package, in one
// run: median seconds of the call, L2 and Linf stretch, and the faces that are clockwise or flat by exact arithmetic.
// All start at the border vertex of lowest index. CGAL's square maps are mirrored: their mirror image is measured.
//
//   fixed_border_methods build/data/meshes/lion-head.off build/data/meshes/nefertiti.off --repetitions 5 --csv times.csv

#include "include/first_border_halfedge.h"

#include "../../examples/Square_parameterization/include/compiled_reader.h"

#include <CGAL_ext/Square_parameterization/Hybrid_corner_search.h>
#include <CGAL_ext/Square_parameterization/Quarter_brute_force_square_border_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Square_border_arc_length_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/Stretch_minimizing_parameterizer_3.h>
#include <CGAL_ext/Square_parameterization/error_message.h>
#include <CGAL_ext/Square_parameterization/measure_stretch.h>
#include <CGAL_ext/Square_parameterization/parameterize_onto_square.h>
#include <CGAL_ext/Square_parameterization/split_chords.h>

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> UV_map;

typedef SMP::Square_border_arc_length_parameterizer_3<Mesh> CGAL_border;
typedef SMP::Iterative_authalic_parameterizer_3<Mesh, CGAL_border> Iterative_authalic;
typedef CGAL_ext::Square_border_arc_length_parameterizer_3<Mesh> Our_border;
typedef CGAL_ext::Stretch_minimizing_parameterizer_3<Mesh, Our_border> One_candidate;
typedef CGAL_ext::Quarter_brute_force_square_border_parameterizer_3<Mesh> Quarter_search;
typedef CGAL_ext::Stretch_minimizing_parameterizer_3<Mesh, Quarter_search> Quarter_brute_force;

/// what a method says of itself
struct Answer
{
  std::string error; // empty: there is a map
  std::size_t evaluations = 1;
};

struct Method
{
  std::string name;
  std::function<Answer(Mesh&, Halfedge, UV_map)> map;
};

struct Result
{
  Answer answer;
  double seconds = 0; // median
  CGAL_ext::Stretch_measures measures;
};

/// while it lives, nothing reaches standard output
class Silence
{
public:
  Silence() : m_buffer(std::cout.rdbuf(nullptr)) {}
  ~Silence() { std::cout.rdbuf(m_buffer); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  std::streambuf* m_buffer;
};

class Count_evaluations : public CGAL_ext::Search_visitor
{
public:
  std::size_t evaluations = 0;
  void end_search(const CGAL_ext::Search_report& report) override { evaluations = report.evaluations; }
};

Answer answer(SMP::Error_code status, std::size_t evaluations = 1)
{
  return {status == SMP::OK ? "" : CGAL_ext::error_message(status), evaluations};
}

template <class Parameterizer>
Answer map_by(Mesh& mesh, Halfedge border, UV_map uv)
{
  return answer(SMP::parameterize(mesh, Parameterizer(), border, uv));
}

/// cannot be copied, and so cannot be passed to `SMP::parameterize()`; prints its progress
Answer map_by_iterative_authalic(Mesh& mesh, Halfedge border, UV_map uv)
{
  const Silence silence;
  Iterative_authalic parameterizer;
  const SMP::Error_code status = parameterizer.parameterize(mesh, border, uv, 15);
  std::filesystem::remove("last_solve.off"); // it leaves its last map in the working folder
  return answer(status);
}

Answer map_by_quarter_brute_force(Mesh& mesh, Halfedge border, UV_map uv)
{
  Count_evaluations count;
  CGAL_ext::Square_search_options options;
  options.visitor = &count;
  const SMP::Error_code status = SMP::parameterize(mesh, Quarter_brute_force(Quarter_search({}, options)), border, uv);
  return answer(status, count.evaluations);
}

/// one call with the iteration and the search that suits it
Answer map_by_hybrid_search(Mesh& mesh, Halfedge, UV_map uv)
{
  CGAL_ext::Square_map_options<Mesh> options;
  options.search = CGAL_ext::Hybrid_corner_search();
  options.minimization = CGAL_ext::Stretch_minimization();
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
  return {result.message, result.search.evaluations};
}

/// the least balanced energy for one candidate
Answer map_one_candidate_optimally(Mesh& mesh, Halfedge, UV_map uv)
{
  CGAL_ext::Square_map_options<Mesh> options;
  options.search = CGAL_ext::First_candidate_corner_search();
  options.search_options.moves_corners = false;
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(options));
  return {result.message, result.search.evaluations};
}

/// one call, everything by default
Answer map_by_default(Mesh& mesh, Halfedge, UV_map uv)
{
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uv);
  return {result.message, result.search.evaluations + result.search.corner_maps};
}

const std::vector<Method> methods{
    {"CGAL barycentric (Tutte)", map_by<SMP::Barycentric_mapping_parameterizer_3<Mesh, CGAL_border>>},
    {"CGAL discrete conformal", map_by<SMP::Discrete_conformal_map_parameterizer_3<Mesh, CGAL_border>>},
    {"CGAL discrete authalic", map_by<SMP::Discrete_authalic_parameterizer_3<Mesh, CGAL_border>>},
    {"CGAL mean value", map_by<SMP::Mean_value_coordinates_parameterizer_3<Mesh, CGAL_border>>},
    {"CGAL iterative authalic", map_by_iterative_authalic},
    {"iteration (one candidate)", map_by<One_candidate>},
    {"iteration (quarter br. f.)", map_by_quarter_brute_force},
    {"iteration (hybrid)", map_by_hybrid_search},
    {"optimal (one candidate)", map_one_candidate_optimally},
    {"optimal (default search)", map_by_default}};

constexpr std::size_t REFERENCE = 4; // the method against which seconds are compared

/// measures a map, or its mirror image when that is the one with positive area
CGAL_ext::Stretch_measures measure(const Mesh& mesh, UV_map uv)
{
  CGAL_ext::Stretch_measures measures = CGAL_ext::measure_stretch(mesh, uv);
  if(measures.uv_area < 0) {
    for(Mesh::Vertex_index v : mesh.vertices())
      uv[v] = Kernel::Point_2(uv[v].y(), uv[v].x());
    measures = CGAL_ext::measure_stretch(mesh, uv);
  }
  return measures;
}

/// maps copies of the mesh; what a method throws becomes its error
Result run(const Method& method, const Mesh& input, int repetitions)
{
  Result result;
  std::vector<double> seconds;
  for(int i = 0; i < repetitions; ++i) {
    Mesh mesh = input;
    UV_map uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("h:uv").first;
    const Halfedge border = first_border_halfedge(mesh);
    const auto start = std::chrono::steady_clock::now();
    try {
      result.answer = method.map(mesh, border, uv);
    } catch(const std::exception& error) {
      result.answer.error = error.what();
    }
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if(result.answer.error.empty())
      result.measures = measure(mesh, uv);
  }
  std::nth_element(seconds.begin(), seconds.begin() + repetitions / 2, seconds.end());
  result.seconds = seconds[repetitions / 2];
  return result;
}

void print(const std::string& name, const std::vector<Result>& results, std::ostream& csv)
{
  for(std::size_t i = 0; i < results.size(); ++i) {
    const auto& [answer, seconds, measures] = results[i];
    const double speed = results[REFERENCE].seconds / seconds;
    std::cout << "  " << std::left << std::setw(28) << methods[i].name << std::right << std::fixed << std::setw(5)
              << answer.evaluations << std::setw(11) << std::setprecision(4) << seconds << std::setw(10)
              << std::setprecision(2) << speed;
    if(answer.error.empty())
      std::cout << std::setprecision(4) << std::setw(10) << measures.l2 << std::setw(10) << measures.linf
                << std::setw(10) << measures.symmetric_dirichlet << std::setw(9) << measures.flipped_faces << '\n';
    else
      std::cout << "  " << answer.error << '\n';
    csv << name << ',' << methods[i].name << ',' << answer.evaluations << ',' << seconds << ',' << speed << ','
        << measures.l2 << ',' << measures.linf << ',' << measures.symmetric_dirichlet << ',' << measures.flipped_faces
        << ',' << answer.error << '\n';
  }
  std::cout << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  std::vector<std::string> files;
  int repetitions = 3;
  std::string csv_file;
  po::options_description options("fixed_border_methods MESH... [options]");
  auto add = options.add_options();
  add("mesh", po::value(&files)->required(), "triangle meshes with one border");
  add("repetitions", po::value(&repetitions)->value_name("N"), "runs of each method; default 3");
  add("split-chords", "split the chords of the mesh before all methods");
  add("csv", po::value(&csv_file)->value_name("FILE"), "also write the table there");
  po::variables_map given;
  try {
    const auto positional = po::positional_options_description().add("mesh", -1);
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), given);
    po::notify(given);
    if(repetitions < 1)
      throw po::error("--repetitions must be positive");
  } catch(const po::error& error) {
    std::cerr << error.what() << '\n' << options;
    return EXIT_FAILURE;
  }

  std::ofstream csv(csv_file);
  csv << "mesh,method,evaluations,seconds,speed,l2,linf,symmetric_dirichlet,flipped,error\n";
  std::cout << "median seconds of " << repetitions << "; speed: times as fast as " << methods[REFERENCE].name
            << ";\nof CGAL's maps, which are mirrored, the mirror image is measured\n\n";
  for(const std::string& file : files) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
      std::cerr << "cannot read " << file << '\n';
      return EXIT_FAILURE;
    }
    if(given.count("split-chords") != 0)
      CGAL_ext::split_chords(mesh);
    const std::string name = std::filesystem::path(file).stem().string();
    std::cout << std::left << std::setw(30) << name + ", " + std::to_string(mesh.number_of_faces()) + " faces"
              << " maps    seconds     speed        L2      Linf  sym.Dir.  flipped" << std::endl;
    std::vector<Result> results;
    for(const Method& method : methods)
      results.push_back(run(method, mesh, repetitions));
    print(name, results, csv);
  }
}
