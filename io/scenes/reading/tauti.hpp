// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

namespace netloft::scenes {

/// A model of a gear in a tank, scaled by the rule of M. Tauti, "A relation between experiments on model and
/// on full scale of fishing net", Nippon Suisan Gakkaishi 3 (1934): lengths are divided by λ, but bars and
/// twines of the netting only by λ' ≤ λ, so that the model has fewer and larger meshes. With the same water
/// and the same materials, velocities V and forces F of the full scale (index F) and of the model (index M)
/// have the ratios
///   V_F/V_M = √λ',   F_F/F_M = λ² λ'                                                       (1)
/// The weight of ropes and the lift of floats have the ratio of forces in (1) if the diameters D of ropes and
/// d of floats have the ratios
///   D_F/D_M = √(λ λ'),   d_F/d_M = (λ² λ')^⅓                                               (2)
/// The drag of ropes and floats, which is proportional to D L V² and d² V² (L is the length of a rope), then
/// has another ratio. A scene has the size of the gear. Scaled up to this size, the model has ropes that are
/// √(λ/λ') thicker than those of the gear, with a density nearer to that of water, and floats that are
/// (λ/λ')^⅓ wider. Reynolds numbers are those of the model. In numbers of the full-scale gear, with the
/// viscosity ν of the tank, they are
///   netting V d/ν λ'^−1.5,   ropes and floats V (λ D_M)/ν λ⁻¹ λ'^−0.5                      (3)
struct TautiModel {
  double lengths = 1, twines = 1;  // ratios λ, λ' of (1)

  /// The viscosity with which full-scale netting has the Reynolds number (3), divided by the viscosity ν in
  /// the tank.
  double viscosity_of_netting() const;
  /// Replaces the ropes and floats of a scene by those of the model, scaled up to the size of the gear. The
  /// viscosity of the water in the scene must already include the factor viscosity_of_netting().
  void scale_ropes_and_floats(Scene& scene) const;
};

/// A part with elements that may be partly above water, where (1) does not hold; nullptr if there is none.
const Part* find_part_above_water(const Scene& scene);

}  // namespace netloft::scenes
