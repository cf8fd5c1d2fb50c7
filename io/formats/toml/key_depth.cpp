// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/key_depth.hpp"

#include <algorithm>
#include <string>

namespace netloft::formats {
namespace {

std::size_t end_of_line(std::string_view text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

/// The position after the string that begins at `at`. If the string has no end, this is the end of its line
/// or of the text.
std::size_t skip_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string triple(3, quote);
  const bool multiline = text.substr(at).starts_with(triple);
  for (std::size_t i = at + (multiline ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (multiline ? text.substr(i).starts_with(triple) : text[i] == quote) {
      return i + (multiline ? 3 : 1);
    } else if (!multiline && text[i] == '\n') {
      return i;
    }
  }
  return text.size();
}

bool separates_keys(char c) { return std::string_view("\n=,[]{}").find(c) != std::string_view::npos; }

DeepKey spot_at(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t newline = before.rfind('\n');
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(at - begin) + 1};
}

}  // namespace

std::optional<DeepKey> find_deep_key(std::string_view text) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '#') {
      i = end_of_line(text, i);
    } else if (c == '"' || c == '\'') {
      i = skip_string(text, i);
    } else {
      if (separates_keys(c)) dots = 0;
      if (c == '.' && ++dots >= kMostKeyParts) return spot_at(text, i);
      ++i;
    }
  }
  return std::nullopt;
}

}  // namespace netloft::formats
