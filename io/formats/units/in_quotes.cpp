// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/in_quotes.hpp"

namespace netloft::formats {

namespace {

constexpr std::size_t kLongestQuote = 60;
constexpr std::size_t kBehindFirst = 3;  // most bytes of a UTF-8 character after its first

}  // namespace

std::string in_quotes(std::string_view text) {
  if (text.size() <= kLongestQuote) return '"' + std::string(text) + '"';
  std::size_t end = kLongestQuote;
  while (end > kLongestQuote - kBehindFirst && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
    --end;  // avoids cutting a character in two
  return '"' + std::string(text.substr(0, end)) + "...\"";
}

}  // namespace netloft::formats
