// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/checksum.hpp"

#include <gtest/gtest.h>

#include <string>

namespace netloft::formats {
namespace {

std::string noise(std::size_t size) {
  std::string bytes;
  for (std::uint32_t state = 1; bytes.size() < size; state = state * 1664525 + 1013904223)
    bytes += static_cast<char>(state >> 24);
  return bytes;
}

/// By the definition: a division of polynomials, bit by bit.
std::uint32_t by_division(std::string_view bytes, std::uint32_t before) {
  std::uint32_t rest = ~before;
  for (const char byte : bytes) {
    rest ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~rest;
}

TEST(Checksum, IsThatOfThePublishedExample) { EXPECT_EQ(checksum("123456789"), 0xcbf43926U); }

TEST(Checksum, IsTheDivisionAtEveryLengthAndAddress) {
  const std::string bytes = noise(400);
  for (std::size_t first = 0; first < 3; ++first)
    for (std::size_t length = 0; first + length <= bytes.size(); ++length) {
      const std::string_view some = std::string_view(bytes).substr(first, length);
      ASSERT_EQ(checksum(some, 0x12345678), by_division(some, 0x12345678)) << length << " bytes";
    }
}

TEST(Checksum, GoesOnFromTheOneBefore) {
  const std::string bytes = noise(100000);
  const std::string_view all = bytes;
  EXPECT_EQ(checksum(all.substr(777), checksum(all.substr(0, 777))), by_division(all, 0));
}

}  // namespace
}  // namespace netloft::formats
