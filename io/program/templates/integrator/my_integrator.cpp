// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/integrator.hpp>

/// Newmark's rule (J. Eng. Mech. Div. ASCE 85, 1959), damped by δ. One step leads from u, v, a to u₁, v₁, a₁:
///   u₁ = ũ + β h² a₁,  ũ = u + h v + h² (½ − β) a                          (1)
///   v₁ = v + h (1 − γ) a + γ h a₁,  γ = ½ + δ,  β = (1 + δ)²/4             (2)
///   F(t + h, u₁, v₁, a₁) = 0                                               (3)
/// F is the residual of the equation of motion. With a₁ and v₁ from (1) and (2), (3) is a problem in u₁. The
/// rule is stable at any h. If δ = 0, it is of second order and keeps the energy of a linear oscillation;
/// otherwise it is of first order, and oscillations that are too fast for h decay. Error of one step: h² (|β
/// − 1/6| + δ) (a₁ − a).
struct MyIntegrator {
  struct Parameters {
    double damping = 0;  // δ of (2)
  };
  static double order(const Parameters&) { return 3; }  // the error of one step shrinks with h³
  static double stable_step(const Parameters&, double) { return 0; }

  static netloft::Step step(const Parameters& p, netloft::Motion& m) {
    const double h = m.h(), gamma = 0.5 + p.damping, beta = 0.25 * (1 + p.damping) * (1 + p.damping);
    const double ca = 1 / (beta * h * h), cv = gamma * h * ca;
    const double share = (beta > 1.0 / 6 ? beta - 1.0 / 6 : 1.0 / 6 - beta) + p.damping;
    auto v0 = m.scratch(0), a0 = m.scratch(1);
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double known = m.u()[i] + h * m.v()[i] + h * h * (0.5 - beta) * m.a()[i];  // ũ of (1)
      a0[i] = -ca * known;
      v0[i] = m.v()[i] + h * (1 - gamma) * m.a()[i] - cv * known;
      m.next_u()[i] = m.u()[i] + h * m.v()[i];  // initial guess
    }
    if (m.solve(m.t() + h, v0, cv, a0, ca, m.next_u()) != netloft::Step::found)  // (3)
      return netloft::Step::shorter;
    for (std::size_t i = 0; i < m.size(); ++i) {
      m.next_a()[i] = a0[i] + ca * m.next_u()[i];
      m.next_v()[i] = v0[i] + cv * m.next_u()[i];
      m.error()[i] = h * h * share * (m.next_a()[i] - m.a()[i]);
    }
    return netloft::Step::found;
  }
};

NETLOFT_PLUGIN("my_integrator", "0.1", "A time scheme to begin with") {
  auto& i = plugin.integrator<MyIntegrator>("my_integrator", "Newmark's rule, with damping of its own");
  i.real("damping", &MyIntegrator::Parameters::damping, "1", "damping of the scheme: 0 none",
         {.lo = 0, .hi = 1, .fallback = 0});
}
