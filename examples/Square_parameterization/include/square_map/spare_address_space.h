// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SQUARE_MAP_SPARE_ADDRESS_SPACE_H
#define SQUARE_MAP_SPARE_ADDRESS_SPACE_H

#include <sys/resource.h>

#include <cstddef>

#ifdef __GLIBC__
#include <malloc.h>
#include <pthread.h>
#endif

namespace square_map {

/// where the address space or the data of the process are limited (ulimit -v, -d), lets threads take little of it: by default each takes
/// 8 MB for its stack and 64 to 128 MB for memory of its own, before it has used any, and leaves too little to map with.
/// To be called before there are threads. Does nothing for other C libraries than glibc.
inline void spare_address_space()
{
#ifdef __GLIBC__
  const auto is_limited = [](auto resource) {
    rlimit limit = {};
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  };
  if(!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA))
    return;
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

} // namespace square_map

#endif // SQUARE_MAP_SPARE_ADDRESS_SPACE_H
