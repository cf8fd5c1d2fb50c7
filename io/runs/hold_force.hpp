// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <array>
#include <span>

namespace netloft::runs {

/// Sum of the forces of a hold on the gear [N], from the residual over all dofs.
inline std::array<double, 3> force_of(const scenes::Hold& hold, const Assembler& assembler,
                                      std::span<const double> residual) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < hold.nodes.size(); ++i) {
    const auto force = assembler.reaction(hold.nodes[i], residual, hold.axes[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += force[axis];
  }
  return sum;
}

}  // namespace netloft::runs
