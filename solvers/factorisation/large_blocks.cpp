// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/large_blocks.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#ifdef __APPLE__
#include <malloc/malloc.h>
#else
#include <malloc.h>
#endif

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>

namespace netloft {
namespace {

struct Mapped {
  std::mutex mutex;
  std::filesystem::path folder;
  std::size_t from = kLargeBlock;
  std::map<void*, std::size_t> bytes_of;  // of blocks in files
};

Mapped& mapped() {
  static auto* all = new Mapped;  // outlives every block
  return *all;
}

std::atomic<bool> has_mapped = false;  // ever

/// A file without a name; below 0 where there can be none.
int make_file(const std::filesystem::path& folder) {
#ifdef O_TMPFILE
  const int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR)) return file;
#endif
  std::string name = folder / "netloft-XXXXXX";
  const int named = mkstemp(name.data());
  if (named >= 0) unlink(name.c_str());
  return named;
}

void* map_file(const std::filesystem::path& folder, std::size_t bytes) {
  const int file = make_file(folder);
  if (file < 0) return nullptr;
  void* block = MAP_FAILED;
  if (posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0)
    block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return block == MAP_FAILED ? nullptr : block;
}

/// Bytes of a block in a file; 0 of any other. Blocks of files begin with a page, those of malloc
/// seldom do.
std::size_t bytes_in_file(void* block) {
  static const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  if (!has_mapped || reinterpret_cast<std::uintptr_t>(block) % page != 0) return 0;
  const std::lock_guard lock(mapped().mutex);
  const auto found = mapped().bytes_of.find(block);
  return found == mapped().bytes_of.end() ? 0 : found->second;
}

}  // namespace

void put_large_blocks_into(const std::filesystem::path& folder, std::size_t from) {
  if (!folder.empty()) {
    const int file = make_file(folder);
    if (file < 0)
      throw std::runtime_error("no file can be made in " + folder.string() + ": " +
                               std::generic_category().message(errno));
    close(file);
  }
  const std::lock_guard lock(mapped().mutex);
  mapped().folder = folder;
  mapped().from = from;
}

std::filesystem::path folder_of_large_blocks() {
  const std::lock_guard lock(mapped().mutex);
  return mapped().folder;
}

void* take_block(std::size_t bytes) {
  const std::lock_guard lock(mapped().mutex);
  if (mapped().folder.empty() || bytes < mapped().from) return std::malloc(bytes);
  void* block = map_file(mapped().folder, bytes);
  if (block != nullptr) {
    mapped().bytes_of[block] = bytes;
    has_mapped = true;
  }
  return block;
}

void free_block(void* block) {
  const std::size_t bytes = bytes_in_file(block);
  if (bytes == 0) return std::free(block);
  const std::lock_guard lock(mapped().mutex);
  mapped().bytes_of.erase(block);
  munmap(block, bytes);
}

void* resize_block(void* block, std::size_t bytes) {
  const std::size_t in_file = bytes_in_file(block);
  if (in_file == 0) return std::realloc(block, bytes);
  void* other = take_block(bytes);
  if (other == nullptr) return nullptr;
  std::memcpy(other, block, std::min(bytes, in_file));
  free_block(block);
  return other;
}

std::size_t capacity_of(void* block) {
  if (const std::size_t bytes = bytes_in_file(block)) return bytes;
#ifdef __APPLE__
  return malloc_size(block);
#else
  return malloc_usable_size(block);
#endif
}

}  // namespace netloft
