// SPDX-License-Identifier: BSD-3-Clause
#include "io/picture/png.hpp"

#include "io/picture/bytes.hpp"

#include <zlib.h>

namespace netloft::io {

namespace {

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

/// Length, name, data and checksum of a chunk.
std::string chunk(const std::string& name, const std::string& data) {
  const std::string body = name + data;
  const auto sum = crc32(0, bytes_of(body).data(), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body +
         big_endian(static_cast<std::uint32_t>(sum));
}

}  // namespace

std::string png(const Image& image) {
  std::string rows;
  rows.reserve((3 * image.width + 1) * image.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    rows += '\1';  // every byte as its difference from the pixel to the left
    const std::uint8_t* row = image.bytes.data() + 3 * image.width * y;
    for (std::size_t i = 0; i < 3 * image.width; ++i)
      rows += static_cast<char>(row[i] - (i < 3 ? 0 : row[i - 3]));
  }
  const std::string eight_bit_rgb = {8, 2, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(static_cast<std::uint32_t>(image.width)) +
                           big_endian(static_cast<std::uint32_t>(image.height)) + eight_bit_rgb) +
         chunk("IDAT", deflated(bytes_of(rows))) + chunk("IEND", "");
}

}  // namespace netloft::io
