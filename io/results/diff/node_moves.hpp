// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <optional>
#include <string>

namespace netloft::results {

/// The node that lies farthest from where it was.
struct NodeMove {
  double distance = 0;  // [m]
  std::string part;
  std::uint32_t number = 0;                 // of the node within its part, before
  std::array<double, 3> before{}, after{};  // [m]
  std::size_t compared = 0;                 // nodes of the result before that were found in the one after
  std::size_t nodes = 0;                    // of the result before
};

/// Compares the newest states. Nodes of a part that has as many in both are compared by number; those of
/// netting that is divided differently by their place on the panel, between the nodes around it. Nothing if
/// no node can be compared.
std::optional<NodeMove> find_largest_move(const StoredShape& before, const StoredShape& after);

}  // namespace netloft::results
