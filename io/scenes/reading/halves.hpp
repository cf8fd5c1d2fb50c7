// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/loaded_scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::scenes {

/// A part on the wrong side of the plane of symmetry, y = 0. Nothing else keeps half a gear, or a body of a
/// pair, from passing through its mirror image.
struct Crossing {
  std::uint32_t part = 0;  // of Scene::parts, the one that is farthest beyond
  bool is_held = false;    // whether some of it is held there along y
  std::string sentence;
};

/// Crossings at `positions`, 3 per node of the scene [m]: of half a gear at most one, of a whole one those of
/// its pairs of bodies. Nodes of half a gear that lie beyond by round-off alone are none.
std::vector<Crossing> find_crossings(const LoadedScene& loaded, std::span<const double> positions);

}  // namespace netloft::scenes
