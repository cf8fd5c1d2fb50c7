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
  std::uint32_t traits = 0;  // traits of the term: NETLOFT_IS_WEIGHT and others

  bool is_drag() const { return traits & NETLOFT_IS_DRAG; }
  bool is_weight() const { return traits & NETLOFT_IS_WEIGHT; }
  /// Whether the force acts along a ground that may move: friction, and the resistance of ground that boards
  /// plough.
  bool is_along_ground() const { return traits & NETLOFT_READS_GROUND; }
};

/// Sum of one force of one part over the nodes of a rigid body, that is, its origin and its points.
struct BodyForce {
  std::uint32_t body = 0, part = 0;  // indices in the scene
  PartForce of;
};

/// The outputs and forces of the elements of a scene at positions x, over all dofs.
struct Response {
  std::vector<double> x;
  FamilyOutputs outputs;
  std::vector<PartForce> forces;       // without member forces, which sum to zero over a part
  std::vector<BodyForce> body_forces;  // of all terms, for parts with a node on the body
};

/// Evaluates all elements; without `with_forces` only their outputs, which is faster. Forces that cannot be
/// evaluated at x are left out.
Response ask_elements(const Scene& scene, Assembler& assembler, std::span<const double> x,
                      const Kinematics& motion = {}, bool with_forces = true);

}  // namespace netloft::results
