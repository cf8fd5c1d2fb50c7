// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <cstddef>
#include <string>

namespace netloft::results {

/// CSV of the nodes of a state: part, number in the part, position, forces of the holds on the node.
std::string nodes_csv(const StoredShape& stored, std::size_t state);

/// CSV of the elements of a state: part, nodes, all fields. The cell of a field is empty if the element has
/// no value.
std::string elements_csv(const StoredShape& stored, std::size_t state);

}  // namespace netloft::results
