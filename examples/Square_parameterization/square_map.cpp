// examples/Square_parameterization/square_map.cpp
//
// Maps a triangle mesh onto the unit square from the command line; `square_map --help` lists the options.

#include "include/square_map/add_outputs.h"
#include "include/square_map/closed_streams.h"
#include "include/square_map/huge_pages.h"
#include "include/square_map/known_curve.h"
#include "include/square_map/messages.h"
#include "include/square_map/out_of_memory.h"
#include "include/square_map/sample_map.h"
#include "include/square_map/signals.h"
#include "include/square_map/spare_address_space.h"

#include <CGAL_ext/Square_parameterization/internal/common/Thread_team.h>

#include <CGAL/version_macros.h>

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

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

/// reads the texture, where there is to be one
void read_texture(Job& job)
{
  if(output_extension(job.line.output) == "glb" || has_material(job.line))
    job.texture = texture_file(job.line.texture);
}

CGAL_ext::internal::Surface_soup read_input(Job& job)
{
  const bool wants_colors = !job.line.attributes.empty();
  CGAL_ext::internal::Surface_soup soup =
      read_soup(job.line.input, job.line.input_format, &job.passed_over, wants_colors ? &job.input_colors : nullptr);
  if(wants_colors && job.input_colors.empty())
    throw Malformed_file("'" + job.line.input + "' has no colors of its vertices, which --attributes needs");
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
  // where memory is limited it is for the threads of the map
  CGAL_ext::internal::Thread_team team(has_limited_address_space() ? 1 : line.options.search_options.number_of_threads);
  const CGAL_ext::internal::Thread_team::Scope scope(team);
  job.conditioning = condition(soup, line.conditioning_options);
  job.mesh = make_mesh(soup);
  if(!line.seams.empty())
    line.options.seams = edges_of(read_seams(line.seams, job.conditioning), job.mesh, line.seams);
  if(line.corners)
    line.options.corners = mesh_vertices(*line.corners, job.conditioning);
  job.uncut_vertices = job.mesh.number_of_vertices();
  if(makes_image(line)) {
    line.options.seam_grid = line.resolution ? *line.resolution : default_resolution(job.uncut_vertices);
    line.options.fits_seam_grid = !line.resolution;
  }
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

/// tells what is wrong with the corners, by the numbers that the file has: those of the mesh may be others
[[noreturn]] void refuse_corners(const std::array<std::size_t, 4>& corners,
                                 const CGAL_ext::Square_map_result<Mesh>& result)
{
  if(result.wrong_corner)
    throw Usage_error("corner vertex " + std::to_string(corners[*result.wrong_corner]) + " is not on the border");
  if(!result.counter_clockwise_corners) {
    for(std::size_t v : corners)
      if(std::count(corners.begin(), corners.end(), v) > 1)
        throw Usage_error(result.message + ": vertex " + std::to_string(v) + " is named more than once");
    throw Usage_error(result.message);
  }
  std::string order;
  for(int k : *result.counter_clockwise_corners)
    order += (order.empty() ? "" : ",") + std::to_string(corners[k]);
  throw Usage_error(result.message + "; this would be: " + order);
}

/// refuses a corner that is not a vertex of the file
void check_corners(const Job& job)
{
  if(job.line.corners)
    for(std::size_t v : *job.line.corners)
      if(v >= job.input_vertices)
        throw Usage_error("corner vertex " + std::to_string(v) + " does not exist: the file has " +
                          counted(job.input_vertices, "vertex", "vertices") + ", counted from 0");
}

/// maps the mesh by as many threads as there is memory for: each needs some of its own
void map_by_threads_with_room(Job& job)
{
  CGAL_ext::Square_map_options<Mesh>& options = job.line.options;
  auto& threads = options.search_options.number_of_threads;
  const auto map = [&] {
    job.result = CGAL_ext::parameterize_onto_square(job.mesh, job.uv, CGAL_ext::parameters::options(options));
  };
  const std::size_t threads_that_fit = threads_with_room(job.mesh.number_of_vertices());
  if(threads_that_fit < CGAL_ext::internal::number_of_threads(threads))
    threads = static_cast<unsigned int>(threads_that_fit);
  try {
    map();
  } catch(const std::bad_alloc&) {
    if(threads == 1)
      throw;
    threads = 1;
    map();
  }
}

/// maps the mesh. Throws for corners that are none; other failures are in the status of the result.
void map_mesh(Job& job, Progress& progress)
{
  Command_line& line = job.line;
  progress.start("mapping");
  std::optional<Known_curve> curve;
  if(!line.curves.empty())
    curve = read_curves(line.curves);
  if(curve)
    line.options.search = curve->search(line.options.search);
  line.options.search_options.visitor = &progress;
  map_by_threads_with_room(job);
  line.options.search_options.visitor = nullptr;
  if(line.corners && job.result.status == CGAL::Surface_mesh_parameterization::ERROR_WRONG_PARAMETER)
    refuse_corners(*line.corners, job.result);
  if(curve)
    curve->complete(job.result.search);
  job.originals = originals_of(job.result, job.uncut_vertices);
}

/// indicates whether the curve of a slice is all that was asked for, and was found: that no candidate has a map is a
/// result then
bool has_curve_alone(const Job& job)
{
  const Command_line& line = job.line;
  const std::vector<std::string> maps{line.output,    line.svg,   line.page,       line.grid_mesh,
                                      line.thumbnail, line.image, line.normal_map, line.attributes};
  return line.candidates && job.result.search.evaluations > 0 && !job.result.search.is_cancelled &&
         std::all_of(maps.begin(), maps.end(), [](const std::string& name) { return name.empty(); });
}

/// threads beside the first, of a number in which 0 stands for all cores, but no more than there are cores for
unsigned int helpers_with_core(unsigned int threads)
{
  using namespace CGAL_ext::internal;
  return std::min(number_of_threads(threads), default_number_of_threads()) - 1;
}

/// runs the whole job; problems leave as exceptions, and with them no output file
Exit_status run(Command_line command_line)
{
  Stopwatch watch;
  if(!has_limited_address_space())
    use_huge_pages_in_threads(helpers_with_core(command_line.options.search_options.number_of_threads));
  Job job(std::move(command_line));
  const CGAL_ext::Square_map_result<Mesh>& result = job.result;
  Progress progress(job.line);
  progress.start("reading");
  CGAL_ext::internal::Surface_soup soup = read_input(job);
  check_corners(job);
  read_texture(job);
  job.seconds.read = watch.lap();
  Output_set outputs;
  add_outputs(job, watch, outputs);
  make_mesh_of(std::move(soup), job);
  const double mesh_seconds = watch.lap();
  map_mesh(job, progress);
  job.seconds.condition = mesh_seconds + result.condition_seconds;
  job.seconds.cut = result.cut_seconds;
  job.seconds.search = result.search_seconds;
  job.seconds.final = watch.lap() - result.cut_seconds - result.condition_seconds - result.search_seconds;
  if(result.status != CGAL::Surface_mesh_parameterization::OK) {
    progress.clear();
    std::cerr << "square_map: " << (result.search.is_cancelled ? "the time limit was reached: " : "") << result.message
              << '\n';
    if(has_curve_alone(job)) {
      outputs.write_and_commit();
      return DONE;
    }
    return result.search.evaluations == 0 && !result.search.is_cancelled ? UNMAPPABLE : NO_ONE_TO_ONE_MAP;
  }
  sample_map(job, progress);
  job.seconds.sample = watch.lap();
  job.seconds.total = watch.total(); // before the outputs are written
  progress.start("writing");
  outputs.write_and_commit();
  progress.clear();
  job.seconds.total = watch.total();
  if(!job.line.is_quiet) {
    tell_passed_over(job.passed_over);
    tell_conditioning(job.conditioning);
    if(has_reached_time_limit(job))
      std::cerr << "the time limit was reached: this is the best map so far\n";
    tell_map(result, job.seconds.total);
    tell_open_seams(result);
  }
  return DONE;
}

/// writes a text that was asked for, and nothing else
Exit_status show(const std::string& text)
{
  Output_file("-").write([&text](std::ostream& stream) { stream << text; });
  return DONE;
}

/// tells why there is no map, on one line: the name of a file may have others. Allocates for such a name alone: there may be
/// no memory left.
Exit_status fail(const char* reason, Exit_status status)
{
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  const std::string_view text(reason);
  if(std::any_of(text.begin(), text.end(), is_control)) {
    std::string line(text);
    std::replace_if(line.begin(), line.end(), is_control, '?');
    std::cerr << "square_map: " << line << '\n';
  } else
    std::cerr << "square_map: " << reason << '\n';
  return status;
}

} // namespace

