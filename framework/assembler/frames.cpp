// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/frames.hpp"

#include <algorithm>

namespace netloft {

Frames::Frames(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric)
    : unknowns_(static_cast<std::size_t>(numbering.unknowns())) {
  if (scene.frames.empty()) return;
  std::vector<int> turned(scene.node_count(), -1);
  for (const auto& [node, Q] : scene.frames) {
    turned[node] = static_cast<int>(nodes_.size());
    Node n{{}, Q};
    for (int axis = 0; axis < 3; ++axis)
      n.place[static_cast<std::size_t>(axis)] = numbering.dof(node, axis).at();
    nodes_.push_back(n);
  }
  for (std::size_t column = 0; column + 1 < blocks.column_start.size(); ++column)
    for (std::size_t b = blocks.column_start[column]; b < blocks.column_start[column + 1]; ++b) {
      const std::size_t row = blocks.row_node[b];
      if (turned[row] >= 0 || turned[column] >= 0)
        blocks_.push_back({9 * b, turned[row], turned[column], symmetric && row == column});
    }
}

void Frames::place(std::span<const double> start, std::span<const double> u, std::span<double> x) const {
  for (const Node& n : nodes_)
    for (std::size_t i = 0; i < 3; ++i) {
      x[n.place[i]] = start[n.place[i]];
      for (std::size_t k = 0; k < 3; ++k)
        if (n.place[k] < unknowns_) x[n.place[i]] += n.Q[3 * i + k] * u[n.place[k]];
    }
}

void Frames::turn_back(std::span<const double> own, std::span<double> world) const {
  for (const Node& n : nodes_)
    for (std::size_t i = 0; i < 3; ++i) {
      world[n.place[i]] = 0;
      for (std::size_t k = 0; k < 3; ++k)
        if (n.place[k] < unknowns_) world[n.place[i]] += n.Q[3 * i + k] * own[n.place[k]];
    }
}

void Frames::turn(double* residual) const {
  for (const Node& n : nodes_) {
    std::array<double, 3> own{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) own[k] += n.Q[3 * i + k] * residual[n.place[i]];
    for (std::size_t k = 0; k < 3; ++k) residual[n.place[k]] = own[k];
  }
}

void Frames::turn_matrix(double* values) const {
  for (const Block& block : blocks_) {
    double* K = values + block.base;
    if (block.lower_only) K[1] = K[3], K[2] = K[6], K[5] = K[7];
    Matrix3 left{}, both{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        if (block.row < 0)
          left[3 * i + j] = K[3 * i + j];
        else
          for (std::size_t k = 0; k < 3; ++k)
            left[3 * i + j] += nodes_[static_cast<std::size_t>(block.row)].Q[3 * k + i] * K[3 * k + j];
      }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        if (block.column < 0)
          both[3 * i + j] = left[3 * i + j];
        else
          for (std::size_t k = 0; k < 3; ++k)
            both[3 * i + j] += left[3 * i + k] * nodes_[static_cast<std::size_t>(block.column)].Q[3 * k + j];
      }
    std::copy(both.begin(), both.end(), K);
  }
}

}  // namespace netloft
