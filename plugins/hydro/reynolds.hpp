// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/lane_number.hpp"
#include "plugins/hydro/crossflow.hpp"

namespace netloft::hydro {

/// Normal drag coefficient C_n of a smooth cylinder as a function of the Reynolds number of the flow across
/// it, in the form φ = Re C_n, which stays finite at rest:
///   creeping   φ = (8π/σ)(1 − 0.87/σ²),  σ = ln(8/Re) − 0.077215665     Re < 1           (1)
///   slow       φ = Re (1.45 + 8.55 Re^−0.9)                             1 < Re < 30      (2)
///   fast       φ = Re (1.1 + 4 Re^−½)                                   30 < Re < 10⁵    (3)
/// Source: Choo and Casarella 1971, Hydrodynamic resistance of towed cables, J. Hydronautics 5(4), 126–131.
/// Deviation from the source: φ steps by 1.7 % at Re = 1 and by 1.1 % at 30; within a factor of 1.25 of these
/// numbers, the formulas are blended (smooth step in ln Re), which makes φ continuously differentiable. Below
/// Re = 0.1, φ is continued along its tangent, so that drag is linear in the velocity. (3) is used above 10⁵,
/// too, because ropes are too rough for a well-defined drag crisis. The source also has a formula for
/// friction along a cable, which gives a force over a velocity instead of a coefficient; netting_twine.hpp
/// uses it. All formulas are joined without branches, so that loops over flows vectorise.
inline constexpr double kCreepingBelow = 0.1, kBlend = 1.25;

/// Returns φ by (1) for Re up to kBlend. Above, it returns a constant that is not used, because (1) has a
/// pole at Re = 7.4.
template <class T>
T creeping_phi(const T& Re) {
  using std::log;
  constexpr double kAtOne = 2.0794415416798357 - 0.077215665;  // ln 8 − 0.0772
  const T sigma = at_least(kAtOne - log(Re), kAtOne - std::log(kBlend));
  return (8 * 3.14159265358979323846 / sigma) * (1.0 - 0.87 / (sigma * sigma));  // (1)
}

/// Returns `below` for small Re, `above` for large Re, and a blend within the factor kBlend of `centre`.
template <class T>
T joined(const T& below, const T& above, const T& Re, double centre) {
  using std::log;
  const T w = at_most(at_least(0.5 + 0.5 / std::log(kBlend) * (log(Re) - std::log(centre)), 0), 1);
  const T step = w * w * (3.0 - 2.0 * w);
  return (1.0 - step) * below + step * above;
}

inline const double kSlopeAtRest = creeping_phi(Dual<1, 1>::variable(kCreepingBelow, 0)).gradient[0];

/// φ by (1) and (2), for Re up to 30/kBlend.
template <class T>
T slow_phi(const T& reynolds) {
  using std::pow;
  const T Re = at_least(reynolds, kCreepingBelow);
  const T phi = joined(creeping_phi(Re), Re * (1.45 + 8.55 * pow(Re, -0.9)), Re, 1);  // (2)
  return phi + kSlopeAtRest * (at_most(reynolds, kCreepingBelow) - kCreepingBelow);
}

template <class T>
T choo_casarella_phi(const T& reynolds) {
  using std::sqrt;
  const T Re = at_least(reynolds, kCreepingBelow);
  return joined(slow_phi(reynolds), 1.1 * Re + 4.0 * sqrt(Re), Re, 30);  // (3)
}

/// φ = Re C_n of a cylinder after Takagi et al. 2004. They assume that at Reynolds numbers below 200, as in
/// tests of models, the drag of twines in netting is lower than that of a single cylinder and varies more
/// steeply:
///   φ = Re 10^0.7 Re^−0.3                                               11 < Re < 200      (5)
///   φ = 1.2 Re                                                          200 < Re           (6)
/// Source: Takagi, Shimizu, Suzuki, Hiraishi and Yamamoto 2004, Validity and layout of "NaLA": a net
/// configuration and loading analysis system, Fisheries Research 66, 235–243, as quoted by Cheng, Li,
/// Aarsæther and Ong 2020, Ships and Offshore Structures 15(sup1). Deviations: the step of 17 % at 200 is
/// blended like those of (1) to (3); below Re = 11, where (5) and (2) intersect, (1) and (2) are used.
inline constexpr double kTakagiFrom = 11, kTakagiTo = 200;

template <class T>
T takagi_phi(const T& reynolds) {
  using std::pow;
  const T Re = at_least(reynolds, kCreepingBelow);
  const T low = std::pow(10, 0.7) * pow(Re, 0.7);                                            // (5)
  return joined(joined(slow_phi(reynolds), low, Re, kTakagiFrom), 1.2 * Re, Re, kTakagiTo);  // (6)
}

enum class Cylinder : std::int64_t { choo_casarella, takagi };

/// Calls visit(φ) with the function φ(Re) of a cylinder, so that the function is chosen only once, before the
/// loop over flows.
template <class Visit>
auto with_cylinder_phi(std::int64_t cylinder, const Visit& visit) {
  if (cylinder == static_cast<std::int64_t>(Cylinder::takagi))
    return visit([](const auto& Re) { return takagi_phi(Re); });
  return visit([](const auto& Re) { return choo_casarella_phi(Re); });
}
template <class T>
T cylinder_phi(std::int64_t cylinder, const T& Re) {
  return with_cylinder_phi(cylinder, [&](const auto& phi) { return phi(Re); });
}

/// A continuously differentiable curve over ln x through samples, without overshoot. It consists of cubic
/// pieces. Their slopes at the samples are harmonic means (Fritsch and Butland 1984, SIAM J. Sci. Stat.
/// Comput. 5(2)), and zero at both ends; beyond the ends the curve is constant.
class Curve {
 public:
  explicit Curve(const netloft_table& table) : t_(table) {}
  template <class T>
  T at(const T& x) const {
    using std::log;
    const T l = log(x < T(kLeast) ? T(kLeast) : x);
    if (l <= T(place(0))) return T(value(0));
    if (l >= T(place(t_.rows - 1))) return T(value(t_.rows - 1));
    std::size_t i = 0;
    while (T(place(i + 1)) < l) ++i;
    const double h = place(i + 1) - place(i);
    const T s = (1 / h) * (l - place(i)), s2 = s * s, s3 = s2 * s;
    return (1.0 - 3.0 * s2 + 2.0 * s3) * value(i) + (3.0 * s2 - 2.0 * s3) * value(i + 1) +
           h * ((s - 2.0 * s2 + s3) * slope(i) + (s3 - s2) * slope(i + 1));
  }

