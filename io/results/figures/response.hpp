// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace netloft::results {

/// Outputs of all elements, indexed [family][output][element]. A family is all elements of one type.
using FamilyOutputs = std::vector<std::vector<std::vector<double>>>;

/// Sum of one term (kind of force) over one part, as a force on the gear [N].
struct PartForce {
  std::string part, term;
  std::array<double, 3> force{};
  std::uint32_t traits = 0;  // traits of the term: NETLOFT_IS_WEIGHT and others

  bool is_drag() const { return traits & NETLOFT_IS_DRAG; }
  bool is_weight() const { return traits & NETLOFT_IS_WEIGHT; }
  /// Whether the force depends on the velocity relative to the ground: friction, or the resistance of ground
  /// that boards plough.
  bool is_along_ground() const { return traits & NETLOFT_READS_GROUND; }
};

/// The contribution of one part and term to the force on a rigid body, summed over the nodes of the body (its
/// origin and its points).
struct BodyForce {
  std::uint32_t body = 0, part = 0;  // indices of body and part in the scene
  PartForce of;
};

/// The outputs and forces of the elements of a scene at positions x, which are the values of all degrees of
/// freedom.
struct Response {
  std::vector<double> x;
  FamilyOutputs outputs;
  std::vector<PartForce> forces;       // internal forces are left out: they sum to zero over a part
  std::vector<BodyForce> body_forces;  // forces on bodies, by term, of all parts with a node on a body
  /// Force of the water on all parts whose water a flow changes, over all dofs [N]; empty without a flow.
  std::vector<double> drag_in_flow;
};

/// Evaluates all elements of the scene at positions x. Without `with_forces`, evaluates only their outputs,
/// which is faster. Forces that cannot be evaluated at x are left out.
Response ask_elements(const Scene& scene, Assembler& assembler, std::span<const double> x,
                      const Kinematics& motion = {}, bool with_forces = true);

}  // namespace netloft::results
