// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/riders.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace netloft {

/// From `begin` up to `end`, which is none of them.
struct Range {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
  void include(std::size_t i) {
    begin = size() == 0 ? i : std::min(begin, i);
    end = std::max(end, i + 1);
  }
};

/// What one of several processes evaluates of a scene: all tiles with a node of a range. The sums at these
/// nodes are then complete, and added up in the order in which one process alone adds them, so they have the
/// same bits on any number of processes, and nothing is added when they are gathered. Tiles at the edge of a
/// range are evaluated by both neighbours.
struct Share {
  struct Tiles {
    std::vector<std::uint32_t> order;       // of one group, colour by colour
    std::vector<std::size_t> colour_begin;  // in `order`, +1
  };
  /// Places in vectors over all dofs: unknowns, and held ones behind all unknowns.
  using Places = std::array<Range, 2>;

  Range nodes;                           // whose sums are its own
  Places places;                         // of these nodes
  Range slots;                           // of the matrix values in the columns of these nodes
  Places needed;                         // of all nodes of its tiles
  std::vector<Tiles> groups;             // by group
  std::vector<Tiles> own;                // those of them whose energies are its own
  std::vector<std::uint32_t> own_tiles;  // the same, counted over all groups
};

/// Divides the nodes among `count` processes, in the order of their numbers, so that each evaluates about as
/// many entries of element matrices. `first_slot`: per node the first matrix value of its column, +1.
std::vector<Share> divide(std::span<const FamilyGroup> groups, const Numbering& numbering,
                          std::span<const std::size_t> first_slot, std::size_t count);

}  // namespace netloft
