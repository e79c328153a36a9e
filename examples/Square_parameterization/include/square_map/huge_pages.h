// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_HUGE_PAGES_H
#define SQUARE_MAP_HUGE_PAGES_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <thread>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace square_map {

constexpr int LARGEST_HEAP = 64 << 20; // bytes, of those that glibc gives to threads beside the first

/// lets memory lie on huge pages, of which no part is given back before the end: factors and maps are made and thrown away all
/// the time, and up to a fifth of the time of a job went into the pages of 4 kB they lie on.
/// Reserves address space, which costs nothing until it is used, unless memory may not be overcommitted. To be called before
/// there are threads, where the address space is not limited. Does nothing for other C libraries than glibc.
inline void use_huge_pages()
{
#ifdef __GLIBC__
  constexpr int RESERVED = 1 << 30, LARGEST_IN_HEAP = 32 << 20, NEVER = 0x7fffffff; // bytes
  mallopt(M_TRIM_THRESHOLD, NEVER);
  mallopt(M_MMAP_THRESHOLD, LARGEST_IN_HEAP); // the most that glibc allows
  mallopt(M_TOP_PAD, RESERVED);
  const auto before = reinterpret_cast<std::uintptr_t>(sbrk(0));
  void* volatile probe = std::malloc(LARGEST_IN_HEAP / 2); // volatile: it is not to be optimized away
  std::free(probe);
  const auto after = reinterpret_cast<std::uintptr_t>(sbrk(0));
  mallopt(M_TOP_PAD, LARGEST_HEAP); // heaps of other threads are had as a whole, and none is given back, either
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t begin = (before + page - 1) / page * page;
  if(begin < after) // else another allocator is in use, or there is too little memory
    madvise(reinterpret_cast<void*>(begin), after - begin, MADV_HUGEPAGE);
#endif
}

/// the same for the first heap of each of so many further threads; what they take beyond lies on usual pages. Threads that share
/// a heap wait for each other. That of a thread that has ended goes to the next one that begins. To be called after
/// `use_huge_pages()`, before there are threads.
inline void use_huge_pages_in_threads([[maybe_unused]] unsigned int threads)
{
#ifdef __GLIBC__
  if(threads == 0)
    return;
  const auto make_heap = [threads] {
    constexpr std::uintptr_t NEAR = 1 << 20, LITTLE = 1 << 10; // bytes
    void* volatile first = std::malloc(LITTLE);
    const auto address = reinterpret_cast<std::uintptr_t>(first);
    const std::uintptr_t begin = address / LARGEST_HEAP * LARGEST_HEAP; // a heap begins at a multiple of its size
    if(address - begin < NEAR) // else another allocator is in use, or there are as many heaps as there may be
      madvise(reinterpret_cast<void*>(begin), LARGEST_HEAP, MADV_HUGEPAGE);
    std::free(first);
    use_huge_pages_in_threads(threads - 1); // as long as this thread lasts, the next gets a heap of its own
  };
  try {
    std::thread(make_heap).join();
  } catch(const std::exception&) { // of threads that cannot be made none needs a heap
  }
#endif
}

} // namespace square_map

#endif // SQUARE_MAP_HUGE_PAGES_H
