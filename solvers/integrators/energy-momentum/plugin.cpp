// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/integrator.hpp>

#include <cmath>

namespace netloft {

/// The energy-momentum method of J. C. Simo and N. Tarnow (ZAMP 43, 1992): the work of the mean forces F̄ of
/// a step is exactly the change of the energies. The midpoint rule then neither creates nor loses energy,
/// even if members become slack or taut within the step. With displacements u, velocities v, masses M and the
/// step h:
///   M (v₁ − v₀)/h + F̄(u₀, u₁) = 0,  (u₁ − u₀)/h = ½ (v₀ + v₁)                                       (1)
/// Motions too fast for h are damped in both equations, after F. Armero and I. Romero (Comput. Methods Appl.
/// Mech. Engrg. 190, 2001). The damping is proportional to the difference between the rate of velocity and
/// its filtered value m,
///   (u₁ − u₀)/h = ½ (v₀ + v₁) + χ/2 (v₁ − v₀ − h m),  m ← m + ν ((v₁ − v₀)/h − m)                   (2)
/// and the host damps the rate of stretch of members, of stiffness k, in the same way. Slow motions lose
/// nothing to first order in h. At infinite frequency, the factor λ per step satisfies in both equations (1 +
/// χ) λ² + (ν − 2 χ) λ + (ν − 1 + χ) = 0, which has the double root −ρ if
///   χ = (1 − ρ)²/((3 − ρ)(1 + ρ)),  ν = 2 χ + 2 ρ (1 + χ)                                           (3)
/// With ρ = 1, there is no damping, ν = 2, and m is the acceleration of the trapezoidal rule. With ρ = 0,
/// motions too fast for h vanish within two steps. If χ > 0, E + χ/(2 ν) (h² m·M m + Σ k (h m)²) never grows
/// (E the energy), because damping takes from E at least the amount by which the second part grows. The
/// scheme is of second order, with the error per step
///   (ν/12 + χ/2) h² ((v₁ − v₀)/h − m)                                                              (4)
struct EnergyMomentum {
  struct Parameters {
    double spectral_radius = 0.8;
  };
  static Step step(const Parameters& p, Motion& m);
  static double order(const Parameters&) { return 3; }
  static double stable_step(const Parameters&, double) { return 0; }
};

Step EnergyMomentum::step(const Parameters& p, Motion& m) {
  const double h = m.h(), rho = p.spectral_radius;
  const double chi = (1 - rho) * (1 - rho) / ((3 - rho) * (1 + rho)),
               nu = 2 * chi + 2 * rho * (1 + chi);  // (3)
  const double ca = 2 / ((1 + chi) * h * h), cv = 1 / h;
  auto v0 = m.scratch(0), a0 = m.scratch(1), u1 = m.scratch(2);
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double u = m.u()[i], v = m.v()[i];
    v0[i] = -cv * u;
    a0[i] = ca * (0.5 * chi * h * h * m.a()[i] - u - h * v);  // (v₁ − v₀)/h of (2) at u₁ = 0
    u1[i] = u + h * v;
  }
  if (m.solve_between(v0, cv, a0, ca, chi, nu, u1) != Step::found) return Step::shorter;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double rate = a0[i] + ca * u1[i], late = rate - m.a()[i];
    m.next_u()[i] = u1[i];
    m.next_v()[i] = m.v()[i] + h * rate;
    m.next_a()[i] = m.a()[i] + nu * late;
    m.error()[i] = (nu / 12 + chi / 2) * h * h * std::abs(late);  // (4)
  }
  return Step::found;
}

}  // namespace netloft

using netloft::EnergyMomentum;

NETLOFT_PLUGIN("energy-momentum", "0.1.0", "A time scheme that creates no energy") {
  auto& e = plugin.integrator<EnergyMomentum>("energy-momentum",
                                              "Simo and Tarnow's scheme: keeps the energy exactly, and damps "
                                              "motions that are too fast for its steps");
  e.traits(NETLOFT_BETWEEN);
  e.real("spectral_radius", &EnergyMomentum::Parameters::spectral_radius, "1",
         "factor per step on motions that are far too fast for the step: 1 keeps them and all energy, 0 "
         "removes them",
         {.lo = 0, .hi = 1, .fallback = 0.8});
}
