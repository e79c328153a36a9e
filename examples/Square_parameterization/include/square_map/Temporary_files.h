// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_TEMPORARY_FILES_H
#define SQUARE_MAP_TEMPORARY_FILES_H

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstddef>
#include <cstring>
#include <string>

namespace square_map {

/// the temporary files that there are, in memory that lives as long as the process: a signal handler removes them, and
/// may neither lock nor allocate
class Temporary_files
{
public:
  /// \return the place of the file, for `remove()`; -1 when the name is too long to be a file, or all places are taken
  int add(const std::string& path)
  {
    if(path.size() >= PATH_MAX)
      return -1;
    for(std::size_t place = 0; place < m_files.size(); ++place)
      if(!m_files[place].is_taken) {
        std::memcpy(m_files[place].path, path.c_str(), path.size() + 1);
        m_files[place].is_taken = true;
        return static_cast<int>(place);
      }
    return -1;
  }

  /// forgets a file, which has got another name or is removed
  void forget(int place)
  {
    if(place >= 0)
      m_files[static_cast<std::size_t>(place)].is_taken = false;
  }

  /// removes all files; may be called by a signal handler
  void remove_all() const
  {
    for(const File& file : m_files)
      if(file.is_taken)
        unlink(file.path);
  }

private:
  struct File
  {
    std::atomic<bool> is_taken{false};
    char path[PATH_MAX] = {};
  };

  std::array<File, 16> m_files; // one output is written at a time, and all wait for their places
};

/// those of this process
inline Temporary_files temporary_files;

} // namespace square_map

#endif // SQUARE_MAP_TEMPORARY_FILES_H
