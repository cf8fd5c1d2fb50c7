// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

namespace netloft::scenes {

/// A model of a gear in a tank by the rule of M. Tauti, "A relation between experiments on model and on full
/// scale of fishing net", Nippon Suisan Gakkaishi 3 (1934): lengths are divided by λ, bars and twines of the
/// netting by λ' ≤ λ, so that there are fewer and larger meshes than similar ones. With the same water and
/// the same materials, velocities V and forces F scale by
///   V_F/V_M = √λ',   F_F/F_M = λ² λ'                                                       (1)
/// The weight of ropes and the lift of floats scale by (1) if the diameters D of ropes and d of floats scale
/// by
///   D_F/D_M = √(λ λ'),   d_F/d_M = (λ² λ')^⅓                                               (2)
/// Their drag, ∝ D L V² and d² V², is then not similar. Scaled up to the size of the gear, such a rope is
/// √(λ/λ') thicker than the rope of the gear, with a density nearer to that of water, and such a float is
/// (λ/λ')^⅓ wider. Reynolds numbers are those of the model:
///   netting V d/ν λ'^−1.5,   ropes and floats V (λ D_M)/ν λ⁻¹ λ'^−0.5                      (3)
struct TautiModel {
  double lengths = 1, twines = 1;  // λ, λ'

  /// The viscosity at which full-size netting has the Reynolds number (3), divided by that of the tank.
  double viscosity_of_netting() const;
  /// Replaces the ropes and floats of a scene by those of the model, scaled up to the size of the gear. The
  /// water of the scene must have the viscosity above.
  void scale_ropes_and_floats(Scene& scene) const;
};

/// A part that may be partly above water, where (1) does not hold; null if there is none.
const Part* find_part_above_water(const Scene& scene);

}  // namespace netloft::scenes
