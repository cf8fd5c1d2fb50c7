// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/integrators/newmark/newmark.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::newmark {

namespace {

constexpr double kOwn = 1;  // value of χ that stands for the default of the corrector

struct Scheme {
  double beta, gamma;  // (4)
};

Scheme scheme_of(const Newmark::Parameters& p) {
  const double own = p.corrector == Newmark::kFixedPoint ? -0.3 : 0.0;
  const double chi = p.chi == kOwn ? own : p.chi;
  return {(1 - chi) * (1 - chi) / 4, (1 - 2 * chi) / 2};
}

/// Computes qₙ₊₁ and its rate by (2) and (3) of newmark.hpp from the present q̈ₙ₊₁.
void move(const Scheme& s, Motion& m) {
  const double h = m.h();
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double a = m.a()[i], a1 = m.next_a()[i];
    m.next_u()[i] = m.u()[i] + h * m.v()[i] + 0.5 * h * h * ((1 - 2 * s.beta) * a + 2 * s.beta * a1);
    m.next_v()[i] = m.v()[i] + h * ((1 - s.gamma) * a + s.gamma * a1);
  }
}

double largest(std::span<const double> x, std::span<const double> y) {
  double most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - y[i]));
  return most;
}

/// The corrector "fixed-point": predictor, then corrections until they settle.
Step correct_by_fixed_point(const Newmark::Parameters& p, const Scheme& s, Motion& m) {
  const double h = m.h();
  auto before = m.scratch(0);
  std::copy(m.a().begin(), m.a().end(), m.next_a().begin());
  for (std::int64_t k = 0; k < p.corrections; ++k) {
    move(s, m);
    std::copy(m.next_a().begin(), m.next_a().end(), before.begin());
    if (m.accelerate(m.t() + h, m.next_u(), m.next_v(), m.next_a()) != Step::found) return Step::shorter;
    const double change = s.beta * h * h * largest(m.next_a(), before);
    if (!std::isfinite(change)) return Step::shorter;
    if (change <= p.settled * largest(m.next_u(), m.u())) {
      move(s, m);
      return Step::found;
    }
  }
  return Step::shorter;
}

/// The corrector "solve": solves (1) of newmark.hpp for qₙ₊₁, with velocity and acceleration by (6).
Step correct_by_solving(const Scheme& s, Motion& m) {
  const double h = m.h(), ca = 1 / (s.beta * h * h), cv = s.gamma / (s.beta * h);
  auto v0 = m.scratch(0), a0 = m.scratch(1);
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double known = m.u()[i] + h * m.v()[i] + h * h * (0.5 - s.beta) * m.a()[i];
    a0[i] = -ca * known;
    v0[i] = m.v()[i] + h * (1 - s.gamma) * m.a()[i] - cv * known;
    m.next_u()[i] = m.u()[i] + h * m.v()[i];
  }
  if (m.solve(m.t() + h, v0, cv, a0, ca, m.next_u()) != Step::found) return Step::shorter;
  for (std::size_t i = 0; i < m.size(); ++i) {
    m.next_a()[i] = a0[i] + ca * m.next_u()[i];
    m.next_v()[i] = v0[i] + cv * m.next_u()[i];
  }
  return Step::found;
}

}  // namespace

Step Newmark::step(const Parameters& p, Motion& m) {
  const Scheme s = scheme_of(p);
  const Step step = p.corrector == kFixedPoint ? correct_by_fixed_point(p, s, m) : correct_by_solving(s, m);
  const double factor = m.h() * m.h() * (std::abs(s.beta - 1.0 / 6) + std::abs(s.gamma - 0.5));  // (7)
  for (std::size_t i = 0; i < m.size(); ++i) m.error()[i] = factor * (m.next_a()[i] - m.a()[i]);
  return step;
}

double Newmark::stable_step(const Parameters& p, double omega) {
  return p.corrector == kFixedPoint ? 1 / (std::sqrt(scheme_of(p).beta) * omega) : 0;  // (5)
}

}  // namespace netloft::newmark

using netloft::newmark::Newmark;

NETLOFT_PLUGIN("newmark", "0.1.0", "Newmark's time scheme, as published and implicit") {
  auto& n = plugin.integrator<Newmark>(
      "newmark", "Newmark's scheme, by a solver or by the paper's fixed-point iteration");
  n.choice("corrector", &Newmark::Parameters::corrector,
           "solve: the solver finds each step; fixed-point: the paper's iteration, without a linear system",
           {"solve", "fixed-point"});
  n.real("chi", &Newmark::Parameters::chi, "1",
         "damping of the scheme; 0: none; 1: the default, which is -0.3 with corrector = fixed-point and 0 "
         "with solve",
         {.lo = -1, .hi = 1, .fallback = 1});
  n.integer("corrections", &Newmark::Parameters::corrections, "most fixed-point iterations in a step", 1,
            1000, 30);
  n.real("settled", &Newmark::Parameters::settled, "1",
         "change in an iteration, relative to the move of the step, at which the fixed point has converged",
         {.lo = 1e-15, .hi = 1, .fallback = 1e-4});
}
