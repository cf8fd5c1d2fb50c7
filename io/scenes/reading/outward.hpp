// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace netloft::scenes {

/// A panel that a rider stands on: the index in the rider's nodes at which its corners begin, and whether its
/// corners are known to be counter-clockwise seen from outside, as those of a net plan are.
struct PanelBelow {
  std::size_t begin = 0;
  bool is_outward = false;
};

/// The values of datum::kOutward, and the number of panels for which they could not be found.
struct Outward {
  std::vector<double> of_triangles;
  std::size_t unknown = 0;
};

/// Finds for each triangle of `rider` whether its corners are counter-clockwise seen from outside, however
/// its panel was drawn. The inside is the side of a panel on which the centre of all triangles lies. If a
/// panel's plane contains this centre, its inside is unknown and its corners are taken as they are.
/// `positions`: those of the scene [m].
Outward find_outward(const std::vector<PanelBelow>& panels, const std::vector<double>& positions,
                     const Part& rider);

}  // namespace netloft::scenes
