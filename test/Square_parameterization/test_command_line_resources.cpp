// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_command_line_closed.h"

#include <sys/resource.h>

#include <chrono>

// Little memory, few threads, little time, small files.

namespace {

/// a limit that the process gets before it begins
std::function<void()> limited(int resource, rlim_t value)
{
  return [resource, value] {
    const rlimit limit{value, value};
    if(setrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0)
      _exit(126);
  };
}

/// the allocations from a number on fail, all or `count` of them
void let_allocations_fail(int from, const char* count)
{
  setenv("LD_PRELOAD", FAILING_RESOURCES, 1);
  setenv("FAILING_MALLOC_FROM", std::to_string(from).c_str(), 1);
  setenv("FAILING_MALLOC_COUNT", count, 1);
}

/// no thread from a number on can be made
void let_threads_fail(const char* from)
{
  setenv("LD_PRELOAD", FAILING_RESOURCES, 1);
  setenv("FAILING_THREADS_FROM", from, 1);
}

} // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which need more address space than there is
TEST_CASE("a run with more threads than there is room for makes the map with those it gets")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(20, 20)));
  const auto map_with = [&](const Arguments& options, const std::function<void()>& prepare) {
    CHECK(
        square_map(Arguments{input, "-q", "-o", folder / "map.obj", "--strategy", "brute-force"} + options, "", prepare)
            .status == DONE);
    return read_file(folder / "map.obj");
  };
  const std::string expected = map_with({"--threads", "1"}, [] {});
  CHECK(map_with({"--threads", "500"}, limited(RLIMIT_AS, 170 << 20)) == expected);
  CHECK(map_with({"--threads", "16"}, limited(RLIMIT_DATA, 60 << 20)) == expected);
  for(const char* from : {"0", "1", "3", "5", "9", "17", "21"}) // some are made before those that map
    CHECK(map_with({"--threads", "8"}, [from] { let_threads_fail(from); }) == expected);
}

TEST_CASE("where no thread can be made all outputs of a surface that is cut are as usual")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(soup_of(ellipsoid(4, 2))));
  const auto outputs_with = [&](const std::function<void()>& prepare) {
    Arguments arguments{input, "-q", "--threads", "8", "--resolution", "33"};
    const std::vector<std::array<std::string, 2>> outputs{
        {"-o", "map.glb"}, {"--svg", "map.svg"}, {"--image", "image.png"}, {"--grid-mesh", "grid.obj"}};
    for(const auto& [option, name] : outputs)
      arguments = arguments + Arguments{option, folder / name};
    CHECK(square_map(arguments, "", prepare).status == DONE);
    std::string texts;
    for(const auto& [option, name] : outputs)
      texts += read_file(folder / name);
    return texts;
  };
  const std::string expected = outputs_with([] {});
  CHECK(expected.size() > 1000);
  CHECK(outputs_with([] { let_threads_fail("0"); }) == expected);
}

TEST_CASE("an allocation that fails in any part of a job leaves the outputs as they were")
{
  const Temporary_folder folder;
  const Soup closed = soup_of(ellipsoid(0));
  folder.add("in.off", off(closed));
  folder.add("in.stl", stl(closed));
  folder.add("in.ply", ply(closed));
  folder.add("polygon.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n");
  folder.add("seams", "0 2\n");
  struct Job
  {
    Arguments arguments;
    std::string output_option, output;
  };
  const std::vector<Job> jobs{{{"in.off", "--resolution", "5"}, "--image", "image.png"},
                              {{"in.stl"}, "--svg", "map.svg"},
                              {{"in.ply", "--seams", "seams"}, "--report", "page.html"},
                              {{"polygon.obj", "--triangulate"}, "--thumbnail", "thumbnail.png"}};
  for(const Job& job : jobs) {
    const std::vector<std::string> outputs{"map.obj", "report.json", job.output};
    const Arguments arguments =
        job.arguments +
        Arguments{job.output_option, job.output, "-o", "map.obj", "--json", "report.json", "-q", "--threads", "1"};
    for(const std::string& output : outputs)
      folder.add(output, "mine");
    const std::set<std::string> names = folder.file_names();
    for(int from = 0, done = 0; done < 3 && from < 2000000; from += 1 + from / 8) {
      const Finished_process result = square_map(arguments, "", [&] {
        if(chdir((folder / "").c_str()) != 0)
          _exit(126);
        let_allocations_fail(from, "-1");
      });
      INFO(job.output << " from " << from << ": " << result.err);
      CHECK(folder.file_names() == names);
      done += result.status == DONE;
      if(result.status != DONE) {
        CHECK(result.status == UNMAPPABLE);
        CHECK(is_one_message(result.err, "not enough memory"));
        for(const std::string& output : outputs)
          CHECK(read_file(folder / output) == "mine");
      }
      for(const std::string& output : outputs)
        folder.add(output, "mine");
    }
  }
}

TEST_CASE("an allocation that fails, whichever it is, ends in a sentence, and nothing is left")
{
  const Temporary_folder folder;
  const Soup soup = sheet(6, 6);
  const std::vector<std::string> inputs{folder.add("in.off", off(soup)), folder.add("in.ply", binary_ply(soup))};
  const std::set<std::string> names = folder.file_names();
  for(const std::string& input : inputs)
    for(const char* count : {"1", "-1"})
      for(int from = 0; from < 4000; from += 1 + from / 30) {
        const Finished_process result =
            square_map({input, "-q", "-o", folder / "map.obj", "--json", folder / "report.json", "--threads", "2"}, "",
                       [&] { let_allocations_fail(from, count); });
        INFO(count << " from " << from << ": " << result.err);
        if(result.status == DONE) { // the library did without, or there was nothing to fail any more
          std::filesystem::remove(folder / "map.obj");
          std::filesystem::remove(folder / "report.json");
        } else {
          CHECK(result.status == UNMAPPABLE);
          CHECK(is_one_message(result.err, "not enough memory"));
        }
        CHECK(folder.file_names() == names);
      }
}

