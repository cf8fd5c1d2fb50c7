// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace netloft::results {

/// Nodes of a rope from its start to its end; empty if there is no such rope.
std::vector<std::uint32_t> nodes_of_rope(const StoredShape& stored, const std::string& name);

}  // namespace netloft::results
