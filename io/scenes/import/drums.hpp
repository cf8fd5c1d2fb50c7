// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/femnet_gear.hpp"

#include <optional>

namespace netloft::scenes::femnet {

/// A bar that a drum shortens or lengthens. `shares`: its unstretched length as a fraction of the initial
/// length, linear between the times.
struct HauledBar {
  std::size_t bar = 0;     // index in the mesh file
  std::size_t number = 0;  // its position along the cable, from 0
  std::vector<double> times, shares;
};

/// Computes how FEMNET's drums change the lengths of bars in each time step of its motion:
///   r = s(t) Δt                                                                              (1)
/// r > 0 shortens the first bar, counted from the drum, that is longer than `shortest`, down to `shortest`,
/// and the rest of r shortens the next bar. −r > 0 lengthens the first bar, counted from the other end, that
/// is shorter than `longest`, up to `longest`, and the rest lengthens the next. Curves are thinned out as
/// long as they stay within `kHauledWithin` of these lengths. Returns nothing if there are more than
/// `kMostHauls` lengths to compute.
std::optional<std::vector<HauledBar>> haul(const GearFile& gear, const MeshFile& file);

inline constexpr double kMostHauls = 2e7;  // steps times bars: about a second of work
/// Tolerance of the lengths [m]: a tenth of the change of length in one time step of FEMNET of a rope that is
/// hauled at 0.2 m/s.
inline constexpr double kHauledWithin = 1e-4;

}  // namespace netloft::scenes::femnet
