// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <algorithm>
#include <numbers>

namespace netloft::axial {

/// Damping by the material of a twine or rope, in tension alone (Kelvin and Voigt):
///   T_d = c dl/dt,  c = (EA/l₀) η/(2π f₀) s(ε/ε₁),  ε = l/l₀ − 1                           (1)
///   s(y) = y² (3 − 2y) between 0 and 1, constant beyond                                    (2)
/// η [1] loss factor: what a taut stretch that swings with the frequency f₀ [Hz] loses of its energy in a
/// radian, so that its amplitude falls by the factor exp(−π η) from one swing to the next. At other
/// frequencies f the loss is η f/f₀, where fibres and wires keep nearly to η: f₀ is the middle of the band
/// that is meant. A slack rope resists nothing. Source: Kelvin and Voigt's solid, as in Clough and Penzien,
/// Dynamics of Structures; that damping sets in over ε₁ and not at once is ours: a step of the force has no
/// balance on it.
///
/// ε₁ is a strain that makes no difference to the swings of a rope in use, at strains of 1e-3 and more, and
/// over which an implicit step can still see the force rise.
inline constexpr double kFullLossStrain = 1e-4;

/// (η/(2π f₀)) EA of one bar [N s].
inline double loss_of(double EA, double loss_factor, double loss_frequency) {
  return EA * loss_factor / (2 * std::numbers::pi * loss_frequency);
}

/// c of (1) and dc/dl, for `loss` of loss_of [N s].
struct Damper {
  double c, slope;  // [N s/m], [N s/m²]
};
inline Damper damper(double loss, double l, double l0) {
  const double y = std::clamp((l / l0 - 1) / kFullLossStrain, 0.0, 1.0);
  return {loss / l0 * y * y * (3 - 2 * y), loss / l0 * 6 * y * (1 - y) / (kFullLossStrain * l0)};  // (2)
}

}  // namespace netloft::axial
