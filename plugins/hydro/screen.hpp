// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/hydro/reynolds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::hydro {

enum class Wake { none, loland };

struct ScreenParameters {
  double shielding = 0;
  std::int64_t wake = 0;
  double measured_at = 0;
  std::int64_t cylinder = 0;
};

/// Force of the water on a square metre of netting, holes included, taken as a screen:
///   U = r W,  u = ‖U‖,  e = U/u,  q = U·n ≥ 0,  c = q/u = cos θ         (1)
///   F = ½ ρ u² [C_D e + C_L e_L],  e_L = (n − c e)/sin θ                 (2)
///     = ½ ρ u [α U + λ q n],  C_L = λ sin θ cos θ,  α = C_D − λ c²       (3)
/// n is the unit normal of the netting that points downstream, θ the angle between flow and normal (0:
/// through the netting, 90°: along it), W [m/s] the velocity of the water relative to the netting, r [1] a
/// factor on W behind other netting, ρ [kg/m³] the density of the water. C_D and C_L are the coefficients of
/// drag and lift; `Model::coefficients` gives C_D and λ as functions of c, the solidity S and the Reynolds
/// number Re = u D/ν, and the subscripts c, S and Re mark derivatives. (3) does not divide by sin θ, so that
/// the force is regular for all θ and without flow.
///   ∂F/∂U = ½ρ [α (u I + U eᵀ) + U (∇α)ᵀ + λ n (q e + u n)ᵀ + q n (∇λ)ᵀ]   (4)
///     ∇α = u ∂α/∂U = α_c (n − c e) + α_Re Re e, and ∇λ alike
///   ∂F/∂n = ½ρ u [(α_c U + λ_c q n) eᵀ + λ (q I + n Uᵀ)]                    (5)
///   ∂F/∂S = ½ρ u [α_S U + λ_S q n] + ∂F/∂U W dr/dS                          (6)
template <class T>
struct ScreenCoefficients {
  T drag, lift;  // coefficients C_D and λ
};

/// Løland's C_D of a screen of the solidity S at normal incidence. It also determines the wake of a screen,
/// (14).
template <class T>
T loland_drag(const T& S) {
  return S * (0.33 + S * (6.54 - 4.88 * S));
}

inline constexpr double kGrazing = 0.05;

/// cos θ, smoothed at grazing incidence (θ near 90°): c² (2ε − c)/ε² for c < ε = kGrazing.             (7)
///
/// The smoothed value is exact at 90° and below 87°. Between these angles, C_D is lower by at most 0.0075 of
/// its range.
template <class T>
T rounded(const T& c) {
  return c < T(kGrazing) ? c * c * (2 * kGrazing - c) / (kGrazing * kGrazing) : c;
}

/// Limits x to [lo, hi]; parabolas within d of lo and hi replace the kinks.             (8)
template <class T>
T held(const T& x, double lo, double hi, double d) {
  if (x < T(lo - d)) return T(lo);
  if (x < T(lo + d)) return lo + (x - (lo - d)) * (x - (lo - d)) / (4 * d);
  if (x < T(hi - d)) return x;
  if (x < T(hi + d)) return hi - ((hi + d) - x) * ((hi + d) - x) / (4 * d);
  return T(hi);
}

/// Limits the solidity to `hi`, because no formula was measured with denser netting.
template <class T>
T held_solidity(const T& S, double hi) {
  return held(S, -1, hi, 0.02);
}

/// Løland 1991, Current forces on and flow through fish farms, dr. ing. thesis, Norwegian Institute of
/// Technology. S is the solidity, θ the angle between the flow and the normal of the netting:
///   C_D = 0.04 + (−0.04 + 0.33 S + 6.54 S² − 4.88 S³) cos θ             (9)
///   C_L = (−0.05 S + 2.3 S² − 1.76 S³) sin 2θ
/// Measured for 0.13 < S < 0.32; S is limited to 0.35. Below S₀ = 0.13, both coefficients are those at S₀
/// times S/S₀: twines that are far apart do not feel each other, so that the force is proportional to their
/// number. C_D at normal incidence is then 1.10 S, where a cylinder at Re = 2000 has 1.19 S (Choo and
/// Casarella 1971). The polynomials themselves tend to 0.33 S, and along the netting C_D would be 0.04 even
/// without twines.
struct LolandModel {
  using Parameters = ScreenParameters;
  static constexpr double kLeast = 0.13, kMost = 0.35, kSoft = 0.02;
  template <class T>
  static ScreenCoefficients<T> coefficients(const Parameters&, const T& c, const T& solidity, const T&) {
    const T S = held(solidity, kLeast, kMost, kSoft), few = solidity / held(solidity, kLeast, 2, kSoft);
    return {few * (0.04 + (loland_drag(S) - 0.04) * rounded(c)),
            few * (2.0 * (S * (-0.05 + S * (2.3 - 1.76 * S))))};
  }
};

