// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace netloft::io {

/// Outputs of all families: [family][output][element].
using FamilyOutputs = std::vector<std::vector<std::vector<double>>>;

/// Sum of one force over one part, as the gear feels it [N].
struct PartForce {
  std::string part, term;
  std::array<double, 3> force{};
  std::uint32_t traits = 0;  // of the term: NETLOFT_IS_WEIGHT, NETLOFT_IS_DRAG and others
};

/// What comes out of the elements of a scene that is at positions x, over all dofs.
struct Answer {
  std::vector<double> x;
  FamilyOutputs outputs;
  std::vector<PartForce> forces;
};

/// Asks all elements. Forces that could not be evaluated at x are left out.
Answer ask_elements(const Scene& scene, Assembler& assembler, std::span<const double> x,
                    const Kinematics& motion = {});

}  // namespace netloft::io
