// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/literal.hpp"

#include <algorithm>

namespace netloft::design {

namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The position after the quoted text that begins at `at`.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool has_escapes = quote == '"';
  const bool is_long = text.substr(at, 3) == std::string_view(has_escapes ? "\"\"\"" : "'''");
  std::size_t i = at + (is_long ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (has_escapes && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote && !is_long) {
      return i + 1;
    } else if (is_long && text.substr(i, 3) == text.substr(at, 3)) {
      i += 3;
      while (i < text.size() && text[i] == quote) ++i;  // up to two quotes at the end belong to the text
      return i;
    }
  }
  return text.size();
}

std::size_t end_of_brackets(std::string_view text, std::size_t at) {
  std::size_t depth = 0, i = at;
  while (i < text.size()) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_quoted(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    ++i;
    if (depth == 0) return i;
  }
  return text.size();
}

}  // namespace

std::size_t byte_at(std::string_view text, int line, int column) {
  std::size_t at = 0;
  for (int l = 1; l < line && at < text.size(); ++l) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  for (int c = 1; c < column && at < text.size() && text[at] != '\n'; ++c) {
    ++at;
    while (at < text.size() && continues_character(text[at])) ++at;
  }
  return at;
}

std::size_t length_of_literal(std::string_view text, std::size_t begin) {
  if (begin >= text.size()) return 0;
  const char c = text[begin];
  if (c == '"' || c == '\'') return end_of_quoted(text, begin) - begin;
  if (c == '[' || c == '{') return end_of_brackets(text, begin) - begin;
  return std::min(text.find_first_of(",]}# \t\r\n", begin), text.size()) - begin;
}

}  // namespace netloft::design
