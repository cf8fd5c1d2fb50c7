// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <vector>

namespace netloft::results {

/// A ship that tows the gear.
struct TowingShip {
  std::array<double, 3> stern{};  // middle between its blocks, at their height over the water [m]
  double beam = 0;                // [m]
};

/// The ships of a result that has one in its plan: one, or the two of a pair trawl.
std::vector<TowingShip> ships_of(const StoredShape& stored, std::size_t state);

/// A hull and a house as triangles, three corners each [m]. A sign for a ship: a plan has its blocks alone.
std::vector<std::array<double, 3>> triangles_of(const TowingShip& ship);

}  // namespace netloft::results
