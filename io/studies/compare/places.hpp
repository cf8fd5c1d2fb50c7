// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/loaded_scene.hpp"

#include <array>
#include <compare>
#include <map>
#include <span>

namespace netloft::studies {

/// A place on a gear that does not depend on the mesh: a part, and fractions of its width and its length.
struct Spot {
  std::uint32_t part;
  std::array<std::int64_t, 2> fraction;  // fractions in units of 1e-9
  auto operator<=>(const Spot&) const = default;
};

/// The positions of the nodes of one mesh of a gear [m], by spot. Nodes of different meshes correspond if
/// they have the same spot.
using Places = std::map<Spot, std::array<double, 3>>;

/// The spots of the nodes of a scene; `positions` has all node positions, 3 per node [m].
Places places_of(const scenes::LoadedScene& loaded, std::span<const double> positions);

/// Largest distance between `a` and `b` over the spots that both have [m]; NaN if there are none.
double largest_distance(const Places& a, const Places& b);

/// The root mean square distance between `a` and `b` [m], over the spots that `a`, `b` and `among` have.
double mean_distance(const Places& a, const Places& b, const Places& among);

/// The extrapolation a + w (a − b) at the spots that `a`, `b` and `among` have.
Places extrapolate(const Places& a, const Places& b, double w, const Places& among);

}  // namespace netloft::studies
