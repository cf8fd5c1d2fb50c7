// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <span>

namespace netloft::scenes {

/// Reads what a parameter table asks for out of a TOML table; a dot in a name is a table within ("twine.EA").
/// Absent parameters that are not required keep their defaults. Errors are located and go to the diagnostics.
Values read_parameters(std::span<const netloft_parameter> table, formats::TableReader& from);

}  // namespace netloft::scenes
