// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/memory_pool.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

// Functions that MUMPS calls; see cmake/FindMumpsSeq.cmake.
extern "C" {
void* netloft_mumps_malloc(std::size_t bytes);
void* netloft_mumps_calloc(std::size_t count, std::size_t size);
void netloft_mumps_free(void* block);
}

namespace netloft {
namespace {

TEST(MemoryPool, HandsOutAgainWhatItGotBack) {
  MemoryPool pool;
  for (const std::size_t bytes : {1u, 64u, 65u, 1000u, 4097u, 1u << 20, (1u << 20) + 1}) {
    void* block = pool.take(bytes);
    std::memset(block, 1, bytes);
    pool.give_back(block);
    EXPECT_EQ(pool.take(bytes), block) << bytes;
    std::free(block);
  }
}

TEST(MemoryPool, NeverHandsOutABlockThatIsTooSmall) {
  MemoryPool pool;
  for (std::size_t bytes = 1; bytes < 3000; bytes += 7) {
    pool.give_back(pool.take(bytes));
    void* larger = pool.take(bytes + 1);
    std::memset(larger, 1, bytes + 1);  // the address sanitizer watches
    pool.give_back(larger);
  }
}

TEST(MemoryPool, ZeroesARecycledBlock) {
  MemoryPool pool;
  char* block = static_cast<char*>(pool.take(100));
  std::memset(block, 1, 100);
  pool.give_back(block);
  char* zeroed = static_cast<char*>(pool.take_zeroed(100));
  EXPECT_EQ(zeroed, block);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(zeroed[i], 0);
  pool.give_back(zeroed);
}

TEST(MemoryPool, KeepsTheContentWhenABlockGrows) {
  MemoryPool pool;
  char* block = static_cast<char*>(pool.resize(nullptr, 100));
  std::memset(block, 7, 100);
  block = static_cast<char*>(pool.resize(block, 100000));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(block[i], 7);
  EXPECT_EQ(pool.resize(block, 10), block);
  pool.give_back(block);
}

TEST(MemoryPool, TakesBlocksThatMallocMade) {
  MemoryPool pool;
  pool.give_back(pool.take(1000));
  void* foreign = std::malloc(512);
  pool.give_back(foreign);
  EXPECT_EQ(pool.take(512), foreign);
  std::free(foreign);
  pool.give_back(nullptr);
}

TEST(MemoryPool, KeepsAtMostTwiceWhatWasInUseAtOneTime) {
  MemoryPool pool;
  for (std::size_t bytes = 100; bytes <= 100000; bytes += bytes / 4) {
    pool.give_back(pool.take(bytes));
    EXPECT_LE(pool.kept_bytes(), 2 * (bytes + bytes / 4 + 64));
  }
  pool.clear();
  EXPECT_EQ(pool.kept_bytes(), 0u);
}

TEST(MemoryPool, RefusesMoreThanThereCanBe) {
  MemoryPool pool;
  EXPECT_EQ(pool.take(~std::size_t{0}), nullptr);
}

TEST(MemoryPoolScope, CatchesWhatMumpsFreesAndOnlyInside) {
  MemoryPool pool;
  {
    const MemoryPoolScope scope(pool);
    netloft_mumps_free(netloft_mumps_malloc(1000));
    EXPECT_GE(pool.kept_bytes(), 1000u);
    netloft_mumps_free(netloft_mumps_calloc(10, 200));
  }
  const std::size_t kept = pool.kept_bytes();
  netloft_mumps_free(netloft_mumps_malloc(5000));
  EXPECT_EQ(pool.kept_bytes(), kept);
}

TEST(MemoryPoolScope, GoesBackToTheOuterPool) {
  MemoryPool outer, inner;
  const MemoryPoolScope outer_scope(outer);
  { const MemoryPoolScope inner_scope(inner); }
  netloft_mumps_free(netloft_mumps_malloc(1000));
  EXPECT_GE(outer.kept_bytes(), 1000u);
  EXPECT_EQ(inner.kept_bytes(), 0u);
}

}  // namespace
}  // namespace netloft
