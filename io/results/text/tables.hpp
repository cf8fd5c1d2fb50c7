// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <cstddef>
#include <string>

namespace netloft::results {

/// A line per node of a state: part, number in the part, position, forces of the holds on it.
std::string nodes_csv(const StoredShape& stored, std::size_t state);

/// A line per element of a state: part, nodes, all fields; empty where an element has none.
std::string elements_csv(const StoredShape& stored, std::size_t state);

/// A field of a CSV line (RFC 4180).
std::string csv_field(const std::string& text);
/// A number of a CSV line; empty if it is not known.
std::string csv_number(double value);

}  // namespace netloft::results
