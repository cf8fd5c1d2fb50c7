// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/element_data.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reads a datum that the host does not give to elements of this type: `elements` times what the table of
/// their part says under its name. Where it says nothing, the error names what the author of the element may
/// have meant.
void read_own_datum(const ElementType& type, const netloft_datum& datum, std::size_t elements,
                    formats::TableReader& table, ElementData& data);

}  // namespace netloft::scenes
