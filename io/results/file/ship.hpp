// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <vector>

namespace netloft::results {

/// A ship that tows the gear.
struct TowingShip {
  std::array<double, 3> stern{};  // midpoint between the ship's blocks, at their height above the water [m]
  double beam = 0;                // [m]
};

/// The ships of a result: one, two for a pair trawl, none if the net plan has no ship.
std::vector<TowingShip> ships_of(const StoredShape& stored, std::size_t state);

/// Triangles of a hull and a house, three corners each [m]. The triangles are only a symbol, because a net
/// plan says only where the blocks of a ship are.
std::vector<std::array<double, 3>> triangles_of(const TowingShip& ship);

}  // namespace netloft::results
