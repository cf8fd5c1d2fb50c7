// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace netloft::results {

/// Outputs of all families: [family][output][element].
using FamilyOutputs = std::vector<std::vector<std::vector<double>>>;

/// Sum of one force over one part, in the direction in which it acts on the gear [N].
struct PartForce {
  std::string part, term;
  std::array<double, 3> force{};
  std::uint32_t traits = 0;  // of the term: NETLOFT_IS_WEIGHT and others

  bool is_drag() const { return traits & NETLOFT_IS_DRAG; }
  bool is_weight() const { return traits & NETLOFT_IS_WEIGHT; }
  /// Along a ground that may move: friction, and the resistance of ground that boards plough up.
  bool is_along_ground() const { return traits & NETLOFT_READS_GROUND; }
};

/// Sum of one force of one part over the nodes of a rigid body: its origin and its points.
struct BodyForce {
  std::uint32_t body = 0, part = 0;  // of the scene
  PartForce of;
};

/// The outputs and forces of the elements of a scene at positions x, over all dofs.
struct Response {
  std::vector<double> x;
  FamilyOutputs outputs;
  std::vector<PartForce> forces;       // but for those of members, which add up to nothing over a part
  std::vector<BodyForce> body_forces;  // of all terms of parts with a node on the body
};

/// Evaluates all elements; without `with_forces` their outputs alone, which takes a part of the time. Forces
/// that cannot be evaluated at x are left out.
Response ask_elements(const Scene& scene, Assembler& assembler, std::span<const double> x,
                      const Kinematics& motion = {}, bool with_forces = true);

}  // namespace netloft::results
