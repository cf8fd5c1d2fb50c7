// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

namespace netloft {

/// Nodes whose unknowns are not along x, y and z, such as nodes on a slider or on an inclined plane. Elements
/// work in the world frame; afterwards, their residuals r and matrix blocks K_ab (of nodes a and b) are
/// rotated.
///   x = x₀ + Q u,   r ← Qᵀ r,   K_ab ← Q_aᵀ K_ab Q_b                (1)
/// The columns of Q are the axes of the three coordinates u of a node; some of the coordinates are held. Q is
/// constant, so that the tangent stays exact.
class Frames {
 public:
  Frames(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric);

  bool empty() const { return nodes_.empty(); }
  /// Computes the positions of the rotated nodes from their positions at the start and the displacements of
  /// the unknowns.
  void place(std::span<const double> start, std::span<const double> u, std::span<double> x) const;
  /// Computes velocities or accelerations of the rotated nodes in the world frame from their components along
  /// the nodes' own axes.
  void turn_back(std::span<const double> own, std::span<double> world) const;
  /// Rotates a residual from the world frame to the nodes' own axes, in a vector over all dofs.
  void turn(double* residual) const;
  /// Rotates the blocks of the matrix that involve a rotated node.
  void turn_matrix(double* values) const;

 private:
  using Matrix3 = std::array<double, 9>;  // entries row by row
  struct Node {
    std::array<std::size_t, 3> place;  // indices of its three dofs in vectors over all dofs
    Matrix3 Q;
  };
  struct Block {
    std::size_t base;
    int row, column;  // indices in nodes_ of the nodes of the block; -1: not rotated
    bool lower_only;  // a diagonal block that stores only its lower triangle
  };

  std::size_t unknowns_ = 0;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
};

}  // namespace netloft
