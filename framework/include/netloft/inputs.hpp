// SPDX-License-Identifier: BSD-3-Clause
//
// Extension data for terms that are written as `tile` (see element.hpp). Each function below returns nullptr
// if the scene has no such data, or if no term of the element has the trait given in its comment. Included by
// element.hpp.
#pragma once
#include <netloft/ext/ground.h>
#include <netloft/ext/memory.h>
#include <netloft/ext/waves.h>

#include <cstddef>

namespace netloft {

namespace detail {

/// Indices into netloft_tile.inputs, the same in every element that lists inputs.
enum InputPlace : std::size_t { kGroundPlace, kWavesPlace, kMemoryPlace, kInputPlaces };

template <class Input>
const Input* input(const netloft_tile& t, InputPlace place) {
  return t.inputs ? static_cast<const Input*>(t.inputs[place]) : nullptr;
}

}  // namespace detail

/// Velocity at which the ground passes a towed gear, 3 components [m/s]. Trait: reads_ground.
inline const double* ground_of(const netloft_tile& t) {
  const auto* ground = detail::input<netloft_ground>(t, detail::kGroundPlace);
  return ground ? ground->velocity : nullptr;
}
/// The bed below each node: height, two slopes and three second derivatives, [6 nodes][64], as in
/// netloft_ground. Trait: reads_bed.
inline const double* bed_of(const netloft_tile& t) {
  const auto* ground = detail::input<netloft_ground>(t, detail::kGroundPlace);
  return ground ? ground->bed : nullptr;
}
/// Acceleration of the water at the nodes, [dof][64] [m/s2]. Trait: reads_waves.
inline const double* water_acceleration_of(const netloft_tile& t) {
  const auto* waves = detail::input<netloft_waves>(t, detail::kWavesPlace);
  return waves ? waves->acceleration : nullptr;
}
/// Height of the surface of the water over the nodes, [nodes][64] [m]. Trait: reads_waves.
inline const double* surface_of(const netloft_tile& t) {
  const auto* waves = detail::input<netloft_waves>(t, detail::kWavesPlace);
  return waves ? waves->surface : nullptr;
}
/// The numbers that elements remember from the last accepted step, [width][64]. Trait: reads_state.
inline const double* state_of(const netloft_tile& t) {
  const auto* memory = detail::input<netloft_remembered>(t, detail::kMemoryPlace);
  return memory ? memory->state : nullptr;
}
/// The array [width][64] to which a term writes what its elements have to remember. The host keeps these
/// numbers only if the step is accepted; state_of() returns them from then on. Trait: reads_state.
inline double* new_state_of(const netloft_tile& t) {
  const auto* memory = detail::input<netloft_remembered>(t, detail::kMemoryPlace);
  return memory ? memory->state_new : nullptr;
}

}  // namespace netloft
