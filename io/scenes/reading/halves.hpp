// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/loaded_scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::scenes {

/// Half a gear that has crossed its plane of symmetry, y = 0, or a pair of bodies of a whole gear that have
/// crossed each other. Nothing in the mechanics prevents such a crossing.
struct Crossing {
  std::uint32_t part = 0;  // of half a gear: the part farthest beyond the plane; of a pair: one body
  bool is_held = false;    // of half a gear: whether a node beyond the plane is held along y
  std::string sentence;
};

/// The crossings at `positions`, 3 per node of the scene [m]: at most one for half a gear, at most one per
/// pair for a whole gear. Nodes of half a gear that are beyond the plane only by round-off do not count.
std::vector<Crossing> find_crossings(const LoadedScene& loaded, std::span<const double> positions);

}  // namespace netloft::scenes
