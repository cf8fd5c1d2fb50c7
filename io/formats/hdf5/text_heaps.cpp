// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/text_heaps.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/formats/hdf5/bytes.hpp"
#include "io/formats/hdf5/handle.hpp"
#include "io/formats/hdf5/locked_file.hpp"

namespace netloft::formats {
namespace {

// HDF5 stores texts in collections. A collection begins with its signature, its version and 3 more bytes; an
// object in it begins with its index, its reference count and 4 more bytes. In both, the size follows, in 8
// bytes.
constexpr std::string_view kBegin("GCOL\1", 5);
constexpr std::uint64_t kHeader = 16;
constexpr std::size_t kHeapBlock = 1 << 20;

std::string bytes_of(int fd, std::uint64_t place, std::uint64_t size) {
  std::string bytes(size, '\0');
  read_at(fd, place, bytes.data(), bytes.size());
  return bytes;
}

/// Distance from one object to the next [bytes]. Object 0 is the free space, whose size includes the header.
std::uint64_t step_of(std::string_view collection, std::uint64_t place) {
  const auto size = number_at<std::uint64_t>(collection, place + 8);
  const bool is_free = number_at<std::uint16_t>(collection, place) == 0;
  if (size > collection.size()) return size;
  return is_free ? size : kHeader + (size + 7) / 8 * 8;
}

bool leads_to_its_end(std::string_view collection) {
  for (std::uint64_t place = kHeader; place + kHeader <= collection.size();) {
    const std::uint64_t step = step_of(collection, place);
    if (step < kHeader || step > collection.size() - place) return false;
    place += step;
  }
  return true;
}

/// Throws FileError if the texts of a collection do not have the lengths that they state. Ignores bytes that
/// only look like a collection, and collections larger than the file; HDF5 reads neither.
void check_collection(int fd, std::uint64_t place, std::uint64_t end) {
  if (end - place < kHeader) return;
  const auto size = number_at<std::uint64_t>(bytes_of(fd, place, kHeader), 8);
  if (size > end - place || leads_to_its_end(bytes_of(fd, place, size))) return;
  throw FileError("it is damaged: the texts at byte " + std::to_string(place) +
                  " do not have the lengths that they state");
}

}  // namespace

void check_text_heaps(int fd) {
  const std::uint64_t end = size_of(fd);
  for (std::uint64_t place = 0; place + kBegin.size() <= end; place += kHeapBlock) {
    const std::string block = bytes_of(fd, place, std::min(end - place, kHeapBlock + kBegin.size() - 1));
    for (auto found = block.find(kBegin); found != std::string::npos; found = block.find(kBegin, found + 1))
      check_collection(fd, place + found, end);
  }
}

}  // namespace netloft::formats
