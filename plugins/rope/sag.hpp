// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/rope/bar.hpp"

#include <numbers>

namespace netloft::rope {

/// A rope deforms within a bar: it sags across the chord and stretches unevenly along it. This lowers its
/// energy by an amount that straight bars with lumped weights neglect. To leading order, it is
///   E = −w² l₀² l cos²φ / (24 T̃) − w² l₀³ sin²φ / (24 EA),  T̃ = √(T² + (w l₀)²)               (1)
/// w [N/m] weight in water of the unstretched rope, l₀, l [m] unstretched and current length of the bar, φ
/// the angle of the chord to the horizontal, T the tension of the straight bar by axial.hpp (2); with T̃
/// instead of T, (1) stays finite for a slack rope. With (1), the error of a hanging rope is of order h⁴ in
/// the length h of a bar, instead of h². Do not use (1) if drag bends the rope as much as weight does: it
/// does not include drag. Source: the energy of a taut string under the transverse load q, −q² l³/(24 T)
/// (Irvine, Cable Structures, MIT Press 1981, ch. 2).
struct Sag {
  template <class T>
  static T energy(const Bar::Parameters& p, const Bar::Data& d, const Water& water, const Points<T, 2>& x) {
    const double area = std::numbers::pi / 4 * p.diameter * p.diameter, l0 = d.rest_length;
    const double density =
        Bar::density_by_weight(p.weight_in_water, p.density, p.diameter, water.density, water.gravity);
    const double w = area * (density - water.density) * water.gravity;
    const Vec3<T> chord = x[1] - x[0];
    const T flat = chord.x * chord.x + chord.y * chord.y, square = flat + chord.z * chord.z;
    if (!(square > T(axial::kCollapsed * axial::kCollapsed * l0 * l0))) return T(0);
    const T l = sqrt(square);
    const T elongation = l - l0;
    const T tension = ((elongation >= T(0) ? p.EA : p.EA_compression) / l0) * elongation;
    const T taut = sqrt(tension * tension + (w * l0) * (w * l0));
    const T along = p.EA > 0 ? T(l0 / p.EA) * chord.z * chord.z / square : T(0);
    if (w == 0) return T(0);
    return (-p.sag * w * w * l0 * l0 / 24) * (l * flat / square / taut + along);
  }
};

}  // namespace netloft::rope
