// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/bodies.hpp"
#include "framework/assembler/frames.hpp"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace netloft {

/// Computes the positions and rates of nodes from the unknowns and their rates. A node may be free, held,
/// moved along a given path by a guide, carried by a rigid body, or have axes of its own. Elements see
/// positions and rates only. Vectors over all degrees of freedom (dofs) have the order of `numbering()`.
class Placement {
 public:
  /// `nodes` are the nodes of the scene, followed by nodes for the rotations of bodies and for unknowns that
  /// elements share. `blocks` are the node pairs with matrix values.
  Placement(const Scene& scene, const Scene& nodes, const NodeBlocks& blocks, bool symmetric);

  const Numbering& numbering() const { return numbering_; }

  /// Computes the positions over all dofs at displacements u of the unknowns [m]. Guided nodes are at their
  /// positions at `time` [s]. Positions of held nodes do not change: x must contain them already, as start()
  /// does.
  void place(std::span<const double> u, std::span<double> x, double time = 0) const;
  /// Computes positions at displacements u from positions `base` [m]: x in double precision, and in x_low the
  /// digits that rounding removes from x. No node may be carried by a body.
  void place_from(std::span<const double> base, std::span<const double> u, std::span<double> x,
                  std::span<double> x_low) const;
  bool has_bodies() const { return !bodies_.empty(); }
  /// The origin of the body that carries a node; the node itself if no body carries it.
  std::uint32_t carrier(std::uint32_t node) const { return bodies_.carrier(node); }
  /// Computes the rates of all dofs at positions x from the rates of the unknowns and of the guides.
  void move(double time, std::span<const double> x, std::span<const double> v, std::span<const double> a,
            std::span<double> all_v, std::span<double> all_a) const;
  /// Replaces rotation vectors longer than ¾ of a turn by the shorter vectors of the same rotations. Changes
  /// the displacements u of the unknowns and their rates v and a, which may be empty. Must not be called
  /// during a solve, because a solver compares displacements with earlier ones. Returns whether any vector
  /// was replaced.
  bool shorten_rotations(std::span<double> u, std::span<double> v = {}, std::span<double> a = {}) const;
  /// Displacements of the unknowns that bring the nodes as close as possible to `positions`, 3 per node of
  /// the scene [m].
  std::vector<double> displacements(std::span<const double> positions) const;
  /// Displacements u for which the unknowns have the values in `x`, a vector over all dofs with the same
  /// numbering.
  std::vector<double> displacements_to(std::span<const double> x) const;
  /// Writes the rotations of bodies into the displacements u. Their values are those of another mesh of the
  /// same gear, whose placement is `from` and whose positions are x.
  void take_rotations(const Placement& from, std::span<const double> x, std::span<double> u) const;
  /// Extracts the positions of the scene's nodes, 3 per node, from a vector x over all dofs [m]. x may also
  /// be velocities or displacements. Unknowns that the elements of a part share have no position and are left
  /// out.
  std::vector<double> node_positions(std::span<const double> x) const;
  std::array<double, 3> node_position(std::uint32_t node, std::span<const double> x) const;
  /// Whether an entry of a vector over all dofs is a coordinate of a node of the scene [m].
  bool is_place(std::size_t i) const { return numbering_.node(Dof(i)) < scene_nodes_; }
  /// The rotation vector of a body at positions x over all dofs [rad].
  std::array<double, 3> rotation(std::size_t body, std::span<const double> x) const;
  bool is_guided() const { return !guides_.empty(); }
  /// Splits a residual [N] at a node into the reaction (along the held axes) and the unbalanced force (along
  /// the free axes), in the world frame.
  std::array<double, 3> reaction(std::uint32_t node, std::span<const double> residual,
                                 std::uint8_t axes = kAllAxes) const;
  std::array<double, 3> unbalanced(std::uint32_t node, std::span<const double> residual) const;

  /// Initial positions over all dofs [m].
  const std::vector<double>& start() const { return start_; }
  /// For each body, the nodes of its origin and of its rotation.
  const std::vector<std::array<std::uint32_t, 2>>& body_nodes() const { return bodies_.pairs(); }

 protected:
  bool is_over_dofs(std::span<const double> v) const { return v.size() == numbering_.dofs(); }
  bool is_over_unknowns(std::span<const double> v) const {
    return v.size() == static_cast<std::size_t>(numbering_.unknowns());
  }

  std::size_t scene_nodes_;
  Numbering numbering_;
  std::map<std::uint32_t, std::array<double, 9>> axes_;  // axes of nodes whose unknowns are not along x, y, z
  Frames frames_;
  Bodies bodies_;

 private:
  template <class Visit>
  void visit_guided(double time, const Visit& visit) const;
  std::array<double, 3> part_of(std::uint32_t node, std::span<const double> residual, bool held,
                                std::uint8_t axes) const;

  std::vector<Guide> guides_;
  std::vector<double> start_;
};

}  // namespace netloft
