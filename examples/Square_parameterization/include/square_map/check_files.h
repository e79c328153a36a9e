// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_CHECK_FILES_H
#define SQUARE_MAP_CHECK_FILES_H

#include "Output_target.h"
#include "Texture.h"
#include "option_effects.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace square_map {

/// refuses what is no name of a file. A value that begins with a dash is an option whose predecessor lacks its value.
inline void check_file_name(const std::string& option, const std::string& name)
{
  if(name.empty())
    throw Usage_error("--" + option + " needs the name of a file");
  if(name[0] == '-' && name != "-")
    throw Usage_error("--" + option + " needs the name of a file, not the option " + name +
                      "; a file of this name is ./" + name);
}

/// the same of a file that is read beside the surface, which alone may come from standard input
inline void check_input_name(const std::string& option, const std::string& name)
{
  check_file_name(option, name);
  if(name == "-")
    throw Usage_error("--" + option + " needs the name of a file: - is standard input for the surface alone");
}

/// indicates whether two paths lead to one thing that is there: a file, a folder, or a pipe, which
/// `std::filesystem::equivalent()` does not compare
inline bool is_same_thing(const std::filesystem::path& a, const std::filesystem::path& b)
{
  struct stat of_a = {}, of_b = {};
  return stat(a.c_str(), &of_a) == 0 && stat(b.c_str(), &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
         of_a.st_ino == of_b.st_ino;
}

/// indicates whether two names stand for one file, be there one or not yet: however they are spelled, through links, and
/// also when one of them is `-`, and standard output goes to the file of the other
inline bool is_same_file(const std::string& a, const std::string& b)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const auto is_stream = [](const std::string& name) { return name == "-"; };
  if(is_stream(a) && is_stream(b)) // one text would follow the other, also on a terminal
    return true;
  const fs::path path_a = is_stream(a) ? "/dev/stdout" : a, path_b = is_stream(b) ? "/dev/stdout" : b;
  if(fs::is_character_file(path_a, error)) // a terminal, or /dev/null: several may write there
    return false;
  const auto full_path = [&error](const fs::path& path) {
    fs::path absolute = fs::absolute(path, error); // none when the working folder is gone
    throw_if_out_of_memory(error);
    if(error)
      return path.lexically_normal();
    fs::path canonical = fs::weakly_canonical(absolute, error); // none where a closed folder is on the way
    throw_if_out_of_memory(error);
    return error ? absolute.lexically_normal() : canonical;
  };
  return full_path(path_a) == full_path(path_b) || is_same_thing(path_a, path_b);
}

/// refuses a file whose extension is none of those that are known
inline void check_extension(const std::string& what, const std::string& name,
                            const std::vector<std::string>& extensions)
{
  const auto is_known = [&extensions](const std::string& file) {
    return std::find(extensions.begin(), extensions.end(), output_extension(file)) != extensions.end();
  };
  if(name.empty() || is_known(name))
    return;
  if(is_known("x" + std::filesystem::path(name).filename().string()))
    throw Usage_error(what + " '" + name + "' has no name before its extension");
  std::string list;
  for(std::size_t k = 0; k < extensions.size(); ++k)
    list += (k == 0 ? "." : k + 1 == extensions.size() ? " or ." : ", .") + extensions[k];
  throw Usage_error(what + " '" + name + "' must end in " + list);
}

/// indicates whether an OBJ file gets a material and a picture beside it
inline bool has_material(const Command_line& line)
{
  return !line.texture.empty() && output_extension(line.output) == "obj";
}

/// checks the names of the files: outputs have known extensions, and no file is named twice
inline void check_files(const Command_line& line)
{
  check_extension("the output", line.output, {"obj", "off", "ply", "stl", "glb"});
  check_extension("the image", line.image, {"png", "exr"});
  check_extension("the page", line.page, {"html", "htm"});
  check_extension("the thumbnail", line.thumbnail, {"png"});
  check_extension("the normal map", line.normal_map, {"png"});
  check_extension("the picture of the attributes", line.attributes, {"png"});
  check_extension("the grid mesh", line.grid_mesh, {"obj", "off", "ply", "stl"});
  std::error_code error; // standard input may be a file, too; what is read of a pipe is nobody's output
  const std::string stream = std::filesystem::is_regular_file("/dev/stdin", error) ? "/dev/stdin" : "";
  std::vector<std::string> files{line.input == "-" ? stream : line.input,
                                 line.seams,
                                 line.output,
                                 line.json,
                                 line.texture == "checker" ? "" : line.texture,
                                 line.svg,
                                 line.page,
                                 line.thumbnail,
                                 line.image,
                                 line.normal_map,
                                 line.attributes,
                                 line.grid_mesh};
  files.insert(files.end(), line.curves.begin(), line.curves.end());
  if(has_material(line)) {
    if(line.output.find_first_of("\r\n") != std::string::npos)
      throw Usage_error("the name of the output has a line break: no .obj file can name its material so");
    files.push_back(beside(line.output, ".mtl"));
    if(const std::string picture = beside(line.output, ".png"); !is_same_file(line.texture, picture))
      files.push_back(picture);
  }
  for(std::size_t i = 0; i < files.size(); ++i)
    for(std::size_t j = i + 1; j < files.size(); ++j)
      if(!files[i].empty() && !files[j].empty() && is_same_file(files[i], files[j]))
        throw Usage_error("'" + files[i] + "' and '" + files[j] + "' are the same file");
}

} // namespace square_map

#endif // SQUARE_MAP_CHECK_FILES_H
