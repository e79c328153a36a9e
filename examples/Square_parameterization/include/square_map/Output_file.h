// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_OUTPUT_FILE_H
#define SQUARE_MAP_OUTPUT_FILE_H

#include "Output_target.h"
#include "Temporary_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>

namespace square_map {

/// one output: a file that appears whole or not at all. Its text goes to a temporary file in the same folder, which
/// takes its place in `replace()`. A device, a pipe or standard output (`-`) is written directly.
///
/// The constructor tells at once when the file cannot be written; until `write()` there is no temporary file, so that
/// even a process that is killed at work leaves none.
class Output_file
{
public:
  explicit Output_file(const std::string& name)
    : m_name(name), m_target(name == "-" ? Output_target{name, true} : find_output_target(name))
  {
    if(!m_target.is_direct) {
      make_temporary_file();
      if(!remove_temporary_file())
        throw Output_error(m_name, "files cannot be removed from its folder");
    } else if(m_name != "-") {
      m_file.open(m_target.path, std::ios::app); // what an open file such as /dev/stdout holds stays
      if(!m_file)
        fail(errno);
    }
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file() { remove_temporary_file(); }

  /// writes the whole text, and makes sure that it has left the process. Throws `Output_error`.
  void write(const std::function<void(std::ostream&)>& write_text)
  {
    if(!m_target.is_direct) {
      make_temporary_file();
      m_file.open(m_temporary);
      if(!m_file)
        fail(errno);
    }
    std::ostream stream(m_name == "-" ? std::cout.rdbuf() : m_file.rdbuf());
    stream.precision(17);
    errno = 0;
    try {
      stream.exceptions(std::ios::badbit | std::ios::failbit); // leaves errno as the failure has set it
      write_text(stream);
      stream.flush();
    } catch(const std::ios_base::failure&) {
      fail(errno);
    }
    if(m_file.is_open() && m_file.rdbuf()->close() == nullptr)
      fail(errno);
  }

  /// lets the text take its place; `write()` was called. Throws `Output_error`.
  /// \param keeps_former the file that was there is kept beside it, for `restore()`
  void replace(bool keeps_former)
  {
    if(m_target.is_direct)
      return;
    struct stat former = {};
    const bool has_former = stat(m_target.path.c_str(), &former) == 0;
    if(has_former && S_ISDIR(former.st_mode)) // it has come in the meantime
      fail(EISDIR);
    if(has_former)
      take_over_mode(former);
    else
      take_usual_mode();
    if(has_former && keeps_former)
      keep_former();
    if(rename(m_temporary.c_str(), m_target.path.c_str()) != 0)
      fail(errno);
    temporary_files.forget(m_place);
    m_temporary.clear();
    m_is_replaced = true;
  }

  /// puts back what was there before `replace()`, be it done or failed
  void restore()
  {
    if(!m_former.empty()) {
      rename(m_former.c_str(), m_target.path.c_str());
      forget_former(); // two names of one file are left as they are by rename()
    } else if(m_is_replaced)
      unlink(m_target.path.c_str());
    m_is_replaced = false;
  }

  /// removes what was kept for `restore()`
  void forget_former()
  {
    if(!m_former.empty())
      unlink(m_former.c_str());
    m_former.clear();
  }

private:
  static constexpr mode_t PRIVATE = 0600; // until the text takes its place, which others may not be allowed to read

  [[noreturn]] void fail(int error) const { throw Output_error(m_name, reason_of(error)); }

  /// a name in the folder of the target that no other process uses; short, for that of the target may be as long as
  /// names can be
  std::string name_beside(int number, const char* extension) const
  {
    return (m_target.path.parent_path() /
            (".square_map." + std::to_string(getpid()) + "." + std::to_string(number) + extension))
        .string();
  }

  void make_temporary_file()
  {
    for(int number = 0;; ++number) {
      m_temporary = name_beside(number, ".part");
      m_place = temporary_files.add(m_temporary); // first: a signal may come at any time
      const int descriptor = open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, PRIVATE);
      if(descriptor >= 0) {
        fchmod(descriptor, PRIVATE); // what the mask took away: it is opened once more
        close(descriptor);
        return;
      }
      const int error = errno;
      temporary_files.forget(m_place);
      m_temporary.clear();
      if(error == EACCES) // the file itself may be open to all
        throw Output_error(m_name, "permission denied in its folder");
      if(error != EEXIST)
        fail(error);
    }
  }

  /// false when it stays
  bool remove_temporary_file()
  {
    if(m_temporary.empty())
      return true;
    const bool is_removed = unlink(m_temporary.c_str()) == 0 || errno == ENOENT;
    temporary_files.forget(m_place);
    m_temporary.clear();
    return is_removed;
  }

  /// only the superuser may give a file to another user; a file in a group of one's own may be of that. The rights of
  /// another owner and group are not passed on: in another group all may do what both the group and all others might.
  void take_over_mode(const struct stat& former) const
  {
    mode_t mode = former.st_mode & 07777;
    if(chown(m_temporary.c_str(), former.st_uid, former.st_gid) != 0) {
      if(former.st_uid != geteuid())
        mode &= ~mode_t(S_ISUID);
      if(chown(m_temporary.c_str(), static_cast<uid_t>(-1), former.st_gid) != 0) {
        const mode_t of_both = mode >> 3 & mode & S_IRWXO;
        mode = (mode & ~mode_t(S_ISGID | S_IRWXG | S_IRWXO)) | of_both << 3 | of_both;
      }
    }
    chmod(m_temporary.c_str(), mode);
  }

  /// that of any new file
  void take_usual_mode() const
  {
    const mode_t mask = umask(0);
    umask(mask);
    chmod(m_temporary.c_str(), 0666 & ~mask);
  }

  void keep_former()
  {
    for(int number = 0;; ++number) {
      std::string former = name_beside(number, ".old");
      const bool is_linked = link(m_target.path.c_str(), former.c_str()) == 0;
      if(!is_linked && errno == EEXIST)
        continue;
      if(!is_linked && rename(m_target.path.c_str(), former.c_str()) != 0) // where there are no hard links
        fail(errno);
      m_former = std::move(former);
      return;
    }
  }

  std::string m_name;
  Output_target m_target;
  std::ofstream m_file;
  std::string m_temporary, m_former; // empty where there is none
  int m_place = -1;                  // of the temporary file among those of the process
  bool m_is_replaced = false;
};

} // namespace square_map

#endif // SQUARE_MAP_OUTPUT_FILE_H
