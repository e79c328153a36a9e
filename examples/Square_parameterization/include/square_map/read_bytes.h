// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_READ_BYTES_H
#define SQUARE_MAP_READ_BYTES_H

#include "Malformed_file.h"
#include "closed_streams.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <new>
#include <string>

namespace square_map {

/// the bytes of a file, and what kind of file it was
struct File_bytes
{
  std::string bytes;
  bool is_stream; ///< its name may say nothing about what it holds
};

/// a file that is open for reading, as long as it lives; standard input for "-"
class Input_descriptor
{
public:
  explicit Input_descriptor(const std::string& path) : m_is_standard_input(path == "-")
  {
    do
      m_descriptor = m_is_standard_input ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
    while(m_descriptor == -1 && errno == EINTR);
    if(m_descriptor == -1)
      throw Malformed_file(reason_of(errno));
  }

  Input_descriptor(const Input_descriptor&) = delete;
  Input_descriptor& operator=(const Input_descriptor&) = delete;

  ~Input_descriptor()
  {
    if(!m_is_standard_input)
      close(m_descriptor);
  }

  /// what `fstat()` says of the file
  struct stat status() const
  {
    struct stat status = {};
    if(fstat(m_descriptor, &status) != 0)
      throw Malformed_file(reason_of(errno));
    return status;
  }

  /// reads at most `size` bytes; 0 at the end
  std::size_t read(char* bytes, std::size_t size)
  {
    ssize_t count = 0;
    do
      count = ::read(m_descriptor, bytes, size);
    while(count == -1 && errno == EINTR);
    if(count == -1)
      throw Malformed_file(reason_of(errno));
    return static_cast<std::size_t>(count);
  }

  /// why a file cannot be read, in words
  static std::string reason_of(int error)
  {
    switch(error) {
    case ENOMEM:
      throw std::bad_alloc();
    case ENOENT:
      return "there is no such file";
    case EACCES:
    case EPERM:
      return "its permissions do not allow it";
    case ENOTDIR:
      return "a part of its path is not a folder";
    case EBADF:
      return "it is closed";
    default:
      return std::strerror(error);
    }
  }

private:
  bool m_is_standard_input;
  int m_descriptor = -1;
};

/// indicates whether a path names a stream that is open already: what the shell makes of `<(command)`, for example
inline bool names_open_stream(const std::string& path)
{
  return path == "-" || path == "/dev/stdin" || path.rfind("/dev/fd/", 0) == 0 || path.rfind("/proc/", 0) == 0;
}

/// reads a file, a pipe or, for "-", standard input, to its end. Folders and devices are refused, and files and streams
/// beyond an eighth of the memory of the machine, for no surface of their size could be mapped.
/// \throw Malformed_file with the reason alone
inline File_bytes read_bytes(const std::string& path)
{
  Input_descriptor file(path);
  const struct stat status = file.status();
  if(S_ISDIR(status.st_mode))
    throw Malformed_file(is_of_closed_stream(status) ? "it is closed" : "it is a folder");
  if((S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) && !names_open_stream(path))
    throw Malformed_file("it is a device; a file was expected");
  constexpr std::size_t CHUNK = 1 << 20;
  const std::size_t most =
      static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) / 8;
  File_bytes result{"", !S_ISREG(status.st_mode) || names_open_stream(path)};
  const std::size_t expected = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  if(expected <= most)
    result.bytes.reserve(expected + CHUNK);
  std::size_t size = 0;
  while(size <= most && expected <= most) {
    result.bytes.resize(size + CHUNK);
    const std::size_t count = file.read(result.bytes.data() + size, CHUNK);
    size += count;
    result.bytes.resize(size);
    if(count == 0)
      return result;
  }
  throw Malformed_file("it has more than " + std::to_string(most) + " bytes, an eighth of the memory of this machine");
}

} // namespace square_map

#endif // SQUARE_MAP_READ_BYTES_H
