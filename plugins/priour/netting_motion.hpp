// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/twines.hpp"

namespace netloft::priour {

/// Damping of stretch: a tension T_d proportional to the strain rate, in the twines of both directions.
///   U′ = Σ a_p v_p,  T_d = (η/l₀) Û·U′,  r_p = n a_p T_d Û                                           (1)
///   ∂(T_d Û)/∂U = (η/l₀)/‖U‖ [Û (U′ − (Û·U′) Û)ᵀ + (Û·U′)(I − ÛÛᵀ)],  ∂(T_d Û)/∂U′ = (η/l₀) ÛÛᵀ      (2)
/// U, a, d are those of triangle.hpp, v_p [m/s] is the velocity of corner p, n = |d|/2 the number of bars;
/// for the other direction, V and b replace U and a. η [N s] is EA times a relaxation time, as for ropes.
struct Damping {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

/// Damping by the material of taut twines. The coefficient c of loss.hpp (1) replaces η/l₀ in (1) and (2),
/// and (2) has the additional term
///   (dc/d‖U‖) (Û·U′) ÛÛᵀ                                                                          (7)
struct Loss {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

/// Mass of the twines, and added mass for acceleration across them, a third at every corner. The sum is over
/// the twine directions t = Û, V̂:
///   r_p = ⅓ M Σ_t [(ρ + C_a ρ_w) a_p − C_a ρ_w (t·a_p) t],  M = n (π/4) D² l₀                        (3)
///   ∂r_p/∂a_p = ⅓ M Σ_t [(ρ + C_a ρ_w) I − C_a ρ_w t tᵀ]                                             (4)
///   ∂r_p/∂U = −⅓ M C_a ρ_w [Û (a_p − (Û·a_p) Û)ᵀ + (Û·a_p)(I − ÛÛᵀ)]/‖U‖                             (5)
/// a_p [m/s²] acceleration of corner p, n bars of each direction, D [m] diameter, l₀ [m] bar, ρ [kg/m³]
/// density of the twines, ρ_w of the water, C_a [1] added over displaced mass. Source: the trawl-gear paper,
/// section 2.3; Morison et al. 1950.
struct Inertia {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

/// The force that the acceleration u′ [m/s²] of the water exerts. It is the inertia (3) of twines made of
/// water, with the opposite sign:
///   r_p = −⅓ M Σ_t [ρ_w (1 + C_a) u′_p − C_a ρ_w (t·u′_p) t]                                         (6)
struct Waves {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

}  // namespace netloft::priour
