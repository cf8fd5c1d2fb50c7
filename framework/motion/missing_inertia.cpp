// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/missing_inertia.hpp"

#include <Eigen/Dense>

#include <algorithm>

#include "framework/motion/node_masses.hpp"

namespace netloft {

namespace {

// An inertia about an axis counts as rounding error below this fraction of the largest inertia: all masses of
// the body then lie on the axis.
constexpr double kLeastInertia = 1e-12;

using Block3 = Eigen::Matrix3d;

/// Inertia of a body about its centre of mass, divided by the square of the body's arm [kg], from blocks M of
/// the mass matrix:
///   J = M_qq − M_Xqᵀ M_XX⁻¹ M_Xq,  X its origin, q its rotation times its arm                      (1)
class OwnMasses {
 public:
  OwnMasses(Assembler& assembler, const std::vector<double>& blocks, std::size_t body) {
    const auto [origin, rotation] = assembler.body_nodes()[body];
    const auto at = [&](std::size_t first) {
      return Block3(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&blocks[first]));
    };
    mass_ = at(9 * std::size_t{origin});
    turning_ = at(9 * std::size_t{rotation});
    coupling_ = at(9 * (assembler.numbering().dofs() / 3 + body));
  }
  bool has_mass() const { return is_definite(mass_, mass_.trace()); }
  /// Whether the body has inertia about every axis about which it can turn.
  bool resists_turning(std::uint8_t held) const {
    Block3 J = turning_ - coupling_.transpose() * mass_.inverse() * coupling_;  // (1)
    const double largest = turning_.trace();
    for (int axis = 0; axis < 3; ++axis)
      if (held & (1 << axis)) {
        J.row(axis).setZero();
        J.col(axis).setZero();
        J(axis, axis) = largest;
      }
    return is_definite(J, largest);
  }

 private:
  static bool is_definite(const Block3& M, double largest) {
    return largest > 0 && Eigen::SelfAdjointEigenSolver<Block3>(M, Eigen::EigenvaluesOnly).eigenvalues()(0) >
                              kLeastInertia * largest;
  }
  Block3 mass_, turning_, coupling_;
};

/// A copy of the scene in which bodies carry no nodes.
Scene bare_bodies(const Scene& scene) {
  Scene bare = scene;
  for (RigidBody& body : bare.bodies) body.points.clear();
  std::fill(bare.carried.begin(), bare.carried.end(), false);
  return bare;
}

void add_bodies(const Scene& scene, const ScenePlan& plan, std::vector<MissingInertia>& missing) {
  if (scene.bodies.empty()) return;
  const Scene bare = bare_bodies(scene);
  Assembler assembler(bare, plan, 1);
  std::vector<double> blocks(assembler.mass_numbers());
  double coupled = 0;
  if (!assembler.masses(assembler.start(), blocks, coupled)) return;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const RigidBody& body = scene.bodies[b];
    const OwnMasses own(assembler, blocks, b);
    if (!own.has_mass())
      missing.push_back({body.origin, b, false});
    else if (!own.resists_turning(body.held_rotation))
      missing.push_back({body.origin, b, true});
  }
}

}  // namespace

bool MissingInertia::is_on(const Part& part) const {
  return std::find(part.nodes.begin(), part.nodes.end(), node) != part.nodes.end();
}

std::vector<MissingInertia> find_missing_inertia(const Scene& scene, const ScenePlan& plan,
                                                 Assembler& assembler, bool with_nodes) {
  std::vector<MissingInertia> missing;
  add_bodies(scene, plan, missing);
  NodeMasses masses(assembler);
  if (!with_nodes || !masses.update(assembler.start())) return missing;
  for (const std::uint32_t node : masses.massless_nodes())
    if (!scene.body_at(node)) missing.push_back({node});
  return missing;
}

}  // namespace netloft
