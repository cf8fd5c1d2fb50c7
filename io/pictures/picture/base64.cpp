// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/base64.hpp"

#include <zlib.h>

#include <cstdint>
#include <stdexcept>

namespace netloft::pictures {

namespace {

constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(Bytes bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16 |
                                (left > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8 : 0u) |
                                (left > 2 ? static_cast<std::uint32_t>(bytes[i + 2]) : 0u);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += left > 1 ? kDigits[group >> 6 & 63] : '=';
    text += left > 2 ? kDigits[group & 63] : '=';
  }
  return text;
}

std::string deflated(Bytes bytes) {
  uLongf size = compressBound(bytes.size());
  std::string small(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(small.data()), &size, bytes.data(), bytes.size(), 6) != Z_OK)
    throw std::runtime_error("not enough memory to compress a page");
  small.resize(size);
  return small;
}

}  // namespace netloft::pictures
