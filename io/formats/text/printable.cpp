// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/printable.hpp"

#include <cstdio>

#include "io/formats/text/utf8.hpp"

namespace netloft::formats {
namespace {

constexpr unsigned kDelete = 0x7F, kEndOfSecondSet = 0xA0;

bool is_control(unsigned code) { return code < 0x20 || (code >= kDelete && code < kEndOfSecondSet); }

/// The next character of a text.
struct Character {
  std::string_view bytes;
  unsigned control = 0;  // if is_control: the code, or the value of a byte that is not UTF-8
  bool is_control = false;
};

Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const std::size_t length = sequence_length(text);
  if (length <= 1) return {text.substr(0, 1), byte(0), is_control(byte(0))};
  // A character of two bytes, the first of which is C2, has the value of the second one (RFC 3629).
  const bool is_second_set = length == 2 && byte(0) == 0xC2 && is_control(byte(1));
  return {text.substr(0, length), is_second_set ? byte(1) : 0, is_second_set};
}

std::string escaped(unsigned code) {
  char text[8];
  std::snprintf(text, sizeof text, "\\u%04x", code & 0xFFFF);
  return text;
}

/// Replaces each control character by what `replacement` returns for the code of the character and the text
/// that begins with it.
template <class Replacement>
std::string replaced(std::string_view text, const Replacement& replacement) {
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_of(text);
    if (c.is_control)
      safe += replacement(c.control, text);
    else
      safe += c.bytes;
    text.remove_prefix(c.bytes.size());
  }
  return safe;
}

}  // namespace

std::string printable(std::string_view text) {
  return replaced(text, [](unsigned code, std::string_view rest) {
    if (code == '\n' || code == '\t') return std::string(1, static_cast<char>(code));
    return rest.starts_with("\r\n") ? std::string() : escaped(code);
  });
}

std::string printable_in_line(std::string_view text) {
  return replaced(
      text, [](unsigned code, std::string_view) { return code == '\t' ? std::string(" ") : escaped(code); });
}

bool has_control_characters(std::string_view text) {
  for (; !text.empty(); text.remove_prefix(first_of(text).bytes.size()))
    if (first_of(text).is_control) return true;
  return false;
}

}  // namespace netloft::formats
