// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cassert>
#include <compare>
#include <cstdint>
#include <vector>

namespace netloft {

/// The index of a degree of freedom in vectors over all degrees of freedom, in which the unknowns come first.
/// This index is neither the number of a node nor 3 node + axis.
struct Dof {
  std::int32_t place = 0;

  constexpr Dof() = default;
  explicit constexpr Dof(std::int32_t number) : place(number) {}
  explicit constexpr Dof(std::size_t number) : place(static_cast<std::int32_t>(number)) {}
  std::size_t at() const { return static_cast<std::size_t>(place); }
  friend constexpr auto operator<=>(Dof, Dof) = default;
};

/// Numbers the degrees of freedom: first the unknowns, in the order of the nodes, then the held degrees of
/// freedom. A vector over all degrees of freedom may hold positions, or the residuals of the unknowns
/// followed by the reactions.
class Numbering {
 public:
  explicit Numbering(const Scene& scene) : place_(3 * scene.node_count()) {
    std::int32_t next = 0;
    for (const bool held : {false, true}) {
      if (held) unknowns_ = next;
      for (std::size_t d = 0; d < place_.size(); ++d)
        if (static_cast<bool>(scene.held[d / 3] & (1 << (d % 3))) == held) {
          place_[d] = next++;
          coordinate_.push_back(static_cast<std::uint32_t>(d));
        }
    }
  }

  std::int32_t unknowns() const { return unknowns_; }
  std::size_t dofs() const { return place_.size(); }
  Dof dof(std::uint32_t node, int axis) const {
    assert(axis >= 0 && axis < 3 && 3 * std::size_t{node} < place_.size());
    return Dof(place_[3 * std::size_t{node} + static_cast<std::size_t>(axis)]);
  }
  bool is_unknown(Dof dof) const { return dof.place < unknowns_; }
  std::uint32_t node(Dof dof) const { return coordinate(dof) / 3; }
  int axis(Dof dof) const { return static_cast<int>(coordinate(dof) % 3); }

 private:
  std::uint32_t coordinate(Dof dof) const {
    assert(dof.at() < coordinate_.size());
    return coordinate_[dof.at()];
  }

  std::vector<std::int32_t> place_;        // index of each coordinate 3 node + axis
  std::vector<std::uint32_t> coordinate_;  // coordinate 3 node + axis at each index
  std::int32_t unknowns_ = 0;
};

}  // namespace netloft
