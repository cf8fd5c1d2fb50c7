// SPDX-License-Identifier: BSD-3-Clause
//
// Integrators that are wrong in one place each: the trapezoidal rule, or central differences, with a flaw.
// The description of an integrator is the name of the only check that must fail:
// tests/unit/framework/conformance/wrong_integrators_test.cpp reads it.
#include <netloft/integrator.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

using namespace netloft;

namespace {

enum class Flaw {
  none,
  leaves_out,
  edits_start,
  goes_half,
  old_velocity,
  old_time,
  halves_velocity,
  stops_short,
  wrong_order,
  boasts,
  feeds,
  overreaches,
  ignores_refusal,
  ignores_error,
  counts_calls,
  keeps_scratch,
  solves_in_secret,
  needs_unknowns,
  keeps_threads
};

template <Flaw F>
struct Wrong {
  struct Parameters {
    double share = 0;  // weight of the final acceleration in the displacement, 2β of Newmark
  };
  static constexpr bool has(Flaw flaw) { return F == flaw; }
  static constexpr bool kIsExplicit = has(Flaw::old_velocity) || has(Flaw::overreaches);

  static double order(const Parameters&) { return 3; }
  static double stable_step(const Parameters&, double omega) {
    return kIsExplicit ? (has(Flaw::overreaches) ? 4 : 2) / omega : 0;
  }

  static Step step(const Parameters& p, Motion& m) {
    prepare(m);
    const double h = has(Flaw::stops_short) ? std::min(m.h(), 0.02) : m.h();
    const Step step = kIsExplicit ? differ(m, h) : solve(p, m, h);
    estimate(m, h);
    spoil(m);
    return step;
  }

  /// Central differences, with forces at a predicted velocity; one flaw uses the velocity at the start
  /// instead.
  static Step differ(Motion& m, double h) {
    auto predicted = m.scratch(0);
    for (std::size_t i = 0; i < m.size(); ++i) {
      m.next_u()[i] = m.u()[i] + h * m.v()[i] + 0.5 * h * h * m.a()[i];
      predicted[i] = m.v()[i] + (has(Flaw::old_velocity) ? 0 : h * m.a()[i]);
    }
    if (m.accelerate(m.t() + h, m.next_u(), predicted, m.next_a()) != Step::found) return Step::shorter;
    for (std::size_t i = 0; i < m.size(); ++i)
      m.next_v()[i] = m.v()[i] + 0.5 * h * (m.a()[i] + m.next_a()[i]);
    return Step::found;
  }

  /// Newmark's rule with β = ¼ and γ = ½.
  static Step solve(const Parameters& p, Motion& m, double h) {
    const double beta = 0.5 * p.share, gamma = 0.5;
    const double ca = 1 / (beta * h * h), cv = gamma * h * ca;
    const double shown = has(Flaw::halves_velocity) ? 0.5 : 1;  // fraction of the velocity that is returned
    auto v0 = m.scratch(0), a0 = m.scratch(1);
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double v = m.v()[i] / shown;
      const double known =
          m.u()[i] + (has(Flaw::goes_half) ? 0.5 : 1) * h * v + h * h * (0.5 - beta) * m.a()[i];
      a0[i] = -ca * known;
      v0[i] = v + h * (1 - gamma) * m.a()[i] - cv * known;
      m.next_u()[i] = m.u()[i];
    }
    if (!is_solved(m, m.t() + (has(Flaw::old_time) ? 0 : h), v0, cv, a0, ca)) return Step::shorter;
    for (std::size_t i = 0; i < m.size(); ++i) {
      m.next_a()[i] = a0[i] + ca * m.next_u()[i];
      m.next_v()[i] = shown * (v0[i] + cv * m.next_u()[i]) * (has(Flaw::feeds) ? 1 + 0.5 * h * h * h : 1);
    }
    return Step::found;
  }

