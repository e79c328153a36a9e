// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "square_map/Output_set.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

// The outputs of a run, without the rest of the command: what happens between opening and renaming can be had here.

namespace {

namespace fs = std::filesystem;

/// an empty folder that vanishes
struct Folder
{
  fs::path path = fs::temp_directory_path() / ("output_set_test_" + std::to_string(getpid()));

  Folder() { fs::create_directory(path); }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const char* name) const { return (path / name).string(); }

  void add(const char* name, const char* text) const { std::ofstream(path / name) << text; }

  std::string text_of(const char* name) const
  {
    std::ifstream stream(path / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::set<std::string> names() const
  {
    std::set<std::string> names;
    for(const auto& entry : fs::directory_iterator(path))
      names.insert(entry.path().filename().string());
    return names;
  }
};

square_map::Output_set::Write_text text(const char* words)
{
  return [words](std::ostream& stream) { stream << words; };
}

} // namespace

TEST_CASE("when one of several outputs cannot take its place the others are as they were")
{
  const Folder folder;
  folder.add("first", "old first");
  folder.add("third", "old third");
  {
    square_map::Output_set outputs;
    outputs.add(folder / "first", text("new first"));
    outputs.add(folder / "second", text("new second")); // was not there
    outputs.add(folder / "third", text("new third"));
    // what made the first two fail is met after they were renamed
    outputs.add(folder / "last", [&folder](std::ostream&) { fs::create_directory(folder.path / "last"); });
    REQUIRE_THROWS_WITH(outputs.write_and_commit(), Catch::Contains("last': it is a folder"));
  }
  CHECK(folder.text_of("first") == "old first");
  CHECK(folder.text_of("third") == "old third");
  CHECK(folder.names() == std::set<std::string>{"first", "third", "last"} /* without temporary files */);
}

TEST_CASE("when all outputs can take their places nothing of the former ones is left")
{
  const Folder folder;
  folder.add("first", "old first");
  square_map::Output_set outputs;
  outputs.add(folder / "first", text("new first"));
  outputs.add("", text("no output"));
  outputs.add(folder / "second", text("new second"));
  CHECK(folder.names() == std::set<std::string>{"first"}); // there is no temporary file while others work
  outputs.write_and_commit();
  CHECK(folder.text_of("first") == "new first");
  CHECK(folder.text_of("second") == "new second");
  CHECK(folder.names() == std::set<std::string>{"first", "second"});
}

TEST_CASE("an output whose text cannot be made leaves all as it was")
{
  const Folder folder;
  folder.add("first", "old first");
  {
    square_map::Output_set outputs;
    outputs.add(folder / "first", text("new first"));
    outputs.add(folder / "second", [](std::ostream&) { throw std::runtime_error("no text"); });
    REQUIRE_THROWS_WITH(outputs.write_and_commit(), "no text");
  }
  CHECK(folder.text_of("first") == "old first");
  CHECK(folder.names() == std::set<std::string>{"first"});
}
