// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/element_data.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reads a datum of elements that the host does not compute. The table of the part has one value under the
/// name of the datum, which all `elements` get. If the value is missing and the host computes a datum with a
/// similar name, the error suggests this datum.
void read_own_datum(const ElementType& type, const netloft_datum& datum, std::size_t elements,
                    formats::TableReader& table, ElementData& data);

}  // namespace netloft::scenes
