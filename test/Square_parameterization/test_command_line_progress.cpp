// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"
#include "test_command_line_closed.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <utility>

// The progress line: on a terminal, and nowhere else.

namespace {

/// what the command writes to a terminal, as its standard error
struct On_terminal
{
  /// \param signal sent as soon as something is written; 0 for none
  explicit On_terminal(const Arguments& arguments, unsigned short columns = 200, int signal = 0)
  {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    REQUIRE(terminal >= 0);
    REQUIRE(grantpt(terminal) == 0);
    REQUIRE(unlockpt(terminal) == 0);
    winsize size = {};
    size.ws_row = 24;
    size.ws_col = columns;
    REQUIRE(ioctl(terminal, TIOCSWINSZ, &size) == 0);
    const std::string name = ptsname(terminal);
    Running_process process(arguments, "", [&name] { dup2(open(name.c_str(), O_WRONLY | O_NOCTTY), STDERR_FILENO); });
    char bytes[4096];
    for(ssize_t count = 0; (count = read(terminal, bytes, sizeof bytes)) > 0;) { // fails when the process has ended
      text.append(bytes, static_cast<std::size_t>(count));
      process.send(std::exchange(signal, 0)); // 0 is sent to nobody
    }
    status = process.wait().status;
    close(terminal);
  }

  /// the lines that took each other's place, and those that stayed
  std::vector<std::string> lines() const
  {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for(std::string line; std::getline(stream, line, '\r');) {
      line.erase(line.find_last_not_of(" \n") + 1);
      line.erase(0, line.find_first_not_of('\n'));
      if(!line.empty())
        result.push_back(line);
    }
    return result;
  }

  int status = -1;
  std::string text;
};

bool has_line(const std::vector<std::string>& lines, const std::string& words)
{
  for(const std::string& line : lines)
    if(line.rfind(words, 0) == 0)
      return true;
  return false;
}

} // namespace

TEST_CASE("on a terminal one line tells what is being done, and is gone at the end")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(soup_of(ellipsoid(4, 2))));
  const On_terminal run({input, "-o", folder / "map.obj", "--image", folder / "a.png", "--threads", "1"});
  CHECK(run.status == DONE);
  const std::vector<std::string> lines = run.lines();
  for(const char* phase :
      {"reading", "cutting", "cutting: ", "searching", "searching: ", "mapping", "sampling", "writing"})
    CHECK(has_line(lines, phase));
  int last = 0, cuts = 0;
  for(const std::string& line : lines)
    if(line.rfind("cutting: ", 0) == 0) {
      const int share = std::stoi(line.substr(9));
      CHECK(share >= last);
      CHECK(share <= 100);
      last = share;
      ++cuts;
    }
  CHECK(cuts > 5);
  CHECK(last >= 80);
  // the line is wiped out before the lines that stay
  const std::size_t message = run.text.find("cut along");
  REQUIRE(message != std::string::npos);
  CHECK(run.text[message - 1] == '\r');
  CHECK(run.text.find('\r', message) == run.text.find("\r\n", message));
}

TEST_CASE("candidates that are sketched, and corners that move, are on the line")
{
  const Temporary_folder folder;
  const On_terminal sketched({folder.add("large.off", off(sheet(92, 92)))});
  CHECK(sketched.status == DONE);
  CHECK(has_line(sketched.lines(), "searching: 32 candidates sketched"));
  const On_terminal moved({folder.add("in.off", off(sheet(12, 9))), "--aspect", "2"});
  CHECK(moved.status == DONE);
  CHECK(has_line(moved.lines(), "moving corners: 1 choice compared"));
  CHECK(has_line(moved.lines(), "moving corners: 100 choices compared"));
}

TEST_CASE("the progress line is no wider than the terminal")
{
  const Temporary_folder folder;
  const On_terminal run({folder.add("in.off", off(sheet(12, 9))), "-o", folder / "map.obj"}, 31);
  CHECK(run.status == DONE);
  CHECK(has_line(run.lines(), "searching: "));
  for(const std::string& line : run.lines())
    if(line.find("L2 stretch") == std::string::npos)
      CHECK(line.size() <= 30);
}

TEST_CASE("without a terminal, and when it is to be quiet, there is no progress line")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(sheet(12, 9)));
  CHECK(square_map({input}).err.find("searching") == std::string::npos);
  CHECK(square_map({input}).err.find('\r') == std::string::npos);
  CHECK(On_terminal({input, "--quiet"}).text == "");
}

TEST_CASE("a refusal takes the place of the progress line")
{
  const Temporary_folder folder;
  for(const std::string& input : {folder / "missing.off", folder.add("in.off", off(small))}) {
    const On_terminal run({input, "--corners", "0,1,1,2"});
    CHECK(run.status != DONE);
    const std::size_t message = run.text.find("square_map: ");
    REQUIRE(message != std::string::npos);
    CHECK(run.text[message - 1] == '\r');
    CHECK(run.text.find("\r\n") + 2 == run.text.size());
  }
}

TEST_CASE("the message of a signal begins on a line of its own")
{
  const Temporary_folder folder;
  const On_terminal run({folder.add("in.off", off(soup_of(ellipsoid(4, 2)))), "-o", folder / "map.obj"}, 200, SIGINT);
  CHECK(run.status == 128 + SIGINT);
  CHECK(run.text.find("\nsquare_map: interrupted by SIGINT; no file was replaced\r\n") != std::string::npos);
}
