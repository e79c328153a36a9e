// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Temporary_folder.h"
#include "square_map/Output_set.h"

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <set>
#include <string>
#include <vector>

// The outputs of a run, without the rest of the command: what happens between opening and renaming can be had here.

namespace {

long allocations_allowed = -1; // by `new`; all when negative

} // namespace

[[gnu::noinline]] void* operator new(std::size_t size)
{
  void* const block = allocations_allowed == 0 ? nullptr : std::malloc(size);
  if(block == nullptr)
    throw std::bad_alloc();
  if(allocations_allowed > 0)
    --allocations_allowed;
  return block;
}

[[gnu::noinline]] void operator delete(void* block) noexcept
{
  std::free(block);
}

[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept
{
  std::free(block);
}

namespace {

square_map::Output_set::Write_text text(const char* words)
{
  return [words](std::ostream& stream) { stream << words; };
}

/// the exit status of a process that does something
int status_of(const std::function<void()>& act)
{
  const pid_t child = fork();
  if(child == 0) {
    square_map::run_phase = square_map::Run_phase::WORKING; // other tests have committed
    act();
    _exit(7);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace

TEST_CASE("when one of several outputs cannot take its place the others are as they were")
{
  const Temporary_folder folder;
  folder.add("first", "old first");
  folder.add("third", "old third");
  {
    square_map::Output_set outputs;
    outputs.add(folder / "first", text("new first"));
    outputs.add(folder / "second", text("new second")); // was not there
    outputs.add(folder / "third", text("new third"));
    // what made the first two fail is met after they were renamed
    outputs.add(folder / "last", [&folder](std::ostream&) { std::filesystem::create_directory(folder / "last"); });
    REQUIRE_THROWS_WITH(outputs.write_and_commit(), Catch::Matchers::Contains("last': it is a folder"));
  }
  CHECK(read_file(folder / "first") == "old first");
  CHECK(read_file(folder / "third") == "old third");
  CHECK(folder.file_names() == std::set<std::string>{"first", "third", "last"} /* without temporary files */);
}

TEST_CASE("when all outputs can take their places nothing of the former ones is left")
{
  const Temporary_folder folder;
  folder.add("first", "old first");
  square_map::Output_set outputs;
  outputs.add(folder / "first", text("new first"));
  outputs.add("", text("no output"));
  outputs.add(folder / "second", text("new second"));
  CHECK(folder.file_names() == std::set<std::string>{"first"}); // there is no temporary file while others work
  outputs.write_and_commit();
  CHECK(read_file(folder / "first") == "new first");
  CHECK(read_file(folder / "second") == "new second");
  CHECK(folder.file_names() == std::set<std::string>{"first", "second"});
}

TEST_CASE("an output whose text cannot be made leaves all as it was")
{
  const Temporary_folder folder;
  folder.add("first", "old first");
  {
    square_map::Output_set outputs;
    outputs.add(folder / "first", text("new first"));
    outputs.add(folder / "second", [](std::ostream&) { throw std::runtime_error("no text"); });
    REQUIRE_THROWS_WITH(outputs.write_and_commit(), "no text");
  }
  CHECK(read_file(folder / "first") == "old first");
  CHECK(folder.file_names() == std::set<std::string>{"first"});
}

TEST_CASE("no signal ends the process while the outputs take their places, the second one does when they have them")
{
  using namespace square_map;
  const auto committing = [](int signals) {
    handle_signals();
    begin_commit();
    for(int i = 0; i < signals; ++i)
      raise(SIGTERM);
  };
  CHECK(status_of([] {
          handle_signals();
          raise(SIGTERM);
        }) == 128 + SIGTERM);
  CHECK(status_of([&] { committing(3); }) == 7);
  CHECK(status_of([&] {
          committing(1);
          end_commit();
          raise(SIGINT);
        }) == 128 + SIGINT);
  CHECK(status_of([&] {
          committing(0);
          end_commit();
          raise(SIGINT);
        }) == 7);
}

TEST_CASE("an allocation that fails while the outputs take their places leaves all as it was")
{
  const Temporary_folder folder;
  const std::vector<std::string> names{"first", "second", "third"};
  bool has_failed = false, is_done = false;
  for(long allowed = 0; !is_done; ++allowed) {
    INFO(allowed);
    for(const std::string& name : names)
      folder.add(name, "old");
    {
      square_map::Output_set outputs;
      for(const std::string& name : names)
        outputs.add(folder / name, text("new"));
      allocations_allowed = allowed;
      try {
        outputs.write_and_commit();
        is_done = true;
      } catch(const std::bad_alloc&) {
        has_failed = true;
      }
      allocations_allowed = -1;
    }
    for(const std::string& name : names)
      CHECK(read_file(folder / name) == (is_done ? "new" : "old"));
    CHECK(folder.file_names() == std::set<std::string>(names.begin(), names.end()) /* without temporary files */);
  }
  CHECK(has_failed);
}

TEST_CASE("a signal removes the temporary file of a text that has not taken its place")
{
  const Temporary_folder folder;
  folder.add("map", "old");
  CHECK(status_of([&folder] {
          square_map::handle_signals();
          square_map::Output_file file(folder / "map");
          file.write(text("new"));
          if(folder.file_names().size() == 2)
            raise(SIGTERM);
        }) == 128 + SIGTERM);
  CHECK(read_file(folder / "map") == "old");
  CHECK(folder.file_names() == std::set<std::string>{"map"});
}