/// Aarsnes, Rudi and Løland 1990, Current forces on cage, net deflection, in: Engineering for Offshore Fish
/// Farming. S is the solidity, θ the angle between the flow and the normal of the netting:
///   C_D = 0.04 + (−0.04 + S − 1.24 S² + 13.7 S³) cos θ                  (10)
///   C_L = (0.57 S − 3.54 S² + 10.1 S³) sin 2θ
/// Valid for S < 0.35; S is limited to 0.35.
struct AarsnesModel {
  using Parameters = ScreenParameters;
  template <class T>
  static ScreenCoefficients<T> coefficients(const Parameters&, const T& c, const T& solidity, const T&) {
    const T S = held_solidity(solidity, 0.35);
    return {0.04 + (S * (1.0 + S * (-1.24 + 13.7 * S)) - 0.04) * rounded(c),
            2.0 * (S * (0.57 + S * (-3.54 + 10.1 * S)))};
  }
};

/// Kristiansen and Faltinsen 2012, Modelling of current loads on aquaculture net cages, J. Fluids Struct. 34.
/// S is the solidity, θ the angle between the flow and the normal of the netting:
///   C_D = C_0 (0.9 cos θ + 0.1 cos 3θ),  C_L = C_45 (sin 2θ + 0.1 sin 4θ)          (11)
///   C_0 = C_circ S (2 − S)/(2 (1 − S)²),  C_circ over x = log₁₀(Re), Re = u D/(ν (1 − S))  (12)
///   C_45 = (C_N − C_T)/√2,  C_N = C_0/2,  C_T = π C_N/(8 + C_N)                    (13)
/// C_0 is C_D at θ = 0 and C_45 is C_L at 45°. C_circ, the drag coefficient of a cylinder, is a polynomial
/// for 10^1.5 < Re < 10⁴ and constant beyond. S is limited to 0.5.
struct KristiansenFaltinsenModel {
  using Parameters = ScreenParameters;
  template <class T>
  static ScreenCoefficients<T> coefficients(const Parameters&, const T& c, const T& solidity,
                                            const T& Re_twine) {
    using std::log;
    const T S = held_solidity(solidity, 0.5), open = 1.0 - S;
    const T Re = Re_twine / open;
    const T x = held((1 / std::numbers::ln10) * log(Re < T(1) ? T(1) : Re), 1.5, 4, 0.1);
    T circ(0.0);
    for (const double a : {0.12479, -2.4489, 20.00769, -87.92234, 223.64577, -327.8864, 254.73873, -78.46675})
      circ = circ * x + a;
    const T C_0 = circ * S * (2.0 - S) / (2.0 * open * open);                             // (12)
    const T C_N = 0.5 * C_0, C_T = std::numbers::pi * C_N / (8.0 + C_N), a = rounded(c);  // (13)
    return {C_0 * a * (0.6 + 0.4 * a * a),                             // cos 3θ = 4c³ − 3c
            std::numbers::sqrt2 * (C_N - C_T) * (0.8 + 0.4 * c * c)};  // sin 4θ = 2 sin 2θ (2c² − 1)
  }
};

struct KnottedParameters : ScreenParameters {
  double normal = 0, friction = 0, friction_slope = 0;
};

