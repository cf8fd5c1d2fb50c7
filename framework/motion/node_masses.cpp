// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/node_masses.hpp"

#include <Eigen/Dense>

namespace netloft {

using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 6, 6>;

NodeMasses::NodeMasses(Assembler& assembler) : assembler_(assembler) {
  const Numbering& numbering = assembler.numbering();
  const auto& bodies = assembler.body_nodes();
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const std::size_t place : {0u, 1u}) of_bodies_[bodies[b][place]] = {b, place};
  node_of_body_.assign(bodies.size(), Node::kNone);
  for (std::int32_t i = 0; i < numbering.unknowns(); ++i) {
    std::size_t place = 0;
    Node& n = node_of(numbering.node(Dof(i)), place);
    n.unknown[n.count] = static_cast<std::size_t>(i);
    n.axis[n.count++] = 3 * place + static_cast<std::size_t>(numbering.axis(Dof(i)));
  }
  blocks_.resize(assembler.mass_numbers());
}

/// Returns the entry of a node; creates it if necessary. Both nodes of a body share one entry.
NodeMasses::Node& NodeMasses::node_of(std::uint32_t node, std::size_t& place) {
  const auto found = of_bodies_.find(node);
  if (found == of_bodies_.end()) {
    const bool is_new = nodes_.empty() || nodes_.back().body != Node::kNone || nodes_.back().nodes[0] != node;
    return is_new ? nodes_.emplace_back(Node{.nodes = {node, node}}) : nodes_.back();
  }
  place = found->second.second;
  const std::size_t body = found->second.first;
  std::size_t& index = node_of_body_[body];
  if (index == Node::kNone) {
    index = nodes_.size();
    nodes_.push_back({.nodes = assembler_.body_nodes()[body], .body = body});
  }
  return nodes_[index];
}

double NodeMasses::entry(const Node& n, std::size_t r, std::size_t c) const {
  const std::size_t row = n.axis[r], column = n.axis[c];
  if (row / 3 == column / 3) return blocks_[9 * std::size_t{n.nodes[row / 3]} + 3 * (row % 3) + column % 3];
  const std::size_t between = blocks_.size() - 9 * (node_of_body_.size() - n.body);
  return blocks_[between + 3 * std::min(row, column) + std::max(row, column) - 3];
}

bool NodeMasses::update(std::span<const double> x) {
  if (!assembler_.masses(x, blocks_, coupled_)) return false;
  for (Node& n : nodes_) invert(n);
  return true;
}

void NodeMasses::invert(Node& n) const {
  const auto size = static_cast<Eigen::Index>(n.count);
  Block M(size, size);
  for (std::size_t r = 0; r < n.count; ++r)
    for (std::size_t c = 0; c < n.count; ++c)
      M(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = entry(n, r, c);
  const Eigen::LLT<Block> factor(M);
  n.has_mass = factor.info() == Eigen::Success && M.trace() > 0;
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> inverse(n.inverse.data(),
                                                                                             size, size);
  if (n.has_mass)
    inverse = factor.solve(Block::Identity(size, size));
  else
    inverse.setZero();
}

bool NodeMasses::accelerate(std::span<const double> residual, std::span<double> a, bool massless_rest) {
  if (!massless_rest && !massless_nodes().empty()) return false;
  divide(residual, a);
  for (double& v : a) v = -v;
  return true;
}

void NodeMasses::divide(std::span<const double> x, std::span<double> y) const {
  for (const Node& n : nodes_) {
    std::array<double, 6> sum{};
    for (std::size_t r = 0; r < n.count; ++r)
      for (std::size_t c = 0; c < n.count; ++c) sum[r] += n.inverse[r * n.count + c] * x[n.unknown[c]];
    for (std::size_t r = 0; r < n.count; ++r) y[n.unknown[r]] = sum[r];
  }
}

void NodeMasses::multiply(std::span<const double> x, std::span<double> y) const {
  for (const Node& n : nodes_) {
    std::array<double, 6> sum{};
    for (std::size_t r = 0; r < n.count; ++r)
      for (std::size_t c = 0; c < n.count; ++c) sum[r] += entry(n, r, c) * x[n.unknown[c]];
    for (std::size_t r = 0; r < n.count; ++r) y[n.unknown[r]] = sum[r];
  }
}

std::vector<double> NodeMasses::diagonal() const {
  std::vector<double> all(static_cast<std::size_t>(assembler_.numbering().unknowns()));
  for (const Node& n : nodes_)
    for (std::size_t r = 0; r < n.count; ++r) all[n.unknown[r]] = entry(n, r, r);
  return all;
}

std::vector<std::uint32_t> NodeMasses::massless_nodes() const {
  std::vector<std::uint32_t> all;
  for (const Node& n : nodes_)
    if (!n.has_mass) all.push_back(n.nodes[0]);
  return all;
}

}  // namespace netloft
