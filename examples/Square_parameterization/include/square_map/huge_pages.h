// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_HUGE_PAGES_H
#define SQUARE_MAP_HUGE_PAGES_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace square_map {

/// lets the memory of all threads come from one heap of huge pages, of which no part is given back before the end: factors and maps
/// are made and thrown away all the time, and up to a fifth of the time of a job went into the pages of 4 kB they lie on.
/// Reserves address space, which costs nothing until it is used. To be called before there are threads, where the address
/// space is not limited. Does nothing for other C libraries than glibc.
inline void use_huge_pages()
{
#ifdef __GLIBC__
  constexpr int RESERVED = 1 << 30, LARGEST_IN_HEAP = 32 << 20, USUAL_PAD = 1 << 20, NEVER = 0x7fffffff; // bytes
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TRIM_THRESHOLD, NEVER);
  mallopt(M_MMAP_THRESHOLD, LARGEST_IN_HEAP); // the most that glibc allows
  mallopt(M_TOP_PAD, RESERVED);
  const auto before = reinterpret_cast<std::uintptr_t>(sbrk(0));
  void* volatile probe = std::malloc(LARGEST_IN_HEAP / 2); // volatile: it is not to be optimized away
  std::free(probe);
  const auto after = reinterpret_cast<std::uintptr_t>(sbrk(0));
  mallopt(M_TOP_PAD, USUAL_PAD);
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t begin = (before + page - 1) / page * page;
  if(begin < after) // else another allocator is in use, or there is too little memory
    madvise(reinterpret_cast<void*>(begin), after - begin, MADV_HUGEPAGE);
#endif
}

} // namespace square_map

#endif // SQUARE_MAP_HUGE_PAGES_H
