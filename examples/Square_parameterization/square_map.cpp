// examples/Square_parameterization/square_map.cpp
//
// Maps a triangle mesh onto the unit square from the command line; `square_map --help` lists the options.

#include "include/square_map/Command_line.h"
#include "include/square_map/Output_file.h"
#include "include/square_map/report.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <numeric>

namespace {

using namespace square_map;

enum Exit_status
{
  DONE = 0,
  BAD_COMMAND_LINE = 2,
  BAD_FILE = 3,
  UNMAPPABLE = 4,
  NO_ONE_TO_ONE_MAP = 5
};

/// a progress line on a terminal
class Progress : public CGAL_ext::Search_visitor
{
public:
  void start_search(std::size_t candidates) override { m_candidates = candidates; }

  void after_evaluation(const CGAL_ext::Search_report::Sample& sample) override
  {
    m_best = (std::min)(m_best, sample.objective);
    std::cerr << "\r" << ++m_evaluations << " of at most " << m_candidates << " candidates, least objective " << m_best
              << "   " << std::flush;
  }

  void end_search(const CGAL_ext::Search_report&) override { std::cerr << '\n'; }

private:
  std::size_t m_candidates = 0, m_evaluations = 0;
  double m_best = std::numeric_limits<double>::infinity();
};

/// refuses a corner, given as a vertex of the file, that is not on the border of the mesh
void check_corners(const std::array<std::size_t, 4>& corners,
                   const CGAL_ext::internal::Conditioning_report& conditioning, const Mesh& mesh)
{
  for(std::size_t corner : corners) {
    const std::size_t v = conditioned_vertex(corner, conditioning);
    if(v >= mesh.number_of_vertices() || !mesh.is_border(Mesh::Vertex_index(v)))
      throw Usage_error("corner vertex " + std::to_string(corner) + " is not on the border");
  }
}

/// per vertex of the uncut mesh and of the copies, the vertex of the uncut mesh
std::vector<int> originals_of(const CGAL_ext::Square_map_result<Mesh>& result, std::size_t uncut_vertices)
{
  std::vector<int> originals(uncut_vertices);
  std::iota(originals.begin(), originals.end(), 0);
  for(const auto& [copy, original] : result.copies)
    originals.push_back(static_cast<int>(original.idx()));
  return originals;
}

/// conditions the soup; a component that it does not have is a matter of the command line
CGAL_ext::internal::Conditioning_report condition(CGAL_ext::internal::Surface_soup& soup,
                                                  const CGAL_ext::internal::Conditioning_options& options)
{
  try {
    return CGAL_ext::internal::condition_soup(soup, options);
  } catch(const CGAL_ext::internal::Unmappable& error) {
    if(error.code() == CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER)
      throw Usage_error(error.what());
    throw;
  }
}

/// runs the whole job; problems leave as exceptions, and with them no output file
Exit_status run(Command_line line)
{
  typedef std::chrono::steady_clock Clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  Timings seconds;

  CGAL_ext::internal::Surface_soup soup = read_soup(line.input);
  check_well_formed(soup, line.input);
  const std::size_t input_vertices = soup.points.size(), input_faces = soup.faces.size();
  seconds.read = seconds_since(start);

  std::unique_ptr<Output_file> output, report;
  if(!line.output.empty())
    output = std::make_unique<Output_file>(line.output);
  if(!line.json.empty() && line.json != "-")
    report = std::make_unique<Output_file>(line.json);

  const auto condition_start = Clock::now();
  const auto conditioning = condition(soup, line.conditioning_options);
  if(!line.seams.empty())
    line.options.seams = read_seams(line.seams, conditioning);
  if(line.corners)
    for(int k = 0; k < 4; ++k)
      (*line.options.corners)[k] = conditioned_vertex((*line.corners)[k], conditioning);
  Mesh mesh = make_mesh(soup);
  seconds.condition = seconds_since(condition_start);

  Progress progress;
  if(!line.is_quiet && isatty(STDERR_FILENO) != 0)
    line.options.search_options.visitor = &progress;
  UV_map uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("h:uv").first;
  const auto map_start = Clock::now();
  const auto result = CGAL_ext::parameterize_onto_square(mesh, uv, CGAL_ext::parameters::options(line.options));
  seconds.condition += result.condition_seconds;
  seconds.cut = result.cut_seconds;
  seconds.search = result.search_seconds;
  seconds.final = seconds_since(map_start) - result.cut_seconds - result.condition_seconds - result.search_seconds;
  if(line.corners && result.status == CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER) {
    check_corners(*line.corners, conditioning, mesh); // names the vertex as the file does
    throw Usage_error(result.message);
  }
  if(result.status != CGAL::Surface_mesh_parameterization::OK) {
    std::cerr << "square_map: " << result.message << '\n';
    return result.search.evaluations == 0 ? UNMAPPABLE : NO_ONE_TO_ONE_MAP;
  }

  const auto write_start = Clock::now();
  const std::vector<int> originals = originals_of(result, soup.points.size());
  if(output) {
    write_map(output->stream(), mesh, uv, originals, extension_of(line.output));
    output->close();
  }
  seconds.write = seconds_since(write_start);
  seconds.total = seconds_since(start);
  if(!line.json.empty()) {
    const auto json = make_report(line, input_vertices, input_faces, conditioning, mesh, result, originals, seconds);
    std::ostream& stream = report ? static_cast<std::ostream&>(report->stream()) : std::cout;
    // a file name need not be UTF-8
    stream << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << std::endl;
    if(!stream)
      throw Output_error("cannot write the report to '" + line.json + "'");
  }
  if(report)
    report->close();
  for(const auto& file : {output.get(), report.get()})
    if(file != nullptr)
      file->commit();
  if(!line.is_quiet) {
    if(conditioning.components > 1)
      std::cerr << "component " << conditioning.component << " of " << conditioning.components << " was kept, "
                << conditioning.faces_dropped << " faces of the others were dropped\n";
    if(conditioning.polygons_triangulated > 0)
      std::cerr << conditioning.polygons_triangulated << " polygons were split into triangles\n";
    if(conditioning.vertices_added > 0)
      std::cerr << conditioning.vertices_added << " vertices were added in polygons that no diagonal could split\n";
    if(conditioning.faces_reoriented > 0)
      std::cerr << conditioning.faces_reoriented << " faces were turned round to agree with their neighbors\n";
    if(conditioning.vertices_dropped > 0)
      std::cerr << conditioning.vertices_dropped
                << (conditioning.components > 1 ? " vertices without a kept face" : " isolated vertices")
                << " were dropped\n";
    if(result.cut.seam_edges > 0)
      std::cerr << "cut along " << result.cut.seam_edges << " edges, " << result.cut.cut_length << " sqrt(area) long\n";
    if(result.degenerate_faces > 0)
      std::cerr << result.degenerate_faces << " faces without area were mapped as if they were a little wide\n";
    if(result.border_edges_split > 0)
      std::cerr << "the border was too short for four corners: an edge of it was split\n";
    if(result.chords_split > 0)
      std::cerr << result.chords_split << " chords were split\n";
    std::cerr << "L2 stretch " << result.measures.l2 << " at candidate " << result.search.best_candidate << ", "
              << result.search.evaluations << " evaluated, " << seconds.total << " s\n";
  }
  return DONE;
}

} // namespace

int main(int argc, char** argv)
{
  const auto fail = [](const std::exception& error, Exit_status status) {
    std::cerr << "square_map: " << error.what() << '\n';
    return status;
  };
  try {
    const Command_line line = parse_command_line(argc, argv);
    if(line.wants_help) {
      std::cout << line.help;
      return DONE;
    }
    return run(line);
  } catch(const Usage_error& error) {
    return fail(error, BAD_COMMAND_LINE);
  } catch(const Output_error& error) {
    return fail(error, BAD_COMMAND_LINE);
  } catch(const Malformed_file& error) {
    return fail(error, BAD_FILE);
  } catch(const CGAL_ext::internal::Unmappable& error) {
    return fail(error, UNMAPPABLE);
  } catch(const std::bad_alloc&) {
    return fail(std::runtime_error("there is not enough memory for this surface"), UNMAPPABLE);
  } catch(const std::exception& error) {
    return fail(error, UNMAPPABLE);
  }
}
