// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random surfaces of the kinds that go wrong, up to middle size: whatever is mapped must be mapped one-to-one, with the
// stretch that is reported. One line a surface; the same seed gives the same surface and options.

#include "Random_surface.h"
#include "map_soup.h"
#include "random_choices.h"

#include <boost/program_options.hpp>

#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>

namespace {

struct Options
{
  unsigned int seed = 0, count = 0, threads = 1;
  int faces = 300;
  double seconds = 0;
  std::string folder;
};

void write_off(const Surface_soup& soup, const std::string& path)
{
  std::ofstream file(path);
  file.precision(17);
  file << "OFF\n" << soup.points.size() << ' ' << soup.faces.size() << " 0\n";
  for(const Eigen::Vector3d& p : soup.points)
    file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for(const auto& face : soup.faces) {
    file << face.size();
    for(std::size_t v : face)
      file << ' ' << v;
    file << '\n';
  }
  if(!file.flush())
    throw std::runtime_error("cannot write '" + path + "'");
}

/// maps a surface and tells what became of it. Throws when the map is wrong.
Outcome map_surface(const Surface_soup& soup, unsigned int seed, unsigned int threads)
{
  const auto start = std::chrono::steady_clock::now();
  const Mapped_soup mapped = map_soup(soup, random_choices(seed, threads));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if(mapped.outcome == Outcome::ONE_TO_ONE)
    std::cout << "mapped, L2 " << mapped.measures.l2;
  else
    std::cout << (mapped.outcome == Outcome::REFUSED ? "refused: " : "NO MAP: ") << mapped.message;
  std::cout << ", " << seconds.count() << " s" << std::endl;
  return mapped.outcome;
}

/// maps surface after surface until there are enough, or the time is up; false when a map was wrong
bool map_surfaces(const Options& options)
{
  const auto start = std::chrono::steady_clock::now();
  const auto is_over = [&](unsigned int done) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return options.count > 0 ? done == options.count : seconds.count() >= options.seconds;
  };
  unsigned int wrong = 0;
  std::map<Outcome, unsigned int> outcomes;
  for(unsigned int done = 0; !is_over(done); ++done) {
    const unsigned int seed = options.seed + done;
    const Random_surface surface(seed, options.faces);
    const Surface_soup& soup = surface.soup();
    std::cout << seed << ": " << surface.name() << ", " << soup.faces.size() << " faces: " << std::flush;
    if(!options.folder.empty()) {
      write_off(soup, options.folder + '/' + std::to_string(seed) + ".off");
      std::cout << "written" << std::endl;
      continue;
    }
    try {
      ++outcomes[map_surface(soup, seed, options.threads)];
    } catch(const std::exception& error) {
      std::cout << "WRONG: " << error.what() << std::endl;
      ++wrong;
    }
  }
  if(options.folder.empty())
    std::cout << outcomes[Outcome::ONE_TO_ONE] << " mapped, " << outcomes[Outcome::REFUSED] << " refused, "
              << outcomes[Outcome::UNMAPPED] << " without a map, " << wrong << " wrong" << std::endl;
  return wrong == 0;
}

} // namespace

int main(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options options;
  po::options_description list("options");
  auto add = list.add_options();
  add("help", "show this text");
  add("seed", po::value(&options.seed), "of the first surface, default 0; the others follow");
  add("count", po::value(&options.count), "how many surfaces; 0 (default): until the time is up");
  add("seconds", po::value(&options.seconds), "how long, without --count; default 0");
  add("faces", po::value(&options.faces), "of the largest surfaces, about; default 300");
  add("threads", po::value(&options.threads), "of each map; default 1");
  add("write", po::value(&options.folder), "a folder: the surfaces are written there as SEED.off, and not mapped");
  try {
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, list), given);
    po::notify(given);
    if(given.count("help") != 0) {
      std::cout << list;
      return EXIT_SUCCESS;
    }
    return map_surfaces(options) ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const std::exception& error) {
    std::cerr << "fuzz_surfaces: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
