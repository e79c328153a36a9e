// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_command_line_closed.h"

#include <sys/stat.h>

#include <chrono>
#include <optional>
#include <thread>

// Signals, and readers that go away: nothing is written, nothing is left.

namespace {

const Soup large = sheet(150, 150);

/// a run in a folder of its own that is sure to take longer than the test, with a map that exists and a report that
/// goes to a pipe: when the pipe is open the command is at work
class Long_run
{
public:
  explicit Long_run(
      const Arguments& options, const std::function<void()>& prepare = [] {}, const Soup& surface = large)
  {
    m_folder.add("map.obj", "my map");
    m_folder.add("in.off", off(surface));
    const std::string pipe = m_folder / "pipe", folder = m_folder / "";
    if(mkfifo(pipe.c_str(), 0600) != 0)
      throw std::runtime_error("cannot make a pipe");
    m_process.emplace(Arguments{"in.off", "-o", "map.obj", "--json", "pipe", "--strategy", "brute-force"} + options, "",
                      [folder, prepare] {
                        if(chdir(folder.c_str()) != 0)
                          _exit(126);
                        prepare();
                      });
    m_pipe = open(pipe.c_str(), O_RDONLY);
  }

  Long_run(const Long_run&) = delete;
  Long_run& operator=(const Long_run&) = delete;
  ~Long_run() { close(m_pipe); }

  void send(int signal) { m_process->send(signal); }

  /// waits for the end, and checks what must hold after each
  Finished_process end()
  {
    const Finished_process result = m_process->wait();
    CHECK(m_folder.file_names() == std::set<std::string>{"in.off", "map.obj", "pipe"});
    CHECK(read_file(m_folder / "map.obj") == "my map");
    char byte;
    CHECK(read(m_pipe, &byte, 1) == 0);
    return result;
  }

private:
  Temporary_folder m_folder;
  std::optional<Running_process> m_process;
  int m_pipe = -1;
};

} // namespace

TEST_CASE("a signal ends a run at once, and nothing is written")
{
  const std::vector<std::pair<int, std::string>> signals{
      {SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}, {SIGQUIT, "SIGQUIT"}};
  for(const auto& [signal, name] : signals)
    for(const char* threads : {"1", "3"}) {
      Long_run run({"--threads", threads});
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      const auto start = std::chrono::steady_clock::now();
      run.send(signal);
      run.send(signal); // a second one changes nothing
      const Finished_process result = run.end();
      INFO(name << ' ' << threads);
      CHECK(result.status == 128 + signal);
      CHECK(is_one_message(result.err, name + "; no file was replaced"));
      CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
    }
}

TEST_CASE("a signal ends a run that cuts, or that samples its map, and nothing is left")
{
  const std::vector<std::pair<Soup, Arguments>> runs{
      {soup_of(torus(120, 120)), {}},
      {small, {"--threads", "1", "--image", "image.png", "--grid-mesh", "grid.obj", "--resolution", "3000"}}};
  for(const auto& [surface, options] : runs) {
    Long_run run(
        options, [] {}, surface);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    run.send(SIGTERM);
    CHECK(run.end().status == 128 + SIGTERM);
  }
}

