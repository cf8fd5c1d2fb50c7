// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace netloft::formats {

/// TOML nests by brackets, which toml++ limits, and by dotted keys, which it does not: 200 000 of them
/// overflow its stack.
constexpr int kMostKeyParts = 32;

struct DeepKey {
  int line = 1;
  int column = 1;
};

/// The first dotted key with more than kMostKeyParts parts.
std::optional<DeepKey> find_deep_key(std::string_view text);

}  // namespace netloft::formats
