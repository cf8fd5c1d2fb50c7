// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

namespace netloft::scenes {

/// A model of a gear in a tank by the rule of M. Tauti, "A relation between experiments on model and on full
/// scale of fishing net", Nippon Suisan Gakkaishi 3 (1934): lengths are divided by λ, bars and twines of the
/// netting by λ' ≤ λ, so that there are fewer and larger meshes than similar ones. In water and of materials
/// that are the same,
///   V_F/V_M = √λ',   F_F/F_M = λ² λ'                                                       (1)
/// for velocities and forces. Ropes weigh, and floats lift, as (1) asks of them,
///   D_F/D_M = √(λ λ'),   d_F/d_M = (λ² λ')^⅓                                               (2)
/// so that their drag, ∝ D L V² and d² V², is not similar. In lengths of the gear such a rope is √(λ/λ')
/// thicker than that of the gear and nearer to the density of water, and such a float (λ/λ')^⅓ wider.
/// Reynolds numbers are those of the model:
///   netting V d/ν λ'^−1.5,   ropes and floats V (λ D_M)/ν λ⁻¹ λ'^−0.5                      (3)
struct TautiModel {
  double lengths = 1, twines = 1;  // λ, λ'

  /// Ratio of the viscosity at which full-size netting has the Reynolds number (3) to that of the tank.
  double viscosity_of_netting() const;
  /// Makes the ropes and floats of a scene, whose water has the viscosity above, those of the model, in
  /// lengths of the gear.
  void scale_ropes_and_floats(Scene& scene) const;
};

/// A part that may be partly dry, where (1) does not hold; null without.
const Part* find_part_above_water(const Scene& scene);

}  // namespace netloft::scenes
