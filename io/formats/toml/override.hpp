// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// Applies "parts.net.cells=[64,64]" as from `--set`. The value is TOML; anything else is taken as a text, so
/// that solver=newton and bar=0.6 m need no quotes. It replaces an existing value, tables too, and creates
/// missing tables on the path. Items of arrays count from 0: "hold[0].at[2]=-19 m". `option` is the one that
/// the text follows, in messages.
void apply_override(Value& root, const std::string& text, Diagnostics& diagnostics,
                    const std::string& option = "--set");

}  // namespace netloft::formats
