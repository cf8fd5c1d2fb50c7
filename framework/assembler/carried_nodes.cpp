// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/carried_nodes.hpp"

namespace netloft {

/// The geometric term of a body, (3) of bodies.hpp, contains forces, which are therefore evaluated even if
/// the request does not ask for them. Reuse of the forces of the last evaluation at the same x would save
/// less than 0.2 % of a search for an equilibrium with otter boards (83-112-at-sea-66m, with 2000 and 8000
/// nodes) and 1.4 % of a motion with them (dynamics/83-112-in-motion).
bool CarriedNodes::pass_on(std::span<const double> x, const Request& request) {
  if (bodies_.empty()) return true;
  double* residual = request.residual;
  const bool exact = request.values && request.matrix == MatrixKind::exact;
  Request again{.without = request.without, .motion = request.motion, .between = request.between};
  if (!residual && exact) {
    forces_.assign(dofs_, 0.0);
    again.residual = residual = forces_.data();
    if (!elements_.run_carried(x, again)) return false;
  }
  BodyMatrices matrices{request.values};
  if (exact && request.motion.v && tangent_ == TangentChoice::exact &&
      !find_rate_matrices(x, again, matrices))
    return false;
  const Kinematics& m = request.motion;
  const BodyMotion motion{m.v, m.a, m.cu, m.cv, m.ca};
  bodies_.hand_on(x, motion, residual, matrices, exact);
  if (request.gradient) bodies_.hand_on(x, motion, request.gradient, {}, false);
  if (request.values && request.matrix == MatrixKind::metric) bodies_.resist_turning(request.values);
  return true;
}

/// Evaluates the damping matrix C and the mass matrix M of (4) of bodies.hpp. The matrices are needed because
/// the velocities and accelerations of carried nodes depend on the rotation of their body.
bool CarriedNodes::find_rate_matrices(std::span<const double> x, Request request, BodyMatrices& matrices) {
  request.residual = nullptr;
  request.matrix = MatrixKind::exact;
  request.motion.cu = request.motion.cv = request.motion.ca = 0;
  damping_.assign(elements_.tiles().values, 0.0);
  mass_.assign(elements_.tiles().values, 0.0);
  request.values = damping_.data();
  request.motion.cv = 1;
  if (!elements_.run_carried(x, request)) return false;
  request.values = mass_.data();
  request.motion.cv = 0;
  request.motion.ca = 1;
  if (!elements_.run_carried(x, request)) return false;
  matrices.damping = damping_.data();
  matrices.mass = mass_.data();
  return true;
}

}  // namespace netloft
