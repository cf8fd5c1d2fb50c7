// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <algorithm>
#include <numbers>

namespace netloft::axial {

/// Damping by the material of a taut twine or rope of the length l (Kelvin and Voigt):
///   T_d = c dl/dt,  c = (EA/l₀) η/(2π f₀) s(ε/ε₁),  ε = l/l₀ − 1                           (1)
///   s(y) = y² (3 − 2y) between 0 and 1, constant beyond                                    (2)
/// η [1] is the loss factor: the fraction of its energy that a taut rope loses per radian when it oscillates
/// at the frequency f₀ [Hz]. Its amplitude falls by the factor exp(−π η) per period. At other frequencies f
/// the loss factor of (1) is η f/f₀, whereas that of fibres and wires is nearly constant; f₀ should be in the
/// middle of the frequencies that matter. A slack rope has no damping. Source: Kelvin and Voigt's solid, as
/// in Clough and Penzien, Dynamics of Structures. The gradual onset over the strain ε₁ is not in the source:
/// if the force jumped, some states would have no equilibrium. ε₁ is small compared with the strains of a
/// rope in use, 1e-3 and more, but large enough for an implicit step to resolve the onset.
inline constexpr double kFullLossStrain = 1e-4;

/// Computes η EA/(2π f₀) of one bar [N s], which is l₀ times the greatest c of (1).
inline double loss_of(double EA, double loss_factor, double loss_frequency) {
  return EA * loss_factor / (2 * std::numbers::pi * loss_frequency);
}

/// The damping coefficient c of (1) and its slope dc/dl. `loss` is the result of loss_of [N s].
struct Damper {
  double c, slope;  // [N s/m], [N s/m²]
};
inline Damper damper(double loss, double l, double l0) {
  const double y = std::clamp((l / l0 - 1) / kFullLossStrain, 0.0, 1.0);
  return {loss / l0 * y * y * (3 - 2 * y), loss / l0 * 6 * y * (1 - y) / (kFullLossStrain * l0)};  // (2)
}

}  // namespace netloft::axial