  static bool is_solved(Motion& m, double t, std::span<double> v0, double cv, std::span<double> a0,
                        double ca) {
    try {
      return m.solve(t, v0, cv, a0, ca, m.next_u()) == Step::found || has(Flaw::ignores_refusal);
    } catch (const std::exception&) {
      if (!has(Flaw::ignores_error)) throw;
      return false;
    }
  }

  static void estimate(Motion& m, double h) {
    const double share = has(Flaw::boasts) ? 1e-3 : has(Flaw::wrong_order) ? 1 / h : 1;
    for (std::size_t i = 0; i < m.size(); ++i) m.error()[i] = share * h * h / 6 * (m.next_a()[i] - m.a()[i]);
  }

  static void prepare(Motion& m) {
    if (has(Flaw::needs_unknowns) && m.size() == 0) throw std::invalid_argument("nothing moves");
    if (has(Flaw::keeps_threads))
      std::thread([] { std::this_thread::sleep_for(std::chrono::minutes(1)); }).detach();
  }

  static void spoil(Motion& m) {
    if (m.size() == 0) return;
    static int calls = 0;
    if (has(Flaw::leaves_out)) m.next_a()[m.size() - 1] = std::nan("");
    if (has(Flaw::edits_start)) const_cast<double&>(m.u()[0]) += 1e-14;
    if (has(Flaw::counts_calls)) m.next_u()[0] += 1e-12 * (++calls % 101);
    if (has(Flaw::keeps_scratch)) {
      auto kept = m.scratch(2);
      if (std::isfinite(kept[0])) m.next_u()[0] += 1e-12;
      kept[0] = 0;
    }
  }
};

template <Flaw F>
void add(Plugin& plugin, const char* name, const char* found_by, std::uint32_t traits = 0,
         double share = 0.5) {
  using Integrator = Wrong<F>;
  auto& i = plugin.integrator<Integrator>(name, found_by);
  i.traits(traits);
  i.real("share", &Integrator::Parameters::share, "1", "of the acceleration at the end",
         {.lo = 0.1, .hi = 1, .fallback = share});
}

}  // namespace

NETLOFT_PLUGIN("wrong_integrators", "1", "Integrators that are wrong in one place each") {
  add<Flaw::none>(plugin, "right", "nothing");
  add<Flaw::none>(plugin, "bad_default", "defaults-are-allowed", 0, 2);
  add<Flaw::leaves_out>(plugin, "leaves_out", "fills-every-output");
  add<Flaw::edits_start>(plugin, "edits_start", "leaves-the-start-alone");
  add<Flaw::goes_half>(plugin, "goes_half", "converges");
  add<Flaw::old_velocity>(plugin, "old_velocity", "keeps-its-order-with-damping", NETLOFT_EXPLICIT);
  add<Flaw::old_time>(plugin, "old_time", "keeps-its-order-under-a-load");
  add<Flaw::halves_velocity>(plugin, "halves_velocity", "answers-between-steps");
  add<Flaw::stops_short>(plugin, "stops_short", "goes-all-the-way");
  add<Flaw::wrong_order>(plugin, "wrong_order", "estimate-shrinks-as-said");
  add<Flaw::boasts>(plugin, "boasts", "estimate-is-honest");
  add<Flaw::feeds>(plugin, "feeds", "gains-no-energy");
  add<Flaw::overreaches>(plugin, "overreaches", "stable-as-it-says", NETLOFT_EXPLICIT);
  add<Flaw::ignores_refusal>(plugin, "ignores_refusal", "says-when-a-step-fails");
  add<Flaw::ignores_error>(plugin, "ignores_error", "stops-at-an-error");
  add<Flaw::counts_calls>(plugin, "counts_calls", "no-hidden-state");
  add<Flaw::keeps_scratch>(plugin, "keeps_scratch", "remembers-nothing-in-scratch");
  add<Flaw::solves_in_secret>(plugin, "solves_in_secret", "explicit-means-explicit", NETLOFT_EXPLICIT);
  add<Flaw::needs_unknowns>(plugin, "needs_unknowns", "steps-nothing");
  add<Flaw::keeps_threads>(plugin, "keeps_threads", "starts-no-threads");
}
