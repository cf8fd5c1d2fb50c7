// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/bytes.hpp"

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

std::string_view ByteReader::take(std::uint64_t count, std::size_t size) {
  if (count > rest_.size() / size) throw FileError("it is damaged: a record ends too early");
  const std::string_view taken = rest_.substr(0, count * size);
  rest_.remove_prefix(taken.size());
  return taken;
}

}  // namespace netloft::formats
