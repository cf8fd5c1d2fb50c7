// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/large_blocks.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "solvers/factorisation/cholmod.hpp"
#include "solvers/factorisation/memory_pool.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "solvers/factorisation/umfpack.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFrom = 4096;

class LargeBlocks : public testing::Test {
 protected:
  LargeBlocks() {
    fs::create_directories(folder_);
    put_large_blocks_into(folder_, kFrom);
  }
  ~LargeBlocks() override {
    put_large_blocks_into({});
    fs::remove_all(folder_);
  }
  const fs::path folder_ = fs::path(testing::TempDir()) / ("large-blocks-" + std::to_string(getpid()));
};

/// How many files without a name this process has mapped out of a folder.
int mapped_files(const fs::path& folder) {
  std::ifstream in("/proc/self/maps");
  int count = 0;
  for (std::string line; std::getline(in, line);)
    if (line.find(folder.string()) != std::string::npos && line.ends_with("(deleted)")) ++count;
  return count;
}

TEST_F(LargeBlocks, LieInFilesWithoutNames) {
  void* small = take_block(kFrom - 1);
  EXPECT_EQ(mapped_files(folder_), 0);
  void* large = take_block(10 * kFrom);
  EXPECT_EQ(mapped_files(folder_), 1);
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_GE(capacity_of(small), kFrom - 1);
  EXPECT_EQ(capacity_of(large), 10 * kFrom);
  std::memset(large, 1, 10 * kFrom);
  free_block(small), free_block(large), free_block(nullptr);
  EXPECT_EQ(mapped_files(folder_), 0);
}

TEST_F(LargeBlocks, KeepTheirBytesWhenTheyGrowAndShrink) {
  auto* block = static_cast<char*>(take_block(kFrom));
  std::memset(block, 7, kFrom);
  block = static_cast<char*>(resize_block(block, 3 * kFrom));
  for (std::size_t i = 0; i < kFrom; ++i) ASSERT_EQ(block[i], 7);
  block = static_cast<char*>(resize_block(block, 10));
  for (std::size_t i = 0; i < 10; ++i) ASSERT_EQ(block[i], 7);
  EXPECT_EQ(mapped_files(folder_), 0);
  free_block(block);
}

TEST_F(LargeBlocks, AreFreedAfterTheFolderHasChanged) {
  void* large = take_block(kFrom);
  put_large_blocks_into({});
  void* in_memory = take_block(kFrom);
  EXPECT_EQ(mapped_files(folder_), 1);
  free_block(large), free_block(in_memory);
  EXPECT_EQ(mapped_files(folder_), 0);
}

/// A limit on the size of files stands for a disk that is full.
TEST_F(LargeBlocks, AreNullWhereTheDiskHasNoRoom) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{kFrom, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  void* none = take_block(10 * kFrom);
  MemoryPool pool;
  void* none_either = pool.take(10 * kFrom);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(none, nullptr);
  EXPECT_EQ(none_either, nullptr);
}

TEST(LargeBlocksFolder, HasToTakeFiles) {
  EXPECT_THROW(put_large_blocks_into("/nowhere/at/all"), std::runtime_error);
  EXPECT_THROW(put_large_blocks_into("/proc"), std::runtime_error);
  EXPECT_TRUE(folder_of_large_blocks().empty());
}

using Make = std::unique_ptr<Factorisation> (*)();

void expect_same_bits(const fs::path& folder, const TestMatrix& matrix, Make make) {
  auto out_of_core = make();
  solve(*out_of_core, matrix);
  const auto from_files = solve_again(*out_of_core, matrix);
  EXPECT_GT(mapped_files(folder), 0) << out_of_core->description();
  put_large_blocks_into({});
  EXPECT_EQ(from_files, solve(*make(), matrix)) << out_of_core->description();
  out_of_core.reset();
  EXPECT_EQ(mapped_files(folder), 0);
  put_large_blocks_into(folder, kFrom);
}

TEST_F(LargeBlocks, ChangeNoBitOfASolution) {
  const TestMatrix definite = make_net_matrix({});
  expect_same_bits(folder_, definite, [] { return make_cholmod_factorisation(); });
  expect_same_bits(folder_, definite, [] { return make_definite_multifrontal_factorisation(); });
  if (has_mumps())
    expect_same_bits(folder_, definite, [] { return make_mumps_factorisation(MatrixClass::symmetric); });
  const TestMatrix unsymmetric = make_net_matrix({.symmetric = false});
  expect_same_bits(folder_, unsymmetric, [] {
    return make_multifrontal_factorisation([] { return make_umfpack_factorisation(); });
  });
  expect_same_bits(folder_, unsymmetric, [] { return make_umfpack_factorisation(); });
}

}  // namespace
}  // namespace netloft
