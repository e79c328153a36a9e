// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_COMMAND_LINE_PROCESS_H
#define TEST_COMMAND_LINE_PROCESS_H

#include "Temporary_folder.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>
#include <vector>

// Runs the built command as a process.

struct Finished_process
{
  int status = -1; ///< exit status; minus the signal of a process that was killed
  std::string out, err;
};

/// square_map, started with its output in files
class Running_process
{
public:
  /// \param out_file such as a device, takes the place of the file for standard output
  /// \param prepare called in the new process, before square_map takes it over: may set limits or close streams
  explicit Running_process(
      const std::vector<std::string>& arguments, const std::string& out_file = "",
      const std::function<void()>& prepare = [] {})
    : m_out(out_file.empty() ? m_folder / "out" : out_file), m_err(m_folder / "err")
  {
    std::vector<char*> argv{const_cast<char*>(SQUARE_MAP)};
    for(const std::string& argument : arguments)
      argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    m_child = fork();
    if(m_child == 0) {
      const auto redirect = [](const std::string& path, int descriptor) {
        dup2(open(path.c_str(), O_WRONLY | O_CREAT, 0600), descriptor);
      };
      redirect(m_out, STDOUT_FILENO);
      redirect(m_err, STDERR_FILENO);
      for(int signal : {SIGINT, SIGHUP, SIGPIPE}) // whoever runs the tests may ignore them
        std::signal(signal, SIG_DFL);
      prepare();
      execv(SQUARE_MAP, argv.data());
      _exit(127);
    }
  }

  void send(int signal) const { kill(m_child, signal); }

  Finished_process wait()
  {
    Finished_process result;
    int status = 0;
    waitpid(m_child, &status, 0);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    if(m_out == m_folder / "out")
      result.out = read_file(m_out);
    result.err = read_file(m_err);
    return result;
  }

private:
  Temporary_folder m_folder;
  std::string m_out, m_err;
  pid_t m_child;
};

/// runs square_map to its end
inline Finished_process square_map(
    const std::vector<std::string>& arguments, const std::string& out_file = "",
    const std::function<void()>& prepare = [] {})
{
  return Running_process(arguments, out_file, prepare).wait();
}

/// to prepare a process: the superuser may no longer read and write what permissions do not allow
inline void heed_permissions()
{
  for(int capability : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH})
    prctl(PR_CAPBSET_DROP, capability); // what a program that is executed may have; fails for others, who need none
}

#endif // TEST_COMMAND_LINE_PROCESS_H
