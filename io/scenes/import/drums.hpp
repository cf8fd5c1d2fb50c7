// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/femnet_gear.hpp"

#include <optional>

namespace netloft::scenes::femnet {

/// A bar that a drum shortens or lengthens. `shares` are its unstretched lengths at `times`, as fractions of
/// the initial length; the length is linear between these times.
struct HauledBar {
  std::size_t bar = 0;     // index in the mesh file
  std::size_t number = 0;  // position of the bar along the cable, from 0
  std::vector<double> times, shares;
};

/// Computes how FEMNET's drums change the lengths of bars in each time step of its motion:
///   r = s(t) Δt                                                                              (1)
/// with s(t) the hauling speed of the drum. If r > 0, the drum hauls r in: it shortens one bar after another,
/// beginning at the drum, each down to `Drum::shortest`, until r is used up. If r < 0, it pays out |r|: it
/// lengthens one bar after another, beginning at the far end, each up to `Drum::longest`. Samples of length
/// against time are dropped as long as straight lines between the remaining samples stay within
/// `kHauledWithin` of them. Returns nullopt if there are more than `kMostHauls` lengths to compute.
std::optional<std::vector<HauledBar>> haul(const GearFile& gear, const MeshFile& file);

inline constexpr double kMostHauls = 2e7;  // limit of time steps times bars; this many take about a second
/// Tolerance of the lengths [m]: at a hauling speed of 0.2 m/s, a tenth of the length that a drum hauls in
/// one time step of FEMNET.
inline constexpr double kHauledWithin = 1e-4;

}  // namespace netloft::scenes::femnet
