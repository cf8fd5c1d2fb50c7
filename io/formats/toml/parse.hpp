// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// Deepest nesting of tables and arrays. Deeper nesting is refused, so that functions on the tree can be
/// recursive.
constexpr int kDeepestValue = 64;

/// Reads the table in `text`; `file` is the index of the text in `diagnostics`. nullopt after an error.
std::optional<Value> parse_toml(const std::string& text, int file, Diagnostics& diagnostics);

}  // namespace netloft::formats
