// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/rotation.hpp>

namespace netloft::boards {

/// The force of water on a flat rectangular plate of any aspect ratio, from any direction. w = (w_x, w_y,
/// w_z) is the unit vector of the flow, with x along the chord aft, y along the normal outward and z up the
/// span. The incidence α is the angle between the flow and the plane of the plate:
///   s = |w_y| = sin α,  c = √(w_x² + w_z²) = cos α
///   C_N = K_p s c + K_v s²                                              up to vortex breakdown           (1)
///   C_N = C_90 s + (C_N(α_s) − C_90 sin α_s) tan α_s / tan α            beyond it                        (2)
///   K_p = 2πA/(2 + √(A² + 4)),   K_v = 3.1,   C_90 = 1.11 + 0.018 A'                                     (3)
///   α_s = 38° (1 + A⁴)^−0.16                                            angle of breakdown               (4)
///   A → A^(cos 2χ),   tan χ = w_z/w_x                                                                    (5)
///   Δ = (½ − ξ₀) L K_p c/(K_p c + K_v s),   ξ₀ = ¼ A^1.25/(A^1.25 + 0.48)                                (6)
///   A = (1 + i) span/chord,   i falls by a cubic from 1 on the bed to 0 at a clearance of a span         (7)
/// A is the aspect ratio (7), which i increases near the bed; for a flow at the angle χ to the chord, (5)
/// replaces A. A cubic blends (1) into (2) over 16° about α_s. The normal force acts upstream of the middle
/// of the plate, at the distance Δ, where L = chord cos²χ + span sin²χ is the width of the plate in the
/// direction χ.
///
/// Sources: (1) E. C. Polhamus, NASA TN D-3767 (1966): leading-edge suction turned into normal force; K_v is
/// his value for low aspect ratios. (2) L. A. Viterna and R. D. Corrigan, DOE/NASA large wind turbine
/// workshop (1981), for a force along the normal; C_90 with A' = max(A, 1/A) is theirs, too. (3) K_p after H.
/// B. Helmbold, Jahrbuch der deutschen Luftfahrtforschung (1942): within 5 % of a vortex lattice for A = 0.4
/// to 3 (in a test). (4) fits the stall angles of square and wider plates (S. F. Hoerner and H. V. Borst,
/// Fluid-Dynamic Lift, 1985, chapter 17): 34° for A = 1, 24° for 2, 19° for 3, 38° for slender plates. (5): a
/// plate in a flow along its span acts as a plate of the reciprocal aspect ratio. (6): the part with K_p acts
/// at ξ₀, within 0.004 of the vortex lattice at small angles; the part with K_v acts in the middle. (7): on
/// the bed, a board and its mirror image form a board of twice the span; the clearance of one span, at which
/// the effect ends, is a choice. The error of C_N is about 20 % near the greatest lift.
template <class T>
struct PlateForce {
  T normal;       // coefficient C_N of the force along y, positive where w_y > 0
  T ahead_chord;  // point at which the force acts, aft of the middle along the chord [m]
  T ahead_span;   // height of this point above the middle along the span [m]
};

namespace detail {

template <class T>
T cubic_step(const T& t) {
  return t <= T(0) ? T(0) : t >= T(1) ? T(1) : t * t * (3.0 - 2.0 * t);
}

}  // namespace detail

template <class T>
PlateForce<T> plate_force(const Vec3<T>& w, double chord, double span, const T& image = T(0)) {
  using std::atan, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt;
  constexpr double kVortex = 3.1, kBreakdown = 0.66322511575784526, kHalfBlend = 0.13962634015954636;
  const T square = w.x * w.x + w.z * w.z, c = sqrt(square), s = w.y < T(0) ? -w.y : w.y;
  const bool has_way = square > T(1e-20);  // a flow along the normal has no direction within the plate
  const T cos2 = has_way ? (w.x * w.x - w.z * w.z) / square : T(0);
  const T A = exp(log((1.0 + image) * (span / chord)) * cos2);  // (5), (7)
  const T potential = (2 * M_PI) * A / (2.0 + sqrt(A * A + 4.0));
  const double slender = span > chord ? span / chord : chord / span, C90 = 1.11 + 0.018 * slender;
  const T stall = kBreakdown * pow(1.0 + A * A * A * A, -0.16);  // (4)
  const T rising = potential * s * c + kVortex * s * s;          // (1)
  const T alpha = has_way ? atan(s / c) : T(M_PI / 2);
  const T sin_stall = sin(stall), cos_stall = cos(stall);
  const T at_stall = sin_stall * (potential * cos_stall + kVortex * sin_stall);
  const T falling =
      s > T(1e-10) ? C90 * s + (at_stall - C90 * sin_stall) * (sin_stall / cos_stall) * c / s : T(0);  // (2)
  const T past = detail::cubic_step((alpha - stall + kHalfBlend) / (2 * kHalfBlend));
  PlateForce<T> f;
  f.normal = s > T(1e-10) ? rising + past * (falling - rising) : rising;
  const T a = pow(A, 1.25), xi = 0.25 * a / (a + 0.48);
  const T way = has_way ? (chord * w.x * w.x + span * w.z * w.z) / square : T(0);
  const T lever = (0.5 - xi) * way * potential / (potential * c + kVortex * s);  // Δ/c of (6)
  f.ahead_chord = -lever * w.x;
  f.ahead_span = -lever * w.z;
  return f;
}

}  // namespace netloft::boards
