// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <optional>

namespace netloft {

/// The mass matrix where it couples no nodes: a block of up to 3 x 3 per node, added mass included, inverted
/// block by block.
class NodeMasses {
 public:
  explicit NodeMasses(Assembler& assembler);

  /// Masses at positions x over all dofs. False: see the assembler's fault().
  bool update(std::span<const double> x);
  /// a = −M⁻¹ r over the unknowns. A node without mass gets none, if `massless_rest`; else false.
  bool accelerate(std::span<const double> residual, std::span<double> a, bool massless_rest);
  /// y = M⁻¹ x, and y = M x, over the unknowns.
  void divide(std::span<const double> x, std::span<double> y) const;
  void multiply(std::span<const double> x, std::span<double> y) const;

  /// The diagonal of M, over the unknowns [kg].
  std::vector<double> diagonal() const;
  /// Whether masses couple nodes: then no block is the truth.
  bool coupled() const { return coupled_ > 0; }
  /// A node with an unknown and no mass.
  std::optional<std::uint32_t> massless_node() const;

 private:
  /// Unknowns of one node: `count` of them from `first` on, along the node's axes `axes`.
  struct Node {
    std::uint32_t node;
    std::size_t first, count;
    std::array<std::size_t, 3> axes;
    std::array<double, 9> inverse;  // count x count, row by row
    bool has_mass;
  };
  void invert(Node& n) const;
  double entry(const Node& n, std::size_t r, std::size_t c) const {
    return blocks_[9 * std::size_t{n.node} + 3 * n.axes[r] + n.axes[c]];
  }

  Assembler& assembler_;
  std::vector<Node> nodes_;
  std::vector<double> blocks_;
  double coupled_ = 0;
};

/// Highest angular frequency of M⁻¹ K [rad/s], from above but for rounding: the largest Ritz value of a few
/// Lanczos steps in the inner product of M, and its residual (Lanczos 1950; Parlett, The Symmetric Eigenvalue
/// Problem, 1980, chapter 13). `stiffness` is y = K x.
double highest_frequency(const NodeMasses& masses, std::size_t unknowns,
                         const std::function<void(std::span<const double>, std::span<double>)>& stiffness);

}  // namespace netloft
