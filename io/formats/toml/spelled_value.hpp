// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/value.hpp"

#include <string>

namespace netloft::formats {

/// A value in the spelling in which `--set` reads it back. Texts have quotes only where they need them, so
/// that "2.5 kn" and names of parts look as people write them.
std::string spell_value(const Value& value);

}  // namespace netloft::formats
