// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// Tables and arrays nested deeper than this are refused, so that functions on the tree may recurse.
constexpr int kDeepestValue = 64;

/// The table in `text`; `file` is its number in `diagnostics`. Empty after an error.
std::optional<Value> parse_toml(const std::string& text, int file, Diagnostics& diagnostics);

}  // namespace netloft::formats
