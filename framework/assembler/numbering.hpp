// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace netloft {

/// Numbers the degrees of freedom: unknowns first, in the order of the nodes, then the held ones. A vector
/// over all of them holds positions, or residual and reactions together.
class Numbering {
 public:
  explicit Numbering(const Scene& scene) : index_(3 * scene.node_count()) {
    std::int32_t next = 0;
    for (const bool held : {false, true}) {
      if (held) unknowns_ = next;
      for (std::size_t d = 0; d < index_.size(); ++d)
        if (static_cast<bool>(scene.held[d / 3] & (1 << (d % 3))) == held) {
          index_[d] = next++;
          dof_.push_back(static_cast<std::uint32_t>(d));
        }
    }
  }

  std::int32_t unknowns() const { return unknowns_; }
  std::size_t dofs() const { return index_.size(); }
  /// Index of axis `axis` of `node` in vectors over all degrees of freedom.
  std::int32_t index(std::uint32_t node, int axis) const {
    return index_[3 * std::size_t{node} + static_cast<std::size_t>(axis)];
  }
  bool is_unknown(std::int32_t index) const { return index < unknowns_; }
  std::uint32_t node(std::int32_t index) const { return dof_[static_cast<std::size_t>(index)] / 3; }
  int axis(std::int32_t index) const { return static_cast<int>(dof_[static_cast<std::size_t>(index)] % 3); }

 private:
  std::vector<std::int32_t> index_;  // dof (3 node + axis) -> index
  std::vector<std::uint32_t> dof_;   // index -> dof
  std::int32_t unknowns_ = 0;
};

}  // namespace netloft
