// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The rooms of the house: folders of `internal/`, each of which includes only what lies below it, directly or through
// the public headers. Read from the sources themselves.

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// the rooms, lowest first; those of one floor do not know each other
const std::vector<std::vector<std::string>> FLOORS{{"common"},     {"patch", "soup"},  {"border", "energy", "surface"},
                                                   {"coarsening"}, {"iteration"},      {"minimization"},
                                                   {"search"},     {"cut", "plug_in"}, {"sampling"},
                                                   {"pipeline"}};

const fs::path PACKAGE = fs::path(INCLUDE_FOLDER) / "CGAL_ext/Square_parameterization";

/// the name without `_impl`: the definitions of a header belong to it, and each of the two includes the other
std::string without_impl(const std::string& header)
{
  const std::size_t impl = header.rfind("_impl.h");
  return impl == std::string::npos ? header : header.substr(0, impl) + ".h";
}

/// the headers of the package, as paths below its folder, each with those it includes
std::map<std::string, std::vector<std::string>> includes_of_headers()
{
  const std::string directive = "#include <CGAL_ext/Square_parameterization/"; // and a name, and >
  std::map<std::string, std::vector<std::string>> includes;
  for(const auto& entry : fs::recursive_directory_iterator(PACKAGE)) {
    if(entry.path().extension() != ".h")
      continue;
    const std::string header = without_impl(entry.path().lexically_relative(PACKAGE).generic_string());
    std::vector<std::string>& included = includes[header];
    std::ifstream file(entry.path());
    for(std::string line; std::getline(file, line);) {
      if(line.rfind(directive, 0) != 0)
        continue;
      const std::string name = without_impl(line.substr(directive.size(), line.find('>') - directive.size()));
      if(name != header)
        included.push_back(name);
    }
  }
  return includes;
}

/// the room of a header; empty for a public one
std::string room_of(const std::string& header)
{
  const std::string internal = "internal/";
  return header.rfind(internal, 0) == 0
             ? header.substr(internal.size(), header.find('/', internal.size()) - internal.size())
             : "";
}

int floor_of(const std::string& room)
{
  for(std::size_t floor = 0; floor < FLOORS.size(); ++floor)
    for(const std::string& name : FLOORS[floor])
      if(name == room)
        return static_cast<int>(floor);
  return -1;
}

bool may_know(const std::string& room, const std::string& other)
{
  return room == other || floor_of(other) < floor_of(room);
}

/// the headers of rooms that a header reaches: directly, or through public headers
void add_reached(const std::map<std::string, std::vector<std::string>>& includes, const std::string& header,
                 std::set<std::string>& visited)
{
  for(const std::string& included : includes.at(header))
    if(visited.insert(included).second && room_of(included).empty())
      add_reached(includes, included, visited);
}

} // namespace

TEST_CASE("every internal header is in a room of the house")
{
  const auto includes = includes_of_headers();
  REQUIRE(includes.size() > 80);
  std::set<std::string> rooms;
  for(const auto& entry : includes)
    if(entry.first.rfind("internal/", 0) == 0) {
      CAPTURE(entry.first);
      CHECK(floor_of(room_of(entry.first)) >= 0);
      rooms.insert(room_of(entry.first));
    }
  std::size_t planned = 0;
  for(const auto& floor : FLOORS)
    planned += floor.size();
  CHECK(rooms.size() == planned); // no room is empty
}

TEST_CASE("no room reaches up")
{
  const auto includes = includes_of_headers();
  std::size_t pairs = 0;
  for(const auto& entry : includes) {
    const std::string room = room_of(entry.first);
    if(room.empty())
      continue;
    std::set<std::string> reached;
    add_reached(includes, entry.first, reached);
    for(const std::string& header : reached) {
      const std::string other = room_of(header);
      if(other.empty())
        continue;
      ++pairs;
      INFO(entry.first << " reaches " << header);
      CHECK(may_know(room, other));
    }
  }
  CHECK(pairs > 100);
}

TEST_CASE("no header reaches itself")
{
  const auto includes = includes_of_headers();
  for(const auto& entry : includes) {
    std::set<std::string> all(entry.second.begin(), entry.second.end());
    std::vector<std::string> front(entry.second);
    while(!front.empty()) {
      const std::string header = front.back();
      front.pop_back();
      REQUIRE(includes.count(header) == 1); // what is included exists
      for(const std::string& included : includes.at(header))
        if(all.insert(included).second)
          front.push_back(included);
    }
    INFO(entry.first);
    CHECK(all.count(entry.first) == 0);
  }
}
