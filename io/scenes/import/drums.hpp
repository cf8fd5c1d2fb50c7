// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/femnet_gear.hpp"

#include <optional>

namespace netloft::scenes::femnet {

/// A bar that a drum shortens or lengthens: its unstretched length over that at the start, straight between
/// the times.
struct HauledBar {
  std::size_t bar = 0;     // of the mesh file
  std::size_t number = 0;  // along its cable, from 0
  std::vector<double> times, shares;
};

/// How FEMNET's drums change the lengths of bars, step by step of its motion:
///   r = s(t) Δt                                                                              (1)
/// r > 0 is taken off the first bar of the cable from the drum on that is longer than `shortest`, which it
/// remains, and what is left of r off the next; −r > 0 is added to the first bar from the other end that is
/// shorter than `longest`, and what exceeds that to the next. Curves have as few times as keep them within
/// `kHauledWithin` of these lengths. Nothing if there are more than `kMostHauls` lengths to go through.
std::optional<std::vector<HauledBar>> haul(const GearFile& gear, const MeshFile& file);

inline constexpr double kMostHauls = 2e7;  // steps times bars: about a second of work
/// [m] a tenth of what a time step of FEMNET leaves in the length of a rope that is hauled at 0.2 m/s.
inline constexpr double kHauledWithin = 1e-4;

}  // namespace netloft::scenes::femnet
