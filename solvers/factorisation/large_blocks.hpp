// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>

namespace netloft {

/// A smaller one saves no memory to speak of, and costs time: from 64 KiB and 1 MiB on, a run of 196 605
/// unknowns spends 0.61 and 0.45 s in the system, from 16 MiB, 64 MiB and 1 GiB on 0.23 to 0.26.
constexpr std::size_t kLargeBlock = std::size_t{1} << 26;  // [bytes]

/// From now on, blocks of take_block() of at least `from` bytes lie in files in this folder, out of core: the
/// system writes to the disk what does not fit into memory. Files have no name, or lose it at once, so that
/// none is left when the program ends, however it does. An empty path keeps all blocks in memory, which is
/// how a program begins. Throws std::runtime_error if no file can be made there.
void put_large_blocks_into(const std::filesystem::path& folder, std::size_t from = kLargeBlock);

/// That folder; empty if blocks are in memory.
std::filesystem::path folder_of_large_blocks();

/// A block as of malloc, for any thread. Null if there is not enough memory, or no room on the disk: all of a
/// file is reserved here, since a disk that is full later would end the program.
void* take_block(std::size_t bytes);

/// For blocks of take_block() and of malloc; null is none.
void free_block(void* block);

/// A block of so many bytes that begins with the same ones, as realloc makes it.
void* resize_block(void* block, std::size_t bytes);

/// How many bytes such a block has.
std::size_t capacity_of(void* block);

struct FreeBlock {
  void operator()(void* block) const { free_block(block); }
};

}  // namespace netloft
