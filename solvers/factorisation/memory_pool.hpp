// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

namespace netloft {

/// Keeps the blocks that MUMPS frees and reuses them, so that the second and every later
/// factorisation of one pattern calls no malloc.
///
/// Every block is a plain malloc block whose size the C library reports. Therefore free() may free a block of
/// the pool, and the pool may take back a block from malloc. The free blocks together are never larger than
/// twice the largest memory that was in use at one time. The pool has no lock: only one thread may use it.
class MemoryPool {
 public:
  MemoryPool() = default;
  MemoryPool(const MemoryPool&) = delete;
  MemoryPool& operator=(const MemoryPool&) = delete;
  ~MemoryPool() { clear(); }

  void* take(std::size_t bytes);
  void* take_zeroed(std::size_t bytes);
  void* resize(void* block, std::size_t bytes);  // a block that is large enough is not moved
  void give_back(void* block);

  /// Returns all kept blocks to the C library.
  void clear();
  std::size_t kept_bytes() const { return kept_bytes_; }

 private:
  struct FreeBlock {
    FreeBlock* next;
  };
  FreeBlock* pop(std::size_t size_class);
  void* count_as_used(void* block);

  std::array<FreeBlock*, 256> free_{};  // free blocks by size class: the size doubles every four classes
  std::size_t kept_bytes_ = 0;
  std::size_t used_bytes_ = 0, most_used_bytes_ = 0;
};

/// While this object exists, MUMPS takes its memory from `pool`, in this thread only.
class MemoryPoolScope {
 public:
  explicit MemoryPoolScope(MemoryPool& pool);
  MemoryPoolScope(const MemoryPoolScope&) = delete;
  MemoryPoolScope& operator=(const MemoryPoolScope&) = delete;
  ~MemoryPoolScope();

 private:
  MemoryPool* outer_;
};

}  // namespace netloft
