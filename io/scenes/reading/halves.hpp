// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/loaded_scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::scenes {

/// A part on the wrong side of the plane of symmetry, y = 0. Nothing in the mechanics keeps half a gear, or a
/// body of a pair, from passing through its mirror image.
struct Crossing {
  std::uint32_t part = 0;  // in Scene::parts, the part that is farthest beyond the plane
  bool is_held = false;    // whether a node beyond the plane is held along y
  std::string sentence;
};

/// The crossings at `positions`, 3 per node of the scene [m]. Half a gear has at most one crossing; a whole
/// gear may have one for each pair of bodies. Nodes of half a gear that are beyond the plane only by
/// round-off do not count.
std::vector<Crossing> find_crossings(const LoadedScene& loaded, std::span<const double> positions);

}  // namespace netloft::scenes
