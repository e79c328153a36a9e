// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_TEMPORARY_FOLDER_H
#define TEST_TEMPORARY_FOLDER_H

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

// Files of tests, in folders that vanish.

inline std::string read_file(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void write_file(const std::filesystem::path& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

/// a new empty folder that is removed with all it holds
class Temporary_folder
{
public:
  Temporary_folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "square_map_test_XXXXXX").string();
    if(mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("cannot make a folder " + name);
    m_path = name;
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  ~Temporary_folder()
  {
    std::error_code error;
    std::filesystem::remove_all(m_path, error);
  }

  std::string operator/(const std::string& name) const { return (m_path / name).string(); }

  /// writes a file and returns its path
  std::string add(const std::string& name, const std::string& text) const
  {
    write_file(m_path / name, text);
    return *this / name;
  }

  std::set<std::string> file_names() const
  {
    std::set<std::string> names;
    for(const auto& entry : std::filesystem::directory_iterator(m_path))
      names.insert(entry.path().filename().string());
    return names;
  }

private:
  std::filesystem::path m_path;
};

#endif // TEST_TEMPORARY_FOLDER_H
