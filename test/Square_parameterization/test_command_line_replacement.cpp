// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_command_line_checks.h"

#include <sys/stat.h>

// How outputs take the place of what was there: all or none, as they were named, with what they were.

namespace {

mode_t mode_of(const std::string& path)
{
  struct stat status = {};
  stat(path.c_str(), &status);
  return status.st_mode & 07777;
}

} // namespace

TEST_CASE("a report that cannot be written leaves the old map")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), map = folder.add("map.obj", "my map");
  std::filesystem::create_directory(folder / "folder");
  for(const char* report : {"missing/report.json", "folder", "in.off/report.json"}) {
    check_refusal(folder, {input, "-o", map, "--json", folder / report}, BAD_COMMAND_LINE, "cannot write");
    CHECK(read_file(map) == "my map");
  }
  for(const char* full : {"/dev/full", "-"}) {
    const Finished_process result = square_map({input, "-q", "-o", map, "--json", full}, "/dev/full");
    CHECK(result.status == BAD_COMMAND_LINE);
    CHECK(is_one_message(result.err, "no space left on the device"));
    CHECK(read_file(map) == "my map");
    CHECK(folder.file_names() == std::set<std::string>{"folder", "in.off", "map.obj"});
  }
}

TEST_CASE("the reason why an output cannot be written is told")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), read_only = folder.add("read_only.obj", "mine");
  std::filesystem::create_directory(folder / "folder.obj");
  std::filesystem::create_symlink("nowhere.obj", folder / "dangling.obj");
  chmod(read_only.c_str(), 0444);
  const std::vector<std::pair<std::string, std::string>> reasons{
      {"missing/map.obj", "no such folder"}, {"in.off/map.obj", "no such folder"},
      {"folder.obj", "it is a folder"},      {"dangling.obj", "it is a link to a file that does not exist"},
      {"read_only.obj", "it is read-only"},  {std::string(252, 'a') + ".obj", "the name is too long"}};
  for(const auto& [name, reason] : reasons) {
    const std::string output = folder / name;
    check_refusal(folder, {input, "-o", output}, BAD_COMMAND_LINE, "cannot write '" + output + "': " + reason);
  }
  CHECK(read_file(read_only) == "mine");
  chmod(folder.add("folder.obj/writable.obj", "").c_str(), 0666);
  chmod((folder / "folder.obj").c_str(), 0555);
  for(const char* name : {"folder.obj/map.obj", "folder.obj/writable.obj"})
    check_refusal(folder, {input, "-o", folder / name}, BAD_COMMAND_LINE, "permission denied in its folder",
                  heed_permissions);
}

TEST_CASE("a file may have the longest name that there is")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), name = std::string(251, 'a') + ".obj";
  CHECK(square_map({input, "-q", "-o", folder / name}).status == DONE);
  CHECK(square_map({input, "-q", "-o", folder / name}).status == DONE); // in its place
  CHECK(folder.file_names() == std::set<std::string>{"in.off", name});
}

TEST_CASE("the mode and the owner of an existing file are kept")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), map = folder.add("map.obj", "my map");
  for(mode_t mode : {0600, 0640, 0666, 0755}) {
    chmod(map.c_str(), mode);
    if(geteuid() == 0)
      REQUIRE(chown(map.c_str(), 12345, 54321) == 0);
    CHECK(square_map({input, "-q", "-o", map}).status == DONE);
    CHECK(read_file(map) != "my map");
    CHECK(mode_of(map) == mode);
    struct stat status = {};
    CHECK(stat(map.c_str(), &status) == 0);
    if(geteuid() == 0) {
      CHECK(status.st_uid == 12345);
      CHECK(status.st_gid == 54321);
    }
  }
  for(const mode_t mask : {027, 0222}) { // of the second one who opens the file once more has no right to write
    const mode_t before = umask(mask);
    CHECK(square_map({input, "-q", "-o", folder / "new.obj"}).status == DONE);
    umask(before);
    CHECK(mode_of(folder / "new.obj") == (0666 & ~mask));
    std::filesystem::remove(folder / "new.obj");
  }
}

TEST_CASE("what the owner or the group of a file was trusted with is not passed on to others")
{
  constexpr uid_t NOBODY = 65534;
  if(geteuid() != 0)
    return; // only the superuser can be another user
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), map = folder.add("map.obj", "my map");
  std::filesystem::permissions(folder / "", std::filesystem::perms::all);
  const auto as_nobody = [] { REQUIRE((setgid(NOBODY) == 0 && setuid(NOBODY) == 0)); };
  for(const auto& [before, after] :
      {std::pair<mode_t, mode_t>{04777, 0777}, {02777, 0777}, {0662, 0622}, {0606, 0600}}) {
    REQUIRE(chown(map.c_str(), 12345, 54321) == 0);
    chmod(map.c_str(), before);
    CHECK(square_map({input, "-q", "-o", map}, "", as_nobody).status == DONE);
    CHECK(read_file(map) != "my map");
    CHECK(mode_of(map) == after);
  }
}

