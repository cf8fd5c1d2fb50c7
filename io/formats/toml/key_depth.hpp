// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace netloft::formats {

/// Largest number of parts of a dotted key. toml++ limits the nesting by brackets but not by dotted keys: a
/// key with 200 000 parts overflows its stack.
constexpr int kMostKeyParts = 32;

struct DeepKey {
  int line = 1;
  int column = 1;
};

/// The first dotted key with more than kMostKeyParts parts; nullopt if there is none.
std::optional<DeepKey> find_deep_key(std::string_view text);

}  // namespace netloft::formats
