// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/text_rows.hpp"

#include <algorithm>
#include <charconv>

namespace netloft::formats {

namespace {

constexpr std::size_t kLongestNumber = 64;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool may_stand_in_a_number(char c) {
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E' || c == 'd' ||
         c == 'D';
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  if (text.empty() || text.size() > kLongestNumber) return {};
  if (!std::all_of(text.begin(), text.end(), may_stand_in_a_number)) return {};
  std::string plain(text[0] == '+' ? text.substr(1) : text);
  if (plain.empty() || plain[0] == '+' || (text[0] == '+' && plain[0] == '-')) return {};
  for (char& c : plain)
    if (c == 'd' || c == 'D') c = 'e';  // Fortran writes powers of ten with D
  double value = 0;
  const auto [end, fault] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (end != plain.data() + plain.size()) return {};
  const bool is_tiny = fault == std::errc::result_out_of_range && plain.find("e-") != std::string::npos;
  return fault == std::errc{} || is_tiny ? std::optional(value)
                                         : std::nullopt;  // a number too small for a double becomes 0
}

std::optional<std::int64_t> integer_in(std::string_view text) {
  std::int64_t value = 0;
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (fault != std::errc{} || end != digits.data() + digits.size() || digits.empty()) return {};
  return value;
}

std::optional<std::string_view> TextRows::next_line() {
  if (at_end()) return {};
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view line = text_.substr(at_, end - at_);
  const bool is_pair = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
  at_ = end + (is_pair ? 2 : 1);
  ++line_;
  return line;
}

std::vector<Word> TextRows::next_row() {
  while (const auto line = next_line())
    if (auto words = words_of(*line); !words.empty()) return words;
  return {};
}

std::vector<Word> TextRows::words_of(std::string_view line) const {
  if (comment_) line = line.substr(0, line.find(comment_));
  std::vector<Word> words;
  int column = 1;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size() && is_blank(line[end]) == is_blank(line[at])) ++end;
    const int length =
        static_cast<int>(std::count_if(line.begin() + std::ptrdiff_t(at), line.begin() + std::ptrdiff_t(end),
                                       [](char c) { return (c & 0xC0) != 0x80; }));
    if (!is_blank(line[at]))
      words.push_back({line.substr(at, end - at), {file_, line_, column, std::max(length, 1)}});
    column += length;
    at = end;
  }
  return words;
}

}  // namespace netloft::formats
