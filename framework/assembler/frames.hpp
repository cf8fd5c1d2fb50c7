// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

namespace netloft {

/// Nodes whose unknowns do not run along x, y and z: on a slider, on a plane at an angle. Elements know
/// nothing of them: they see positions and give forces in the world frame, and what they gave is turned
/// afterwards.
///   x = x₀ + Q u,   r ← Qᵀ r,   K_ab ← Q_aᵀ K_ab Q_b                (1)
/// The columns of Q are the node's own axes, of which some are held. Since Q is constant the tangent stays
/// exact.
class Frames {
 public:
  Frames() = default;
  Frames(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric);

  bool empty() const { return nodes_.empty(); }
  /// Positions of the turned nodes from their start and the displacements of the unknowns.
  void place(std::span<const double> start, std::span<const double> u, std::span<double> x) const;
  /// Rates of the turned nodes from those of the unknowns.
  void turn_back(std::span<const double> own, std::span<double> world) const;
  /// World to node, in vectors over all dofs.
  void turn(double* residual) const;
  /// Blocks of the matrix that touch a turned node.
  void turn_matrix(double* values) const;

 private:
  using Matrix3 = std::array<double, 9>;  // row by row
  struct Node {
    std::array<std::size_t, 3> place;  // of its three entries in vectors over all dofs
    Matrix3 Q;
  };
  struct Block {
    std::size_t base;
    int row, column;  // into nodes_, -1: not turned
    bool lower_only;  // a diagonal block of which the lower triangle is filled
  };

  std::size_t unknowns_ = 0;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
};

}  // namespace netloft
