// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/value.hpp"

#include <string>

namespace netloft::formats {

/// Writes a value so that `--set` reads it back. Texts have quotes only if necessary, so that "2.5 kn" and
/// names of parts look as users write them.
std::string spell_value(const Value& value);

/// Writes a value as TOML for a file: texts always have quotes.
std::string spell_in_file(const Value& value);

}  // namespace netloft::formats
