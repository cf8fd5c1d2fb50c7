// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

namespace netloft {

/// Nodes carried by a rigid body. Elements treat them like any other node; their forces and matrices are
/// passed on to the body.
///   x = X + R(θ) r                                    r: the node in the body's own frame          (1)
///   f_X += f,   f_θ += Gᵀ f,   G = ∂x/∂θ                                                           (2)
///   K ← [I G]ᵀ K [I G],   K_θθ += Σ_i f_i ∂²x_i/∂θ²   the geometric term                           (3)
/// θ is the rotation vector from the start; R its rotation (Rodrigues). G and the second derivatives are
/// exact, by dual numbers, so that the tangent is exact, too, for rotations below a full turn. f_θ is the
/// moment that does work on θ; for small θ it is Σ (R r) × f.
class Bodies {
 public:
  Bodies() = default;
  Bodies(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric);

  bool empty() const { return points_.empty(); }
  /// Positions of carried nodes from those of their bodies, (1).
  void place(std::span<double> x) const;
  /// Forces on carried nodes are passed on to their bodies, (2). Matrix values of an evaluation at x are
  /// passed on as well, with the geometric term of (3) if `exact`; both pointers may be null.
  void hand_on(std::span<const double> x, double* residual, double* values, bool exact);

 private:
  using Matrix3 = std::array<double, 9>;  // row by row
  static constexpr std::size_t kNoBlock = ~std::size_t{0};
  struct Point {
    std::array<std::size_t, 3> at, position, rotation;  // indices in vectors over all dofs
    std::array<double, 3> r;
    std::size_t rotation_block;  // of the body's rotation with itself; unset if it cannot turn
    Matrix3 G{};
    std::array<Matrix3, 3> second{};  // ∂²x_i/∂θ²
  };
  /// One product of (3): values[to] += Lᵀ values[from] R, transposed or together with its transpose if
  /// required.
  struct Product {
    std::size_t from, to;
    int left, right;     // points whose G is the factor, -1: the identity
    bool from_diagonal;  // only the lower triangle of the source is filled
    bool transposed, both;
  };

  void differentiate(std::span<const double> x);
  void add_products(const NodeBlocks& blocks, std::size_t from, std::uint32_t row, std::uint32_t column,
                    bool symmetric);

  std::vector<Point> points_;
  std::vector<Product> products_;
  struct Target {
    std::uint32_t node;
    int point;  // the point whose G is used, -1: the identity
  };
  std::vector<std::vector<Target>> targets_;  // per scene node: itself, or position and rotation of its body
};

}  // namespace netloft