TEST_CASE("a signal ends a run whose messages nobody reads, and that has no more room for one")
{
  Long_run run({}, [] {
    int ends[2]; // the one to read from stays open
    if(pipe(ends) != 0 || fcntl(ends[1], F_SETFL, O_NONBLOCK) != 0)
      return;
    const std::string page(4096, ' ');
    while(write(ends[1], page.data(), page.size()) > 0) {
    }
    fcntl(ends[1], F_SETFL, 0);
    dup2(ends[1], STDERR_FILENO);
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const auto start = std::chrono::steady_clock::now();
  run.send(SIGINT);
  CHECK(run.end().status == 128 + SIGINT);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
}

TEST_CASE("a signal that the caller ignores stays ignored")
{
  Long_run run({}, [] { std::signal(SIGHUP, SIG_IGN); }); // as nohup does
  run.send(SIGHUP);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  run.send(SIGTERM);
  CHECK(run.end().status == 128 + SIGTERM);
}

TEST_CASE("a run that waits for the reader of its report can be interrupted")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  Running_process process({input, "-o", folder / "map.obj", "--json", pipe});
  std::this_thread::sleep_for(std::chrono::milliseconds(500)); // to the opening of the pipe
  process.send(SIGINT);
  CHECK(process.wait().status == 128 + SIGINT);
  CHECK(folder.file_names() == std::set<std::string>{"in.off", "pipe"});
}

TEST_CASE("a run that waits for the reader of its report, with the map written elsewhere, leaves nothing of it")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(20, 20))), pipe = folder / "pipe";
  folder.add("map.obj", "my map");
  const std::set<std::string> names{"in.off", "map.obj", "pipe"};
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  for(const bool is_ended_by_signal : {true, false}) {
    Running_process process({input, "-q", "-o", folder / "map.obj", "--json", pipe, "--strategy", "brute-force"});
    const int reader = open(pipe.c_str(), O_RDONLY); // of which nothing is read
    fcntl(reader, F_SETPIPE_SZ, 4096);
    while(folder.file_names() == names) // until the report is being written, which is longer
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if(is_ended_by_signal)
      process.send(SIGTERM);
    else
      close(reader);
    const Finished_process result = process.wait();
    if(is_ended_by_signal)
      close(reader);
    CHECK(result.status == (is_ended_by_signal ? 128 + SIGTERM : BAD_COMMAND_LINE));
    CHECK(is_one_message(result.err, is_ended_by_signal ? "ended by SIGTERM; no file was replaced"
                                                        : "cannot write '" + pipe + "': its reader has gone"));
    CHECK(read_file(folder / "map.obj") == "my map");
    CHECK(folder.file_names() == names);
  }
}

TEST_CASE("a reader that has gone does not kill, and nothing is written")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), map = folder.add("map.obj", "my map");
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  close(ends[0]);
  const Finished_process result =
      square_map({input, "-o", map, "--json", "-"}, "", [&] { dup2(ends[1], STDOUT_FILENO); });
  close(ends[1]);
  CHECK(result.status == BAD_COMMAND_LINE);
  CHECK(is_one_message(result.err, "cannot write to standard output: its reader has gone"));
  CHECK(read_file(map) == "my map");
  CHECK(folder.file_names() == std::set<std::string>{"in.off", "map.obj"});
}

TEST_CASE("closed standard streams are not mistaken for outputs")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), map = folder / "map.obj";
  const auto close_all = [] {
    for(int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      close(stream);
  };
  CHECK(square_map({input, "-o", map, "--json", "-"}, "", close_all).status == BAD_COMMAND_LINE);
  for(const char* name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "/dev/stderr"})
    CHECK(square_map({input, "-o", map, "--json", name}, "", close_all).status == BAD_COMMAND_LINE);
  CHECK(square_map({"/dev/stdin", "-o", map}, "", close_all).status == BAD_FILE);
  CHECK(folder.file_names() == std::set<std::string>{"in.off"});
  const Finished_process result = square_map({input, "--json", "/dev/stdout"}, "", [] { close(STDOUT_FILENO); });
  CHECK(result.status == BAD_COMMAND_LINE);
  CHECK(is_one_message(result.err, "cannot write '/dev/stdout': it is closed"));
  const Finished_process folder_of_streams = square_map({input, "--json", "/dev/fd"}, "", [] { close(STDIN_FILENO); });
  CHECK(is_one_message(folder_of_streams.err, "cannot write '/dev/fd': it is a folder"));
  CHECK(square_map({input, "-o", map, "--json", folder / "report.json"}, "", close_all).status == DONE);
  CHECK(read_obj_map(read_file(map)).uv.size() == small.points.size());
  CHECK(nlohmann::json::parse(read_file(folder / "report.json")).is_object());
  CHECK(read_file(input) == off(small));
}
