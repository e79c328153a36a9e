// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_MEMORY_IN_USE_H
#define SQUARE_MAP_MEMORY_IN_USE_H

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace square_map {

/// what the process has of what the limits of the same names bound, in bytes; zero where there is no /proc
struct Memory_in_use
{
  Memory_in_use()
  {
    rlim_t unused = 0;
    std::ifstream("/proc/self/statm") >> address_space >> unused >> unused >> unused >> unused >> data; // in pages
    const rlim_t page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    address_space *= page;
    data *= page;
  }

  rlim_t address_space = 0, data = 0;
};

} // namespace square_map

#endif // SQUARE_MAP_MEMORY_IN_USE_H
