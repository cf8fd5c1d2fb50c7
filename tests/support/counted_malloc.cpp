// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/counted_malloc.hpp"

#include <atomic>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define NETLOFT_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define NETLOFT_SANITIZED
#endif
#if defined(__GLIBC__) && !defined(NETLOFT_SANITIZED)
#define NETLOFT_COUNTS_MALLOC
#endif

namespace {
std::atomic<long> allocations{0};
}

#ifdef NETLOFT_COUNTS_MALLOC
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t bytes) {
  ++allocations;
  return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  ++allocations;
  return __libc_calloc(count, bytes);
}
void* realloc(void* block, std::size_t bytes) {
  ++allocations;
  return __libc_realloc(block, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  ++allocations;
  return __libc_memalign(alignment, bytes);
}
}
#endif

namespace netloft::test {

bool malloc_is_counted() {
#ifdef NETLOFT_COUNTS_MALLOC
  return true;
#else
  return false;
#endif
}

long count_malloc() { return allocations; }

}  // namespace netloft::test
