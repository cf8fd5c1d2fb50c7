// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <map>
#include <optional>

namespace netloft {

/// The mass matrix, including added mass, without coupling between nodes: a block of up to 3 x 3 per node, or
/// 6 x 6 per rigid body. Each block is inverted separately.
class NodeMasses {
 public:
  explicit NodeMasses(Assembler& assembler);

  /// Evaluates the masses at positions x over all dofs. Returns false if that fails, see Assembler::fault.
  bool update(std::span<const double> x);
  /// Computes a = −M⁻¹ r over the unknowns. If `massless_rest`, nodes without mass get no acceleration;
  /// otherwise the result is false if a node has no mass.
  bool accelerate(std::span<const double> residual, std::span<double> a, bool massless_rest);
  /// y = M⁻¹ x over the unknowns.
  void divide(std::span<const double> x, std::span<double> y) const;
  /// y = M x over the unknowns.
  void multiply(std::span<const double> x, std::span<double> y) const;

  /// The diagonal of M, over the unknowns [kg].
  std::vector<double> diagonal() const;
  /// Whether masses couple nodes, so that the blocks are incomplete.
  bool coupled() const { return coupled_ > 0; }
  /// Nodes with unknowns and no mass, and origins of bodies without inertia.
  std::vector<std::uint32_t> massless_nodes() const;

 private:
  /// The unknowns of one node, or of the origin and the rotation of one body.
  struct Node {
    static constexpr std::size_t kNone = ~std::size_t{0};
    std::array<std::uint32_t, 2> nodes;  // origin and rotation of a body; otherwise the node, twice
    std::size_t body = kNone;
    std::size_t count = 0;
    std::array<std::size_t, 6> unknown{};
    std::array<std::size_t, 6> axis{};    // axis of each unknown; 3 to 5 are axes of the second node
    std::array<double, 36> inverse = {};  // count x count, row by row
    bool has_mass = false;
  };
  Node& node_of(std::uint32_t node, std::size_t& place);
  void invert(Node& n) const;
  double entry(const Node& n, std::size_t r, std::size_t c) const;

  Assembler& assembler_;
  std::vector<Node> nodes_;
  // For each node of a body: the body, and the index of the node in Node::nodes.
  std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> of_bodies_;
  std::vector<std::size_t> node_of_body_;  // index in nodes_ of each body
  std::vector<double> blocks_;
  double coupled_ = 0;
};

}  // namespace netloft
