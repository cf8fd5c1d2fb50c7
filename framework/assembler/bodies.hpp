// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

namespace netloft {

/// Velocities and accelerations over all dofs (nullptr at rest), and the factors of the derivatives of the
/// residual r in the matrix cu ∂r/∂x + cv ∂r/∂v + ca ∂r/∂a.
struct BodyMotion {
  const double *v = nullptr, *a = nullptr;
  double cu = 1, cv = 0, ca = 0;
};

/// The matrix values of one evaluation, to which hand_on() adds the values of carried nodes. `damping` and
/// `mass` are the sums of C and M in (4) below over the elements at carried nodes; both are nullptr if (4) is
/// not needed.
struct BodyMatrices {
  double* values = nullptr;
  const double *damping = nullptr, *mass = nullptr;
};

/// Nodes that rigid bodies carry. Elements treat a carried node at x like any other; the residual f and the
/// matrix values K of the node are then passed on to its body. X is the origin of the body, ψ its rotation
/// vector, ℓ a length (its arm), q = ℓψ the unknowns of its rotation, and r the position of the node in the
/// body's own axes:
///   x = X + R(ψ) r,   ẋ = Ẋ + G q̇,   ẍ = Ẍ + G q̈ + Ġ q̇,   G = ∂x/∂q                                     (1)
///   f_X += f,   f_q += Gᵀ f                                                                             (2)
///   K ← [I G]ᵀ K [I G],   K_qq += cu Σ_i f_i ∂²x_i/∂q²    (the geometric term)                          (3)
///   K_·q += [I G]ᵀ (C V + M (cv A_v + cu A)),  V = cu ∂ẋ/∂q,  A_v = ∂ẍ/∂q̇,  A = ∂ẍ/∂q    (in motion)    (4)
/// where K = cu ∂f/∂x + cv C + ca M, C = ∂f/∂ẋ, M = ∂f/∂ẍ. All derivatives are exact (dual numbers). f_q is a
/// force: the moment that does work on ψ, divided by the arm.
class Bodies {
 public:
  Bodies(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric);

  bool empty() const { return pairs_.empty(); }
  /// For each body, the numbers of two nodes: the origin, and the node whose coordinates are the rotation.
  const std::vector<std::array<std::uint32_t, 2>>& pairs() const { return pairs_; }
  double arm(std::size_t body) const { return bodies_[body].arm; }
  /// The origin of the body that carries a node; the node itself if no body carries it.
  std::uint32_t carrier(std::uint32_t node) const {
    for (const Point& point : points_)
      if (point.node == node) return pairs_[point.body][0];
    return node;
  }
  /// Computes the positions of carried nodes from the positions of their bodies by (1).
  void place(std::span<double> x) const;
  /// Computes the velocities and accelerations of carried nodes from the motion of their bodies by (1).
  void move(std::span<const double> x, std::span<double> v, std::span<double> a) const;
  /// Passes the forces on carried nodes on to their bodies by (2), and the matrix values of an evaluation at
  /// x by (3) and (4). The geometric term of (3) is added only if `exact`. `residual` and the values may be
  /// nullptr.
  void hand_on(std::span<const double> x, const BodyMotion& motion, double* residual,
               const BodyMatrices& matrices, bool exact);
  /// Replaces the rotation block A of each body by an upper bound of A. `metric` has the values of a positive
  /// semi-definite matrix, after hand_on():
  ///   tr(A) I ≥ A                                                                           (5)
  /// If all points of the body are on one line, nothing resists a rotation about that line, and A itself is
  /// singular.
  void resist_turning(double* metric) const;
  /// Adds the mass blocks of carried nodes to the mass blocks of their bodies by (3). `between` has one block
  /// per body, with a row per axis of the origin and a column per axis of the rotation.
  void hand_on_masses(std::span<const double> x, std::span<double> blocks, std::span<double> between) const;
  /// Replaces rotation vectors longer than ¾ of a turn by the shorter vectors of the same rotations, and
  /// their rates by rates that give the same spin. `u` are displacements of the unknowns from `start`; `v`
  /// and `a` are the rates of u and may be empty. Returns whether any vector was replaced.
  bool shorten(std::span<const double> start, std::span<double> u, std::span<double> v,
               std::span<double> a) const;

 private:
  using Matrix3 = std::array<double, 9>;  // entries row by row
  static constexpr std::size_t kNoBlock = ~std::size_t{0};
  using Place = std::array<std::size_t, 3>;  // indices in vectors over all dofs
  struct Body {
    Place origin, rotation;
    double arm;
    std::size_t
        rotation_block;  // index of the diagonal block of the rotation; kNoBlock if the body cannot turn
  };
  struct Point {
    std::uint32_t node;
    Place at;
    std::array<double, 3> r;
    std::size_t body;
  };
  /// Derivatives of the position and the rates of a point.
  struct Slopes {
    Matrix3 G;
    std::array<Matrix3, 3> second;           // second derivatives ∂²x_i/∂q²
    Matrix3 velocity, acceleration_by_rate;  // derivatives ∂ẋ/∂q and ∂ẍ/∂q̇
    Matrix3 acceleration;                    // derivative ∂ẍ/∂q
  };
  /// One of the products in (3): values[to] += P = Lᵀ values[from] R, where L and R are G or the identity. If
  /// `transposed`, Pᵀ is added instead; if `both`, P + Pᵀ.
  struct Product {
    std::size_t from, to;
    int left, right;     // points whose G is this factor; -1: the factor is the identity
    bool from_diagonal;  // only the lower triangle of values[from] is filled
    bool transposed, both;
  };

  void differentiate(std::span<const double> x, const BodyMotion& motion);
  void add_products(const NodeBlocks& blocks, std::size_t from, std::uint32_t row, std::uint32_t column,
                    bool symmetric);
  void hand_on_matrix(const Product& product, const BodyMotion& motion, const BodyMatrices& matrices) const;

  struct Target {
    std::uint32_t node;
    int point;  // point whose G is used; -1: use the identity
  };
  std::int32_t unknowns_ = 0;
  std::vector<Body> bodies_;
  std::vector<std::array<std::uint32_t, 2>> pairs_;
  std::vector<Point> points_;
  std::vector<Slopes> slopes_;  // derivatives of each point
  std::vector<Product> products_;
  // For each node of the scene: the node itself, or the origin and the rotation of the body that carries the
  // node.
  std::vector<std::vector<Target>> targets_;
};

}  // namespace netloft
