// examples/Square_parameterization/square_map.cpp
//
// Maps a triangle mesh onto the unit square from the command line; `square_map --help` lists the options.

#include "include/square_map/Output_file.h"
#include "include/square_map/messages.h"
#include "include/square_map/report.h"

#include <unistd.h>

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

/// the files that are written: both are opened first, and take their places together at the end
class Outputs
{
public:
  explicit Outputs(const Command_line& line)
  {
    if(!line.output.empty())
      m_map = std::make_unique<Output_file>(line.output);
    if(!line.json.empty() && line.json != "-")
      m_report = std::make_unique<Output_file>(line.json);
  }

  void write_map(Job& job)
  {
    if(!m_map)
      return;
    square_map::write_map(m_map->stream(), job.mesh, job.uv, job.originals, extension_of(job.line.output));
    m_map->close();
  }

  void write_report(const Job& job)
  {
    if(job.line.json.empty())
      return;
    std::ostream& stream = m_report ? static_cast<std::ostream&>(m_report->stream()) : std::cout;
    // a file name need not be UTF-8
    stream << make_report(job).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << std::endl;
    if(!stream)
      throw Output_error("cannot write the report to '" + job.line.json + "'");
    if(m_report)
      m_report->close();
  }

  void commit()
  {
    for(Output_file* file : {m_map.get(), m_report.get()})
      if(file != nullptr)
        file->commit();
  }

private:
  std::unique_ptr<Output_file> m_map, m_report;
};

CGAL_ext::internal::Surface_soup read_input(Job& job)
{
  CGAL_ext::internal::Surface_soup soup = read_soup(job.line.input, job.line.input_format, &job.passed_over);
  check_well_formed(soup, job.line.input);
  job.input_vertices = soup.points.size();
  job.input_faces = soup.faces.size();
  return soup;
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

/// makes the mesh, and of the vertices of the file that the command line names those of the mesh
void make_mesh_of(CGAL_ext::internal::Surface_soup soup, Job& job)
{
  Command_line& line = job.line;
  job.conditioning = condition(soup, line.conditioning_options);
  job.mesh = make_mesh(soup);
  if(!line.seams.empty())
    line.options.seams = edges_between(read_seams(line.seams, job.conditioning), job.mesh);
  if(line.corners)
    line.options.corners = mesh_vertices(*line.corners, job.conditioning);
  job.uncut_vertices = job.mesh.number_of_vertices();
  job.uv = job.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("h:uv").first;
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

/// maps the mesh. Throws for corners that are none; other failures are in the status of the result.
void map_mesh(Job& job)
{
  Command_line& line = job.line;
  Progress progress(line.minimizer == "optimal" ? "energy" : "stretch");
  if(!line.is_quiet && isatty(STDERR_FILENO) != 0)
    line.options.search_options.visitor = &progress;
  job.result = CGAL_ext::parameterize_onto_square(job.mesh, job.uv, CGAL_ext::parameters::options(line.options));
  line.options.search_options.visitor = nullptr;
  if(line.corners && job.result.status == CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER) {
    if(const auto k = job.result.wrong_corner) // the file numbers its vertices otherwise than the mesh
      throw Usage_error("corner vertex " + std::to_string((*line.corners)[*k]) + " is not on the border");
    throw Usage_error(job.result.message);
  }
  job.originals = originals_of(job.result, job.uncut_vertices);
}

/// runs the whole job; problems leave as exceptions, and with them no output file
Exit_status run(Command_line command_line)
{
  Stopwatch watch;
  Job job(std::move(command_line));
  const CGAL_ext::Square_map_result<Mesh>& result = job.result;
  CGAL_ext::internal::Surface_soup soup = read_input(job);
  job.seconds.read = watch.lap();
  Outputs outputs(job.line);
  make_mesh_of(std::move(soup), job);
  const double mesh_seconds = watch.lap();
  map_mesh(job);
  job.seconds.condition = mesh_seconds + result.condition_seconds;
  job.seconds.cut = result.cut_seconds;
  job.seconds.search = result.search_seconds;
  job.seconds.final = watch.lap() - result.cut_seconds - result.condition_seconds - result.search_seconds;
  if(result.status != CGAL::Surface_mesh_parameterization::OK) {
    std::cerr << "square_map: " << result.message << '\n';
    return result.search.evaluations == 0 ? UNMAPPABLE : NO_ONE_TO_ONE_MAP;
  }
  outputs.write_map(job);
  job.seconds.write = watch.lap();
  job.seconds.total = watch.total();
  outputs.write_report(job);
  outputs.commit();
  if(!job.line.is_quiet) {
    tell_passed_over(job.passed_over);
    tell_conditioning(job.conditioning);
    tell_map(result, job.seconds.total);
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
