// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <limits>

namespace netloft {

inline constexpr std::size_t kLanes = NETLOFT_LANES;

inline std::size_t packed(std::size_t dofs) { return dofs * (dofs + 1) / 2; }

/// One worker's tile: inputs, sums, and a square for what comes unpacked. Lines of 64 doubles.
struct Assembler::Workspace {
  Workspace(std::size_t dofs, bool symmetric, bool flows)
      : current(flows ? dofs * kLanes : 0),
        current_dz(flows ? dofs * kLanes : 0),
        x(dofs * kLanes),
        force(dofs * kLanes),
        packed_tangent(packed(dofs) * kLanes),
        square_tangent(symmetric ? 0 : dofs * dofs * kLanes),
        scratch(dofs * dofs * kLanes),
        element(dofs * dofs) {}
  std::vector<double> current, current_dz;  // empty in still water
  std::vector<double> x, force, packed_tangent, square_tangent, scratch, element;
  double energy[kLanes] = {};
  char message[sizeof ElementFault::message] = "";
  ElementFault fault;
  std::size_t fault_order = std::numeric_limits<std::size_t>::max();
};

}  // namespace netloft