 private:
  static constexpr double kLeast = 1e-9;
  double place(std::size_t row) const { return std::log(std::max(t_.values[row * t_.columns], kLeast)); }
  double value(std::size_t row) const { return t_.values[row * t_.columns + 1]; }
  double secant(std::size_t i) const { return (value(i + 1) - value(i)) / (place(i + 1) - place(i)); }
  double slope(std::size_t i) const {
    if (i == 0 || i + 1 == t_.rows) return 0;
    const double before = secant(i - 1), after = secant(i);
    return before * after > 0 ? 2 * before * after / (before + after) : 0;
  }
  netloft_table t_;
};

/// Drag with a normal coefficient C_n that depends on the Reynolds number: crossflow.hpp (1)–(5) with
///   Re = s D/ν,  k = ½ ρ ν φ(Re),  g = ½ ρ ν Re φ'(Re)                  (4)
/// φ = Re C_n is given by (1)–(3), by (5) and (6), or by a table of C_n over Re. ν [m²/s] is the viscosity of
/// the water.
struct MorisonReynolds {
  static constexpr auto kind = NETLOFT_TWINE_LAW;
  struct Parameters {
    double tangential = 0, shielding = 0;
    netloft_table normal{};
    std::int64_t cylinder = 0;
  };
  /// Calls visit(φ) with the function φ(Re) that the parameters choose.
  template <class Visit>
  static auto with_phi(const Parameters& p, const Visit& visit) {
    if (p.normal.rows) return visit([curve = Curve(p.normal)](const auto& Re) { return Re * curve.at(Re); });
    return with_cylinder_phi(p.cylinder, visit);
  }
  template <class T>
  static T phi(const Parameters& p, const T& Re) {
    return with_phi(p, [&](const auto& phi) { return phi(Re); });
  }
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return cross_flow_force(CrossFlow{p.shielding, p.tangential}, f, [&](const T& s) {
      return (0.5 * f.density * f.viscosity) * phi(p, s * (f.diameter / f.viscosity));
    });
  }
  static void lanes(const Parameters& p, const netloft_law_tile& f);
};

}  // namespace netloft::hydro