/// Knotted trawl netting, from the abstract of an article in Nippon Suisan Gakkaishi (Bull. Japan. Soc. Sci.
/// Fish.) 45(10), 1979; the article itself was not available:
///   C_D = S [C_90 sin^⅖ a + cos a (C_F + K sin a)],  C_L = S C_90 sin^(3/2) a cos a        (16)
/// S is the solidity and a the angle of attack: a = 90° − θ, sin a = c of (1). C_90 is the coefficient of
/// pressure drag at normal incidence; C_F and K are coefficients of friction along the flow. All three refer
/// to the area of the twines. The drag at small angles is far higher than that of laws proportional to the
/// sine. The abstract gives no coefficients. C_90 is therefore that of a cylinder at Re = 1000, 1.23, plus 10
/// % for the knots, which the abstract mentions; C_F is 0.3 C_90 after Niño et al. 2020 (nylon nets along the
/// flow, 0.2 to 0.4); K is zero. Users should vary C_F and K to see their effect. Deviations from the
/// abstract: sin^⅖, sin^½ = sin^(3/2)/sin and K sin a have no derivative at grazing incidence, and cos a has
/// none at normal incidence; within 3° of these angles, smooth functions replace them, by (7) and (17). S is
/// limited to 0.5.
struct KnottedModel {
  using Parameters = KnottedParameters;
  /// c^p for c ≥ ε = kGrazing. Below ε it is a cubic in c with the same value and slope at ε.     (17)
  template <class T>
  static T power(const T& c, double p) {
    using std::pow;
    if (!(c < T(kGrazing))) return pow(c, p);
    const T y = (1 / kGrazing) * c;
    return std::pow(kGrazing, p) * (y * y * ((3.0 - p) + (p - 2.0) * y));
  }
  /// sin θ = √(1 − c²), smoothed like (7) near normal incidence, where it vanishes.
  template <class T>
  static T along(const T& c) {
    using std::sqrt;
    const T square = 1.0 - c * c;
    const T root = sqrt((square < T(0) ? T(0) : square) + 1e-30);
    return root < T(kGrazing) ? square * (2 * kGrazing - root) / (kGrazing * kGrazing) : root;
  }
  template <class T>
  static ScreenCoefficients<T> coefficients(const Parameters& p, const T& c, const T& solidity, const T&) {
    const T S = held_solidity(solidity, 0.5);
    return {S * (p.normal * power(c, 0.4) + along(c) * (p.friction + p.friction_slope * rounded(c))),
            S * (p.normal * power(c, 0.5))};
  }
};

/// Factor on the coefficients of a screen if the Reynolds number Re = u D/ν differs from Re₀, that of the
/// measurements:
///   C_n(Re)/C_n(Re₀)                                                     (15)
/// C_n is the drag coefficient of a cylinder by Choo and Casarella 1971, or by Takagi et al. 2004
/// (reynolds.hpp). The factor is 1 if Re₀ = 0. It assumes that a twine in a screen depends on the Reynolds
/// number like a single cylinder, which is an estimate for Re below about 500. Below Re = 2 (1 mm/s for a
/// twine of 2.4 mm), 1 + Re²/4 replaces Re, with the same value and slope at Re = 2. Otherwise the force near
/// rest would be linear in the velocity with coefficients that depend on an angle, and therefore not
/// differentiable in water at rest.

template <class T>
T reynolds_factor(const ScreenParameters& p, const T& Re) {
  if (p.measured_at == 0) return T(1);
  const T at = Re < T(2) ? 1.0 + 0.25 * Re * Re : Re;
  return cylinder_phi(p.cylinder, at) / at / (cylinder_phi(p.cylinder, p.measured_at) / p.measured_at);
}

/// The factor r of (1): the parameter `shielding`, times Løland's 1 − 0.46 C_D(S, θ = 0) if netting of the
/// same solidity is upstream, as for the rear of a cage or the lower panel of a trawl.          (14)
template <class T>
T flow_left(const ScreenParameters& p, const T& S) {
  if (p.wake == static_cast<std::int64_t>(Wake::none)) return T(p.shielding);
  return p.shielding * (1.0 - 0.46 * loland_drag(held_solidity(S, 0.35)));
}

template <class Model, class T>
ScreenCoefficients<T> scaled(const typename Model::Parameters& p, const T& c, const T& S, const T& Re) {
  const auto C = Model::coefficients(p, c, S, Re);
  const T factor = reynolds_factor(p, Re);
  return {factor * C.drag, factor * C.lift};
}

template <class Model>
struct Screen {
  static constexpr auto kind = NETLOFT_SCREEN_LAW;
  using Parameters = typename Model::Parameters;
  /// (3) for dual numbers: the reference implementation for tests.
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    const Vec3<T> U = flow_left(p, f.solidity) * f.flow;
    const bool with = dot(U, f.direction) >= T(0);
    const Vec3<T> n = (with ? 1.0 : -1.0) * f.direction;
    const T u = norm(U), q = dot(U, n), c = q / u;
    const auto C = scaled<Model>(p, c, f.solidity, u * (f.diameter / f.viscosity));
    return (0.5 * f.density * u) * ((C.drag - C.lift * c * c) * U + (C.lift * q) * n);
  }
  static void lanes(const Parameters& p, const netloft_law_tile& f);
};

using Loland = Screen<LolandModel>;
using Aarsnes = Screen<AarsnesModel>;
using KristiansenFaltinsen = Screen<KristiansenFaltinsenModel>;
using Knotted = Screen<KnottedModel>;

}  // namespace netloft::hydro
