// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SPARE_ADDRESS_SPACE_H
#define SQUARE_MAP_SPARE_ADDRESS_SPACE_H

#include "Memory_in_use.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#include <pthread.h>
#endif

namespace square_map {

/// indicates whether the address space or the data of the process are limited (ulimit -v, -d)
inline bool has_limited_address_space()
{
  const auto is_limited = [](auto resource) {
    rlimit limit = {};
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  };
  return is_limited(RLIMIT_AS) || is_limited(RLIMIT_DATA);
}

/// lets threads take little of an address space that is limited: by default each takes 8 MB for its stack and 64 to 128 MB for
/// memory of its own, before it has used any, and leaves too little to map with. To be called before there are threads. Does
/// nothing for other C libraries than glibc.
inline void spare_address_space()
{
#ifdef __GLIBC__
  // bytes; no function that threads run is recursive or has large arrays
  constexpr std::size_t STACK_OF_A_THREAD = 1 << 20;
  mallopt(M_ARENA_MAX, 1);
  pthread_attr_t attributes;
  if(pthread_attr_init(&attributes) != 0)
    return;
  if(pthread_attr_setstacksize(&attributes, STACK_OF_A_THREAD) == 0)
    pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
#endif
}

/// indicates whether the stack may grow as far as the job needs it, and the libraries it calls: 128 kB were enough for all
/// that was tried
inline bool has_stack()
{
  constexpr rlim_t NEEDED = 512 << 10;
  rlimit limit = {};
  return getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= NEEDED;
}

/// the number of threads that a limit of the address space or the data leaves room for: one, and another for each part of what is
/// left now that maps a surface of so many vertices. Larger than any number without a limit, and where there is no /proc.
inline std::size_t threads_with_room(std::size_t vertices)
{
  const rlim_t room_for_a_thread = (12 << 20) + 3072 * static_cast<rlim_t>(vertices); // bytes, its stack with them
  const Memory_in_use in_use;
  std::size_t threads = std::numeric_limits<std::size_t>::max();
  const auto respect = [&](auto resource, rlim_t used) {
    rlimit limit = {};
    if(used == 0 || getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
      return;
    const rlim_t left = limit.rlim_cur - std::min(limit.rlim_cur, used);
    threads = std::min(threads, static_cast<std::size_t>(1 + left / room_for_a_thread));
  };
  respect(RLIMIT_AS, in_use.address_space);
  respect(RLIMIT_DATA, in_use.data);
  return threads;
}

} // namespace square_map

#endif // SQUARE_MAP_SPARE_ADDRESS_SPACE_H
