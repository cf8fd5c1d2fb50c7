// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <optional>
#include <string>

namespace netloft::results {

/// The node that moved farthest between two results.
struct NodeMove {
  double distance = 0;  // [m]
  std::string part;
  std::uint32_t number = 0;                 // number of the node within its part, in the earlier result
  std::array<double, 3> before{}, after{};  // [m]
  std::size_t compared = 0;  // number of nodes of the earlier result that also exist in the later result
  std::size_t nodes = 0;     // number of nodes of the earlier result
};

/// Compares the last states of two results. If a part has equally many nodes in both results, its nodes are
/// compared by number. If netting is divided differently, nodes are compared by their panel coordinates: the
/// position in the other result is interpolated there. nullopt if no node can be compared.
std::optional<NodeMove> find_largest_move(const StoredShape& before, const StoredShape& after);

}  // namespace netloft::results
