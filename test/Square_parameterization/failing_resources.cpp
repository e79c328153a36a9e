// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Loaded before a program, lets allocations fail: those from the number FAILING_MALLOC_FROM on, FAILING_MALLOC_COUNT of
// them, or all; and threads from the number FAILING_THREADS_FROM on. For glibc, which has its own functions under other
// names.

#include <atomic>
#include <cerrno>
#include <cstdlib>

#include <dlfcn.h>
#include <pthread.h>

/// the number that a variable of the environment holds
static long number(const char* name, long otherwise)
{
  const char* const value = std::getenv(name);
  return value != nullptr ? std::atol(value) : otherwise;
}

extern "C" {

void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

static bool fails()
{
  static std::atomic<long> made{0};
  const long n = made++, from = number("FAILING_MALLOC_FROM", -1), count = number("FAILING_MALLOC_COUNT", -1);
  if(from < 0 || n < from || (count >= 0 && n >= from + count))
    return false;
  errno = ENOMEM;
  return true;
}

void* malloc(size_t size)
{
  return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(size_t count, size_t size)
{
  return fails() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* block, size_t size)
{
  return fails() ? nullptr : __libc_realloc(block, size);
}

void* memalign(size_t alignment, size_t size)
{
  return fails() ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size)
{
  return memalign(alignment, size);
}

int posix_memalign(void** block, size_t alignment, size_t size)
{
  void* const made = memalign(alignment, size);
  if(made == nullptr)
    return ENOMEM;
  *block = made;
  return 0;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument)
{
  static std::atomic<long> made{0};
  const long from = number("FAILING_THREADS_FROM", -1);
  if(from >= 0 && made++ >= from)
    return EAGAIN; // as at the process limit, which does not hold for root
  typedef int (*Create)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  return reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, run, argument);
}
}
