// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/png.hpp"

#include "io/pictures/picture/base64.hpp"
#include "io/pictures/picture/palette.hpp"

#include <zlib.h>

namespace netloft::pictures {

namespace {

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

/// A chunk: length, name, data and checksum.
std::string chunk(const std::string& name, const std::string& data) {
  const std::string body = name + data;
  const auto sum = crc32(0, bytes_of(body).data(), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body +
         big_endian(static_cast<std::uint32_t>(sum));
}

enum class Depth : char { rgb = 2, palette = 3 };

std::string file_of(const Image& image, Depth depth, const std::string& colours, const std::string& rows) {
  const std::string eight_bits = {8, static_cast<char>(depth), 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(static_cast<std::uint32_t>(image.width)) +
                           big_endian(static_cast<std::uint32_t>(image.height)) + eight_bits) +
         (colours.empty() ? "" : chunk("PLTE", colours)) + chunk("IDAT", deflated(bytes_of(rows))) +
         chunk("IEND", "");
}

}  // namespace

std::string png(const Image& image) {
  std::string rows;
  rows.reserve((3 * image.width + 1) * image.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    rows += '\1';  // filter 1: each byte is its difference from the pixel to the left
    const std::uint8_t* row = image.bytes.data() + 3 * image.width * y;
    for (std::size_t i = 0; i < 3 * image.width; ++i)
      rows += static_cast<char>(row[i] - (i < 3 ? 0 : row[i - 3]));
  }
  return file_of(image, Depth::rgb, "", rows);
}

std::string small_png(const Image& image) {
  const Palette palette = palette_of(image);
  std::string colours, rows;
  for (const auto& colour : palette.colours) colours.append(colour.begin(), colour.end());
  for (std::size_t y = 0; y < image.height; ++y) {
    rows += '\0';  // filter 0: bytes are unchanged
    const auto row = palette.pixels.begin() + static_cast<std::ptrdiff_t>(y * image.width);
    rows.append(row, row + static_cast<std::ptrdiff_t>(image.width));
  }
  return file_of(image, Depth::palette, colours, rows);
}

}  // namespace netloft::pictures
