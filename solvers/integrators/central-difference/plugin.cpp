// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/integrator.hpp>

namespace netloft {

/// Central differences in the self-starting form (velocity Verlet), with displacements u, velocities v,
/// accelerations a, the step h, and the equation of motion F = 0:
///   uₙ₊₁ = uₙ + h vₙ + ½ h² aₙ                                                     (1)
///   F(tₙ₊₁, uₙ₊₁, vₙ + h aₙ, aₙ₊₁) = 0    drag and damping at a predicted velocity  (2)
///   vₙ₊₁ = vₙ + ½ h (aₙ + aₙ₊₁)                                                     (3)
/// The scheme is explicit: one evaluation of the forces per step, no linear system. It is of second order,
/// and stable for h ≤ 2/ω_max (Courant, Friedrichs, Lewy 1928). The error of one step is h² (aₙ₊₁ − aₙ)/6.
struct CentralDifference {
  struct Parameters {};
  static Step step(const Parameters& p, Motion& m);
  static double order(const Parameters&) { return 3; }
  static double stable_step(const Parameters&, double omega) { return 2 / omega; }
};

Step CentralDifference::step(const Parameters&, Motion& m) {
  const double h = m.h();
  auto predicted = m.scratch(0);
  for (std::size_t i = 0; i < m.size(); ++i) {
    m.next_u()[i] = m.u()[i] + h * m.v()[i] + 0.5 * h * h * m.a()[i];  // (1)
    predicted[i] = m.v()[i] + h * m.a()[i];
  }
  if (m.accelerate(m.t() + h, m.next_u(), predicted, m.next_a()) != Step::found) return Step::shorter;  // (2)
  for (std::size_t i = 0; i < m.size(); ++i) {
    m.next_v()[i] = m.v()[i] + 0.5 * h * (m.a()[i] + m.next_a()[i]);  // (3)
    m.error()[i] = h * h * (m.next_a()[i] - m.a()[i]) / 6;
  }
  return Step::found;
}

}  // namespace netloft

using netloft::CentralDifference;

NETLOFT_PLUGIN("central-difference", "0.1.0", "Explicit central differences") {
  plugin.integrator<CentralDifference>("central-difference", "Explicit: short and cheap steps")
      .traits(NETLOFT_EXPLICIT);
}