TEST_CASE("memory lies on huge pages, but where the address space is limited, and the map is the same")
{
  const std::string setting = read_file("/sys/kernel/mm/transparent_hugepage/enabled");
  if(setting.find("[madvise]") == std::string::npos) {
    WARN("huge pages cannot be asked for here: " << setting);
    return;
  }
  const Temporary_folder folder;
  const auto page_faults_with = [&](const std::string& input, const char* threads, const std::string& output,
                                    const std::function<void()>& prepare) {
    rusage before = {}, after = {};
    getrusage(RUSAGE_CHILDREN, &before);
    CHECK(square_map({input, "-q", "--threads", threads, "-o", folder / output}, "", prepare).status == DONE);
    getrusage(RUSAGE_CHILDREN, &after);
    return after.ru_minflt - before.ru_minflt;
  };
  const std::string disk = folder.add("disk.off", off(sheet(60, 60))),
                    closed = folder.add("closed.off", off(soup_of(ellipsoid(5, 2))));
  for(const auto& [input, threads] : {std::pair(disk, "1"), std::pair(closed, "2")}) { // which take their share of it
    const long with_huge_pages = page_faults_with(input, threads, "huge.obj", [] {});
    const long without = page_faults_with(input, threads, "small.obj", limited(RLIMIT_AS, rlim_t(8) << 30));
    INFO(input << ": " << with_huge_pages << " and " << without);
    CHECK(2 * with_huge_pages < without);
    CHECK(read_file(folder / "huge.obj") == read_file(folder / "small.obj"));
  }
}

TEST_CASE("too low a limit of the stack ends in a sentence")
{
  const Temporary_folder folder;
  const Arguments arguments{folder.add("in.off", off(sheet(20, 20))), "-q", "-o", folder / "map.obj"};
  for(const int kilobytes : {64, 128, 511}) {
    const Finished_process result = square_map(arguments, "", limited(RLIMIT_STACK, kilobytes << 10));
    CHECK(result.status == UNMAPPABLE);
    CHECK(is_one_message(result.err, "the limit of the stack is too low: 512 kB are needed"));
  }
  CHECK(square_map(arguments, "", limited(RLIMIT_STACK, 512 << 10)).status == DONE);
}

TEST_CASE("lack of memory ends in a sentence, and nothing is left")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(40, 40)));
  std::set<int> statuses;
  for(rlim_t megabytes = 6; megabytes <= 60; megabytes += 3) {
    int status_of_one_thread = DONE;
    for(const std::string threads : {"1", "16"}) {
      const Finished_process result =
          square_map({input, "-q", "-o", folder / "map.obj", "--json", folder / "report.json", "--threads", threads},
                     "", limited(RLIMIT_AS, megabytes << 20));
      INFO(megabytes << " MB, " << threads << " threads: " << result.err);
      if(result.status == 127) // the loader has no room for the libraries
        continue;
      statuses.insert(result.status);
      CHECK((result.status == DONE || result.status == UNMAPPABLE));
      if(result.status != DONE) {
        CHECK(is_one_message(result.err, "not enough memory"));
        CHECK(folder.file_names() == std::set<std::string>{"in.off"});
      }
      if(threads == "1")
        status_of_one_thread = result.status;
      CHECK(result.status == status_of_one_thread); // where one thread has room the others do without
      std::filesystem::remove(folder / "map.obj");
      std::filesystem::remove(folder / "report.json");
    }
  }
  CHECK(statuses == std::set<int>{DONE, UNMAPPABLE}); // both were met
}
#endif

TEST_CASE("a file that grows beyond the limit of its size is refused, and nothing is left")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(20, 20)));
  const Finished_process result = square_map({input, "-q", "-o", folder / "map.obj"}, "", limited(RLIMIT_FSIZE, 5000));
  CHECK(result.status == BAD_COMMAND_LINE);
  CHECK(is_one_message(result.err, "the file would be larger than allowed"));
  CHECK(folder.file_names() == std::set<std::string>{"in.off"});
}

TEST_CASE("a time limit gives the best map so far, and the report says so")
{
  const Soup soup = sheet(100, 100);
  const Arguments all{"--strategy", "brute-force", "--threads", "1"};
  const auto start = std::chrono::steady_clock::now();
  const Mapped mapped = check_map(soup, all + Arguments{"--time-limit", "1.5"});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20)); // all of it takes a minute
  CHECK(mapped.report["time_limit_reached"] == true);
  CHECK(mapped.report["evaluations"] < mapped.report["candidates"]);
  CHECK(mapped.messages.find("the time limit was reached") != std::string::npos);
  const Mapped whole = check_map(small, {"--time-limit", "1000"});
  CHECK(whole.report["time_limit_reached"] == false);
  CHECK(whole.text == check_map(small).text);
}

TEST_CASE("a time limit that leaves no time for a map ends with its own exit status")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  const std::vector<long> b = border_of(small.faces);
  for(const Arguments& options : {Arguments{}, Arguments{"--corners", corner_option({b[0], b[3], b[6], b[9]})}})
    check_refusal(folder, Arguments{input, "-o", folder / "map.obj", "--time-limit", "1e-9"} + options,
                  NO_ONE_TO_ONE_MAP, "the time limit was reached");
  for(const char* bad : {"0", "-1", "nan", "inf", "1e10", "soon", "1s", ""})
    check_refusal(folder, {input, "-o", folder / "map.obj", "--time-limit", bad}, BAD_COMMAND_LINE, "time-limit");
}
