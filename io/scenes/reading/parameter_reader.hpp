// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <span>

namespace netloft::scenes {

/// Reads the parameters that `table` describes from a TOML table; a dot in the name of a parameter marks a
/// key within a table ("twine.EA"). Optional parameters that are absent keep their defaults. Errors go to the
/// diagnostics with their places.
Values read_parameters(std::span<const netloft_parameter> table, formats::TableReader& from);

}  // namespace netloft::scenes
