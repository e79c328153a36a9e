// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_CLOSED_STREAMS_H
#define SQUARE_MAP_CLOSED_STREAMS_H

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

namespace square_map {

/// makes sure that standard input, output and error are open: where the caller has closed one, the next file that is
/// opened would take its place, and be written by mistake. The substitute is a folder that is open for neither reading
/// nor writing: using it fails, and opening it once more by a name as /dev/stdout, too.
inline void open_standard_streams()
{
  for(int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if(fcntl(stream, F_GETFD) == -1 && errno == EBADF) [[maybe_unused]]
      const int substitute = open("/", O_PATH | O_DIRECTORY);
}

/// indicates whether a status is that of what took the place of a stream that was closed
inline bool is_of_closed_stream(const struct stat& status)
{
  for(int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    struct stat of_stream = {};
    const int flags = fcntl(stream, F_GETFL);
    if(flags != -1 && (flags & O_PATH) != 0 && fstat(stream, &of_stream) == 0 && of_stream.st_dev == status.st_dev &&
       of_stream.st_ino == status.st_ino)
      return true;
  }
  return false;
}

} // namespace square_map

#endif // SQUARE_MAP_CLOSED_STREAMS_H