int main(int argc, char** argv)
{
  open_standard_streams();
  handle_signals();
  if(!has_stack())
    return fail("the limit of the stack is too low: 512 kB are needed", UNMAPPABLE);
  if(has_limited_address_space())
    spare_address_space();
  else
    use_huge_pages();
  Out_of_memory::handle(UNMAPPABLE);
  try {
    const Command_line line = parse_command_line(argc, argv);
    if(line.wants_help)
      return show(line.help);
    if(line.wants_version)
      return show("square_map " SQUARE_MAP_VERSION " (CGAL " CGAL_VERSION_STR ")\n");
    return run(line);
  } catch(const Usage_error& error) {
    return fail(error.what(), BAD_COMMAND_LINE);
  } catch(const Output_error& error) {
    return fail(error.what(), BAD_COMMAND_LINE);
  } catch(const Malformed_file& error) {
    return fail(error.what(), BAD_FILE);
  } catch(const CGAL_ext::internal::Unmappable& error) {
    return fail(error.what(), UNMAPPABLE);
  } catch(const std::bad_alloc&) {
    return fail(OUT_OF_MEMORY, UNMAPPABLE);
  } catch(const std::system_error& error) { // a file system, too, may have no memory for its answer
    return fail(error.code() == std::errc::not_enough_memory ? OUT_OF_MEMORY : error.what(), UNMAPPABLE);
  } catch(const std::exception& error) {
    return fail(error.what(), UNMAPPABLE);
  }
}
