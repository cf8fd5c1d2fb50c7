// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/memory_pool.hpp"

#ifdef __APPLE__
#include <malloc/malloc.h>
#else
#include <malloc.h>
#endif

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <new>

namespace netloft {
namespace {

constexpr std::size_t kSmallestBlock = 64;  // [bytes]
constexpr std::size_t kLargestBlock = std::size_t{1} << 62;

std::size_t capacity_of(void* block) {
#ifdef __APPLE__
  return malloc_size(block);
#else
  return malloc_usable_size(block);
#endif
}

/// Blocks are sorted into classes by size: 4k, 4k+1, 4k+2, 4k+3 hold at least 4·2ᵏ, 5·2ᵏ, 6·2ᵏ, 7·2ᵏ bytes.
std::size_t bytes_of_class(std::size_t size_class) { return (4 + size_class % 4) << (size_class / 4); }

std::size_t largest_class_within(std::size_t bytes) {
  const auto doubling = static_cast<std::size_t>(std::bit_width(bytes)) - 3;
  return 4 * doubling + (bytes >> doubling) - 4;
}

std::size_t smallest_class_holding(std::size_t bytes) {
  const std::size_t below = largest_class_within(bytes);
  return bytes_of_class(below) >= bytes ? below : below + 1;
}

}  // namespace

MemoryPool::FreeBlock* MemoryPool::pop(std::size_t size_class) {
  FreeBlock* block = free_[size_class];
  if (block == nullptr) return nullptr;
  free_[size_class] = block->next;
  kept_bytes_ -= capacity_of(block);
  return block;
}

void* MemoryPool::take(std::size_t bytes) {
  if (bytes > kLargestBlock) return nullptr;
  const std::size_t size_class = smallest_class_holding(std::max(bytes, kSmallestBlock));
  // malloc may return a block that is a little larger than requested. When such a block is freed, it is
  // stored in the next larger class; therefore that class is searched, too.
  for (const std::size_t near : {size_class, size_class + 1})
    if (void* block = pop(near)) return count_as_used(block);
  return count_as_used(std::malloc(bytes_of_class(size_class)));
}

void* MemoryPool::count_as_used(void* block) {
  if (block != nullptr) used_bytes_ += capacity_of(block);
  most_used_bytes_ = std::max(most_used_bytes_, used_bytes_);
  return block;
}

void* MemoryPool::take_zeroed(std::size_t bytes) {
  void* block = take(bytes);
  if (block != nullptr) std::memset(block, 0, bytes);
  return block;
}

void* MemoryPool::resize(void* block, std::size_t bytes) {
  if (block == nullptr) return take(bytes);
  const std::size_t capacity = capacity_of(block);
  if (bytes <= capacity) return block;
  void* larger = take(bytes);
  if (larger == nullptr) return nullptr;
  std::memcpy(larger, block, capacity);
  give_back(block);
  return larger;
}

void MemoryPool::give_back(void* block) {
  if (block == nullptr) return;
  const std::size_t capacity = capacity_of(block);
  used_bytes_ -= std::min(used_bytes_, capacity);  // the block need not have been allocated here
  const bool is_worth_keeping = capacity >= kSmallestBlock && kept_bytes_ + capacity <= 2 * most_used_bytes_;
  if (!is_worth_keeping) return std::free(block);
  FreeBlock*& head = free_[largest_class_within(capacity)];
  head = new (block) FreeBlock{head};
  kept_bytes_ += capacity;
}

void MemoryPool::clear() {
  for (std::size_t size_class = 0; size_class < free_.size(); ++size_class) {
    while (void* block = pop(size_class)) std::free(block);
  }
  used_bytes_ = most_used_bytes_ = 0;
}

namespace {

thread_local MemoryPool* current_pool = nullptr;

void* pool_malloc(std::size_t bytes) { return current_pool ? current_pool->take(bytes) : std::malloc(bytes); }

void* pool_calloc(std::size_t count, std::size_t size) {
  if (current_pool == nullptr || (size != 0 && count > kLargestBlock / size)) return std::calloc(count, size);
  return current_pool->take_zeroed(count * size);
}

void* pool_realloc(void* block, std::size_t bytes) {
  return current_pool ? current_pool->resize(block, bytes) : std::realloc(block, bytes);
}

void pool_free(void* block) { current_pool ? current_pool->give_back(block) : std::free(block); }

}  // namespace

MemoryPoolScope::MemoryPoolScope(MemoryPool& pool) : outer_(current_pool) { current_pool = &pool; }

MemoryPoolScope::~MemoryPoolScope() { current_pool = outer_; }

}  // namespace netloft

// --- functions called by MUMPS, see cmake/FindMumpsSeq.cmake ----------------------------------------------

extern "C" {
void* netloft_mumps_malloc(std::size_t bytes) { return netloft::pool_malloc(bytes); }
void* netloft_mumps_calloc(std::size_t count, std::size_t size) { return netloft::pool_calloc(count, size); }
void* netloft_mumps_realloc(void* block, std::size_t bytes) { return netloft::pool_realloc(block, bytes); }
void netloft_mumps_free(void* block) { netloft::pool_free(block); }

/// Replaces Fortran's TRIM, which MUMPS calls in each factorisation. The caller frees the result unless it is
/// empty.
void netloft_mumps_string_trim(std::size_t* length, char** trimmed, std::size_t source_length,
                               const char* source) {
  static char nothing = '\0';
  *length = source_length;
  while (*length > 0 && source[*length - 1] == ' ') --*length;
  *trimmed = *length > 0 ? static_cast<char*>(netloft_mumps_malloc(*length)) : &nothing;
  if (*trimmed == nullptr) std::abort();  // Fortran aborts, too
  std::memcpy(*trimmed, source, *length);
}
}