TEST_CASE("two outputs that are one file are refused, however they are spelled")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), name = folder / "";
  std::filesystem::create_directory(folder / "folder");
  std::filesystem::create_directory_symlink(folder / "folder", folder / "link");
  const auto in_folder = [&] { REQUIRE(chdir(name.c_str()) == 0); };
  const std::vector<std::array<std::string, 2>> pairs{{"x.obj", "./x.obj"},
                                                      {"x.obj", "folder/../x.obj"},
                                                      {"./x.obj", folder / "x.obj"},
                                                      {"folder/x.obj", "link/x.obj"},
                                                      {"link/../x.obj", "x.obj"}};
  for(bool exists : {false, true})
    for(const auto& [a, b] : pairs) {
      if(exists) {
        folder.add("x.obj", "mine");
        folder.add("folder/x.obj", "mine");
      }
      INFO(a << ' ' << b << ' ' << exists);
      const Finished_process result = square_map({input, "-o", a, "--json", b}, "", in_folder);
      CHECK(result.status == BAD_COMMAND_LINE);
      CHECK(is_one_message(result.err, "are the same file"));
      CHECK(std::filesystem::exists(folder / "x.obj") == exists);
      CHECK(std::filesystem::exists(folder / "folder/x.obj") == exists);
      if(exists)
        CHECK(read_file(folder / "x.obj") == "mine");
    }
  std::filesystem::create_symlink("x.obj", folder / "link.obj");
  std::filesystem::create_hard_link(folder / "x.obj", folder / "hard.obj");
  for(const char* other : {"link.obj", "hard.obj"})
    check_refusal(folder, {input, "-o", folder / "x.obj", "--json", folder / other}, BAD_COMMAND_LINE,
                  "are the same file");
  for(const char* stream : {"", "/dev/null"}) {
    const Finished_process result = square_map({input, "--json", "-", "--svg", "-"}, stream);
    CHECK(result.status == BAD_COMMAND_LINE);
    CHECK(is_one_message(result.err, "'-' and '-' are the same file"));
  }
  // standard output goes to the map
  const Finished_process result = square_map({input, "-o", folder / "x.obj", "--json", "-"}, folder / "x.obj");
  CHECK(result.status == BAD_COMMAND_LINE);
  CHECK(read_file(folder / "x.obj") == "mine");
  // another case is another file
  CHECK(square_map({input, "-q", "-o", folder / "a.obj", "--json", folder / "A.obj"}).status == DONE);
  CHECK(nlohmann::json::parse(read_file(folder / "A.obj")).is_object());
}

TEST_CASE("two outputs that are one pipe are refused, however they are spelled")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  std::filesystem::create_hard_link(folder / "pipe", folder / "other");
  for(const auto& [a, b] : std::vector<std::array<std::string, 2>>{
          {folder / "pipe", folder / "other"}, {"/dev/fd/1", "-"}, {"/proc/self/fd/1", "/dev/stdout"}}) {
    const Finished_process result = square_map({input, "--svg", a, "--json", b}); // standard output is a pipe
    CHECK(result.status == BAD_COMMAND_LINE);
    CHECK(is_one_message(result.err, "are the same file"));
  }
}

TEST_CASE("a pipe and a device are written in place")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), pipe = folder / "pipe.obj";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  Running_process process({input, "-q", "-o", pipe, "--json", "/dev/null"});
  CHECK(read_obj_map(read_file(pipe)).uv.size() == small.points.size());
  CHECK(process.wait().status == DONE);
  CHECK(std::filesystem::is_fifo(pipe));
  CHECK(std::filesystem::is_character_file("/dev/null"));
  const Finished_process to_stream = square_map({input, "-q", "--json", "/dev/stdout"});
  CHECK(to_stream.status == DONE);
  CHECK(nlohmann::json::parse(to_stream.out).is_object());
}

TEST_CASE("in a working folder whose path is longer than paths may be, outputs are written by a relative name")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small)), name(200, 'd');
  const auto in_deep_folder = [&] {
    REQUIRE(chdir((folder / "").c_str()) == 0);
    for(int depth = 0; depth < 25; ++depth) {
      mkdir(name.c_str(), 0700);
      REQUIRE(chdir(name.c_str()) == 0);
    }
  };
  for(int run = 0; run < 2; ++run) { // the second one replaces the files of the first
    const Finished_process result =
        square_map({input, "-o", "map.obj", "--svg", "map.svg", "--json", "report.json"}, "", in_deep_folder);
    INFO(result.err);
    CHECK(result.status == DONE);
  }
  const auto reads_map = [&] {
    in_deep_folder();
    std::ifstream map("map.obj");
    _exit(map.peek() == 'v' ? DONE : BAD_FILE);
  };
  CHECK(square_map({input}, "", reads_map).status == DONE);
}

TEST_CASE("in a working folder that is gone, outputs cannot be written by a relative name")
{
  const Temporary_folder folder;
  const std::string input = folder.add("in.off", off(small));
  std::filesystem::create_directory(folder / "gone");
  const auto in_gone = [&] {
    REQUIRE(chdir((folder / "gone").c_str()) == 0);
    std::filesystem::remove(folder / "gone");
  };
  const Finished_process result = square_map({input, "-o", "x.obj", "--json", "y.json"}, "", in_gone);
  CHECK(result.status == BAD_COMMAND_LINE);
  CHECK(is_one_message(result.err, "cannot write 'x.obj': no such folder"));
}
