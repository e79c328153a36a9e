// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OUTPUT_FILE_H
#define SQUARE_MAP_OUTPUT_FILE_H

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace square_map {

/// an output that cannot be written
struct Output_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// a file that appears whole or not at all: text goes to a file beside it, which takes its place in `commit()`.
/// Opened before any work is done, so that an output that cannot be written is told at once. A target that is not a
/// regular file (a device, a pipe) is written directly.
class Output_file
{
public:
  explicit Output_file(const std::string& path) : m_name(path)
  {
    namespace fs = std::filesystem;
    std::error_code error;
    m_target = fs::weakly_canonical(path, error);
    if(error || m_target.empty())
      m_target = path;
    if(fs::is_directory(m_target, error))
      throw Output_error("cannot write '" + path + "': it is a directory");
    m_is_direct = fs::exists(m_target, error) && !fs::is_regular_file(m_target, error);
    m_written = m_target;
    if(!m_is_direct)
      m_written += "." + std::to_string(getpid()) + ".part";
    m_stream.open(m_written);
    if(!m_stream)
      throw Output_error("cannot write '" + path + "'");
    m_stream.precision(17);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    std::error_code error;
    if(!m_is_committed && !m_is_direct) {
      m_stream.close();
      std::filesystem::remove(m_written, error);
    }
  }

  std::ofstream& stream() { return m_stream; }

  /// makes sure that all text has reached the disk
  void close()
  {
    m_stream.close();
    if(!m_stream)
      throw Output_error("cannot write '" + m_name + "': the disk may be full");
  }

  /// lets the file take its place; call `close()` first
  void commit()
  {
    std::error_code error;
    if(!m_is_direct)
      std::filesystem::rename(m_written, m_target, error);
    if(error)
      throw Output_error("cannot write '" + m_name + "': " + error.message());
    m_is_committed = true;
  }

private:
  std::string m_name;
  std::filesystem::path m_target, m_written;
  std::ofstream m_stream;
  bool m_is_direct = false;
  bool m_is_committed = false;
};

} // namespace square_map

#endif // SQUARE_MAP_OUTPUT_FILE_H
