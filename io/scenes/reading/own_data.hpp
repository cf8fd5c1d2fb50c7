// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/element_data.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reads a datum that the host does not give to elements of this type: the value under its name in the table
/// of the part, repeated for each of `elements`. If the table does not have it and the name resembles that of
/// a datum of the host, the error suggests the latter.
void read_own_datum(const ElementType& type, const netloft_datum& datum, std::size_t elements,
                    formats::TableReader& table, ElementData& data);

}  // namespace netloft::scenes
