// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/members.h>

namespace netloft {

/// Mean tension of a member of length l [m] and energy ψ(l) over a step from l₀ to l₁:
///   T̄ = (ψ(l₁) − ψ(l₀))/(l₁ − l₀)                                                               (1)
/// The tension is linear in l on either side of the rest length, below which the member is slack. J. C. Simo
/// and N. Tarnow, "The discrete energy-momentum method", ZAMP 43, 1992.
struct MeanTension {
  double T, slope;  // T̄ [N], and its derivative with respect to l₁ [N/m]
};
MeanTension mean_tension(const netloft_member& member, double before, double after);

/// Stiffness of a member over the same step:
///   k = (T(l₁) − T(l₀))/(l₁ − l₀)                                                               (2)
struct MeanStiffness {
  double k, slope;  // k [N/m], and its derivative with respect to l₁ [N/m²]
};
MeanStiffness mean_stiffness(const netloft_member& member, double before, double after);

/// Tension [N] and stiffness [N/m] of a member of length l, and whether the member is taut.
double tension_at(const netloft_member& member, double l);
double stiffness_at(const netloft_member& member, double l);
bool is_taut(const netloft_member& member, double l);

}  // namespace netloft
