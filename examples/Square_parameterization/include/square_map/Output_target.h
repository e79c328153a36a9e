// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OUTPUT_TARGET_H
#define SQUARE_MAP_OUTPUT_TARGET_H

#include "closed_streams.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace square_map {

/// an output that cannot be written
struct Output_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
  Output_error(const std::string& name, const std::string& reason)
    : std::runtime_error("cannot write " + (name == "-" ? "to standard output" : "'" + name + "'") + ": " + reason)
  {}
};

/// lack of memory is no fault of a file: it ends as any other
inline void throw_if_out_of_memory(const std::error_code& error)
{
  if(error == std::errc::not_enough_memory)
    throw std::bad_alloc();
}

/// why a file cannot be opened, written or renamed: the words for a value of `errno`
inline std::string reason_of(int error)
{
  throw_if_out_of_memory({error, std::generic_category()});
  switch(error) {
  case ENOENT:
  case ENOTDIR:
    return "no such folder";
  case EISDIR:
    return "it is a folder";
  case EACCES:
  case EPERM:
    return "permission denied";
  case EROFS:
    return "the file system is read-only";
  case ENOSPC:
    return "no space left on the device";
  case EDQUOT:
    return "the disk quota is used up";
  case EFBIG:
    return "the file would be larger than allowed";
  case ENAMETOOLONG:
    return "the name is too long";
  case ELOOP:
    return "too many links lead to one another";
  case EPIPE:
    return "its reader has gone";
  case EBADF:
    return "it is closed";
  case 0:
    return "the reason is unknown";
  default:
    return std::generic_category().message(error);
  }
}

/// indicates whether the path, or a link that it leads through, names an open file of the process, as /dev/stdout does
inline bool names_open_file(std::filesystem::path path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  for(int links = 0; links < 40 && fs::is_symlink(path, error); ++links) {
    const fs::path folder = fs::canonical(fs::absolute(path, error).parent_path(), error);
    throw_if_out_of_memory(error);
    if(folder == "/dev" || folder.string().rfind("/proc/", 0) == 0)
      return true;
    path = folder / fs::read_symlink(path, error);
    throw_if_out_of_memory(error);
  }
  return false;
}

/// where the text of an output goes
struct Output_target
{
  std::filesystem::path path; ///< without links, so that a link to the file stays one
  bool is_direct;             ///< no regular file of its own (a device, a pipe, an open file): written in place
};

/// indicates whether a file must stay: in a folder as /tmp those of others cannot be replaced
inline bool is_kept_by_sticky_folder(const struct stat& file, const std::filesystem::path& folder)
{
  struct stat status = {};
  const uid_t user = geteuid();
  return user != 0 && user != file.st_uid && stat(folder.c_str(), &status) == 0 && (status.st_mode & S_ISVTX) != 0 &&
         user != status.st_uid;
}

/// what the name of an output stands for. Throws `Output_error` where that cannot be written.
inline Output_target find_output_target(const std::string& name)
{
  namespace fs = std::filesystem;
  struct stat status = {};
  if(stat(name.c_str(), &status) == 0) {
    if(S_ISDIR(status.st_mode))
      throw Output_error(name, is_of_closed_stream(status) ? "it is closed" : "it is a folder");
    if(!S_ISREG(status.st_mode) || names_open_file(name))
      return {name, true};
    if((status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0) // the superuser may, but it was meant to stay
      throw Output_error(name, "it is read-only");
    if(faccessat(AT_FDCWD, name.c_str(), W_OK, AT_EACCESS) != 0)
      throw Output_error(name, reason_of(errno));
    std::error_code error;
    fs::path path = fs::canonical(name, error);
    if(std::error_code unknown; error.value() == ENAMETOOLONG && !fs::is_symlink(name, unknown))
      return {name, false}; // short, but in a working folder whose path is too long
    if(error)
      throw Output_error(name, reason_of(error.value()));
    if(is_kept_by_sticky_folder(status, path.parent_path()))
      throw Output_error(name, "it is another user's, in a folder where it cannot be replaced");
    return {std::move(path), false};
  }
  if(errno != ENOENT)
    throw Output_error(name, reason_of(errno));
  std::error_code error;
  if(fs::is_symlink(name, error))
    throw Output_error(name, "it is a link to a file that does not exist");
  const fs::path path = fs::absolute(name, error); // none when the working folder is gone
  const fs::path folder = error ? fs::path() : fs::canonical(path.parent_path(), error);
  if(error.value() == ENAMETOOLONG)
    return {name, false}; // as above
  if(error || path.filename().empty())
    throw Output_error(name, reason_of(error ? error.value() : ENOENT));
  return {folder / path.filename(), false};
}

} // namespace square_map

#endif // SQUARE_MAP_OUTPUT_TARGET_H
