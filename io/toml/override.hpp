// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "io/toml/value.hpp"

namespace netloft::io {

/// Applies "parts.net.cells=[64,64]" as from `--set`. The value is TOML; what is no TOML is a text, so that
/// solver=newton and bar=0.6 m need no quotes. It replaces what is there, tables too, and makes the tables on
/// its way.
void apply_override(Value& root, const std::string& text, Diagnostics& diagnostics);

}  // namespace netloft::io
