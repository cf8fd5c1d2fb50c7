// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/integrator.hpp>

#include <cmath>

namespace netloft {

/// The generalized-α method of Chung and Hulbert (J. Appl. Mech. 60, 1993): Newmark's method with the
/// equation of motion F = 0 at a time within the step h. Its spectral radius ρ at infinite frequency can
/// therefore be chosen: 1 conserves energy, 0 removes motions that are too fast for h within one step.
///   α_m = (2ρ − 1)/(ρ + 1),  α_f = ρ/(ρ + 1),  γ = ½ − α_m + α_f,  β = ¼ (1 − α_m + α_f)²         (1)
///   F(t_f, u_f, v_f, a_m) = 0,  t_f = tₙ + (1 − α_f) h                                            (2)
///   u_f = (1 − α_f) uₙ₊₁ + α_f uₙ,  v_f alike,  a_m = (1 − α_m) aₙ₊₁ + α_m aₙ                      (3)
///   aₙ₊₁ = (uₙ₊₁ − ũ)/(β h²),  ũ = uₙ + h vₙ + h² (½ − β) aₙ,  vₙ₊₁ = vₙ + h (1 − γ) aₙ + γ h aₙ₊₁  (4)
/// (2) is solved for u_f. The scheme is of second order, and stable for any h. The error of one step is
///   |β − 1/6| h² (aₙ₊₁ − aₙ)                                                                      (5)
struct GeneralizedAlpha {
  struct Parameters {
    double spectral_radius = 0;
  };
  static Step step(const Parameters& p, Motion& m);
  static double order(const Parameters&) { return 3; }
  static double stable_step(const Parameters&, double) { return 0; }
};

Step GeneralizedAlpha::step(const Parameters& p, Motion& m) {
  const double h = m.h(), rho = p.spectral_radius;
  const double am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1);  // (1)
  const double gamma = 0.5 - am + af, beta = 0.25 * (1 - am + af) * (1 - am + af), k = 1 / (beta * h * h);
  const double ca = (1 - am) * k / (1 - af), cv = gamma * h * k;
  auto v0 = m.scratch(0), a0 = m.scratch(1), known = m.scratch(2), u_f = m.scratch(3);
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double u = m.u()[i], v = m.v()[i], a = m.a()[i];
    known[i] = u + h * v + h * h * (0.5 - beta) * a;          // ũ of (4)
    const double rest = k * (-af / (1 - af) * u - known[i]);  // aₙ₊₁ at u_f = 0
    a0[i] = (1 - am) * rest + am * a;
    v0[i] = (1 - af) * (v + h * (1 - gamma) * a + gamma * h * rest) + af * v;
    u_f[i] = u + (1 - af) * h * v;
  }
  if (m.solve(m.t() + (1 - af) * h, v0, cv, a0, ca, u_f) != Step::found) return Step::shorter;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double u1 = (u_f[i] - af * m.u()[i]) / (1 - af), a1 = k * (u1 - known[i]);
    m.next_u()[i] = u1;
    m.next_a()[i] = a1;
    m.next_v()[i] = m.v()[i] + h * ((1 - gamma) * m.a()[i] + gamma * a1);
    m.error()[i] = std::abs(beta - 1.0 / 6) * h * h * (a1 - m.a()[i]);  // (5)
  }
  return Step::found;
}

}  // namespace netloft

using netloft::GeneralizedAlpha;

NETLOFT_PLUGIN("generalized-alpha", "0.1.0", "The generalized-alpha time scheme") {
  auto& g = plugin.integrator<GeneralizedAlpha>(
      "generalized-alpha", "Chung and Hulbert's scheme, with adjustable numerical damping");
  g.real("spectral_radius", &GeneralizedAlpha::Parameters::spectral_radius, "1",
         "factor per step on motions that are far too fast for the step: 1 keeps them, 0 removes them",
         {.lo = 0, .hi = 1, .fallback = 0});
}
