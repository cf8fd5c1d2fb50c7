// SPDX-License-Identifier: BSD-3-Clause
// Checks of an integrator: its steps follow a known motion with the declared order and error estimate, create
// no energy, have no memory, and report failures.
#include "framework/conformance/checklist.hpp"
#include "framework/conformance/method_bench.hpp"
#include "framework/conformance/practice_motion.hpp"
#include "framework/conformance/timing.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace netloft {

namespace conformance {
namespace {

struct IntegratorBench : MethodBench {
  IntegratorBench(const IntegratorType& t, const ConformanceOptions& o)
      : MethodBench(t.parameters, t.integrator.parameter_bytes, o), scheme(t.integrator), type(t) {}

  /// Runs a motion. Returns OK, or the status of the first step that failed.
  int run(PracticeMotion& motion, const std::vector<double>& lengths, double end) {
    return guarded(type.type, "step", NETLOFT_ERROR,
                   [&] { return motion.run(scheme, parameters.data(), lengths, end); });
  }
  double order() const { return scheme.order(parameters.data()); }
  double stable_step(double omega) const { return scheme.stable_step(parameters.data(), omega); }

  const netloft_integrator& scheme;
  const IntegratorType& type;
};

const PracticeSwing kFree{};
const PracticeSwing kDamped{.damping = 0.2};
const PracticeSwing kPushed{.push = 1};

Finding up_to(double figure, double limit, std::string detail) {
  Finding f;
  f.figure = figure;
  f.limit = limit;
  f.passed = figure <= limit;
  f.detail = std::move(detail);
  return f;
}

Finding integrator_lets_no_exception_escape(IntegratorBench& b) {
  for (const int status : {NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN, NETLOFT_ERROR}) {
    PracticeMotion motion({.fails = status});
    b.run(motion, {0.01}, 0.03);
  }
  return judged(b.thrown);
}

Finding fills_every_output(IntegratorBench& b) {
  PracticeMotion motion(kFree);
  if (const int status = b.run(motion, {0.01}, 0.02); status != NETLOFT_OK)
    return failed("a step of a linear oscillator returned " + std::to_string(status));
  return motion.is_finite() ? Finding{} : failed("u_new, v_new or a_new contains NaN or infinity");
}

Finding leaves_the_start_alone(IntegratorBench& b) {
  PracticeMotion motion(kFree);
  b.run(motion, {0.01}, 0.03);
  return motion.left_alone() ? Finding{} : failed("u, v or a at the start of a step has changed");
}

constexpr double kSpan = 2;  // duration [s]; the periods of the motion are 3 to 6 s

double error_with(IntegratorBench& b, const PracticeSwing& like, int steps) {
  PracticeMotion motion(like);
  b.run(motion, {kSpan / steps}, kSpan);
  return motion.t < kSpan * (1 - 1e-9) ? std::numeric_limits<double>::infinity() : motion.error();
}

/// The observed order: the power of the step to which the error at the end is proportional.
double order_of(IntegratorBench& b, const PracticeSwing& like) {
  return std::log2(error_with(b, like, 128) / error_with(b, like, 256));
}

/// Largest allowed difference between the observed and the expected order.
constexpr double kOrderSeen = 0.2;

Finding converges(IntegratorBench& b) {
  const double order = order_of(b, kFree), error = error_with(b, kFree, 256);
  Finding f =
      up_to(1 - order, kOrderSeen, "order " + std::to_string(order) + " of the error of a free motion");
  f.passed = f.passed && error < 0.1;
  return f;
}

Finding keeps_its_order(IntegratorBench& b, const PracticeSwing& like, const char* motion) {
  const double free = order_of(b, kFree), here = order_of(b, like);
  return up_to(
      free - here, kOrderSeen,
      "order " + std::to_string(here) + " of " + motion + ", " + std::to_string(free) + " of a free one");
}

Finding keeps_its_order_with_damping(IntegratorBench& b) {
  return keeps_its_order(b, kDamped, "a damped motion");
}
Finding keeps_its_order_under_a_load(IntegratorBench& b) {
  return keeps_its_order(b, kPushed, "a motion under a load that grows");
}

/// Checks that a step is as long as requested. The integrator may refuse a step that is too long, but not
/// shorten it silently.
Finding goes_all_the_way(IntegratorBench& b) {
  PracticeMotion motion(kFree);
  const double stable = b.stable_step(2), h = stable > 0 ? std::min(0.2, 0.5 * stable) : 0.2;
  if (b.run(motion, {h}, 3) != NETLOFT_OK) return not_applicable("it refuses long steps");
  return up_to(motion.error(), 1, "error of the position after 3 s in steps of " + std::to_string(h) + " s");
}

double error_between(IntegratorBench& b, int steps) {
  PracticeMotion motion(kFree);
  b.run(motion, {kSpan / steps}, kSpan);
  return motion.error_between;
}

/// Within a step, the host interpolates by a cubic, so that the order between the ends is four at most.
Finding answers_between_steps(IntegratorBench& b) {
  const double ends = std::min(4.0, order_of(b, kFree));
  const double here = std::log2(error_between(b, 128) / error_between(b, 256));
  return up_to(ends - here, kOrderSeen,
               "order " + std::to_string(here) + " within steps, " + std::to_string(ends) + " at their ends");
}

constexpr double kWhere = 0.5;  // time at which neither velocities nor accelerations vanish [s]

double estimate_with(IntegratorBench& b, int steps) {
  PracticeMotion motion(kFree);
  b.run(motion, {kWhere / steps}, kWhere);
  return motion.estimate;
}

Finding estimate_shrinks_as_said(IntegratorBench& b) {
  const double coarse = estimate_with(b, 50), fine = estimate_with(b, 100);
  if (coarse == 0 && fine == 0) return not_applicable("it gives no estimate of its errors");
  const double seen = std::log2(coarse / fine);
  return up_to(std::abs(seen - b.order()), kOrderSeen,
               "the estimate shrinks with order " + std::to_string(seen) + ", but `order` is " +
                   std::to_string(b.order()));
}

Finding estimate_is_honest(IntegratorBench& b) {
  PracticeMotion motion(kFree);
  b.run(motion, {0.02}, kWhere);
  if (motion.estimated == 0) return not_applicable("it gives no estimate of its errors");
  return up_to(motion.error() / motion.estimated, 3, "error after 25 steps over the sum of their estimates");
}

Finding gains_no_energy(IntegratorBench& b) {
  PracticeMotion motion(kFree);
  b.run(motion, {0.1}, 200);
  return up_to(motion.energy(), 1.05, "energy after 2000 steps of a free motion over that of the start");
}

/// Checks the declared stable step. The energy must stay bounded with steps of 0.8 times the stable step. If
/// every step is declared stable, the energy must stay bounded with steps of 100 divided by the angular
/// frequency.
Finding stable_as_it_says(IntegratorBench& b) {
  const double fastest = 2, stable = b.stable_step(fastest);
  const double h = stable > 0 ? 0.8 * stable : 100 / fastest;
  PracticeMotion motion(kFree);
  if (b.run(motion, {h}, 1000 * h) != NETLOFT_OK) return failed("a stable step is refused");
  return up_to(motion.energy(), 10,
               "energy after 1000 steps of " + std::to_string(h) + " s over that of the start");
}

Finding says_when_a_step_fails(IntegratorBench& b) {
  PracticeMotion motion({.fails = NETLOFT_OUTSIDE_DOMAIN});
  return b.run(motion, {0.01}, 0.01) != NETLOFT_OK ? Finding{}
                                                   : failed("it reports success for a step without forces");
}

Finding stops_at_an_error_of_a_step(IntegratorBench& b) {
  PracticeMotion motion({.fails = NETLOFT_ERROR});
  const int status = b.run(motion, {0.01}, 0.01);
  return status < 0 ? Finding{}
                    : failed("returned " + std::to_string(status) + " after an error of the host");
}

bool moves_alike(const PracticeMotion& one, const PracticeMotion& two) {
  const auto same = [](const std::vector<double>& x, const std::vector<double>& y) {
    return std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
  };
  return same(one.u, two.u) && same(one.v, two.v) && same(one.a, two.a);
}

Finding integrator_has_no_hidden_state(IntegratorBench& b) {
  PracticeMotion first(kDamped), other(kFree), again(kDamped);
  b.run(first, {0.01, 0.02}, 0.1);
  b.run(other, {0.03}, 0.09);
  b.run(again, {0.01, 0.02}, 0.1);
  return moves_alike(first, again) ? Finding{} : failed("two runs of the same steps give different answers");
}

Finding remembers_nothing_in_scratch(IntegratorBench& b) {
  PracticeMotion kept(kDamped), cleared(kDamped);
  kept.clears_scratch = false;
  b.run(kept, {0.01}, 0.1);
  b.run(cleared, {0.01}, 0.1);
  return moves_alike(kept, cleared) ? Finding{}
                                    : failed("a step depends on what an earlier step left in scratch");
}

Finding explicit_means_explicit(IntegratorBench& b) {
  if (!b.type.is_explicit()) return not_applicable("it does not say that it is explicit");
  PracticeMotion motion(kFree);
  b.run(motion, {0.01}, 0.02);
  return motion.solves == 0 ? Finding{} : failed("it calls `solve`");
}

Finding steps_nothing(IntegratorBench& b) {
  PracticeMotion motion({.unknowns = 0});
  const int status = b.run(motion, {0.01}, 0.02);
  return status == NETLOFT_OK ? Finding{} : failed("returned " + std::to_string(status));
}

// The order matters: a check comes after the checks on which it depends.
const std::vector<Check<IntegratorBench>>& integrator_table() {
  static const std::vector<Check<IntegratorBench>> checks = {
      {"defaults-are-allowed",
       method_defaults_are_allowed,
       {},
       "a default must lie in the range that its own parameter allows"},
      {"no-exception-escapes",
       integrator_lets_no_exception_escape,
       {"defaults-are-allowed"},
       "catch every exception before it leaves the plugin, as the code of integrator.hpp does; leave "
       "rounding "
       "and traps as they were"},
      {"fills-every-output",
       fills_every_output,
       {"no-exception-escapes"},
       "a step sets next_u, next_v and next_a, each completely"},
      {"leaves-the-start-alone",
       leaves_the_start_alone,
       {"fills-every-output"},
       "a step may be refused and repeated: do not change u, v and a"},
      {"converges",
       converges,
       {"fills-every-output"},
       "masses on springs: shorter steps must reduce the error; are all powers of h present?"},
      {"keeps-its-order-with-damping",
       keeps_its_order_with_damping,
       {"converges"},
       "at which velocity are forces evaluated? It must be that of the end of the step, or a prediction of "
       "it"},
      {"keeps-its-order-under-a-load",
       keeps_its_order_under_a_load,
       {"converges"},
       "at which time are forces evaluated? The first argument of `solve` and `accelerate`"},
      {"answers-between-steps",
       answers_between_steps,
       {"converges"},
       "outputs between steps are on the cubic through both ends: next_v must be the rate of next_u there"},
      {"goes-all-the-way",
       goes_all_the_way,
       {"converges"},
       "the step has the length `h`; if that is too long, return Step::shorter"},
      {"estimate-shrinks-as-said",
       estimate_shrinks_as_said,
       {"converges"},
       "`order` is the power of h in `error`, the error of one step, which is one above that of the scheme"},
      {"estimate-is-honest",
       estimate_is_honest,
       {"converges"},
       "`error` must not be much below the actual error of a step; the step control relies on it"},
      {"gains-no-energy",
       gains_no_energy,
       {"converges"},
       "a free motion must not grow at steps far below its period"},
      {"stable-as-it-says",
       stable_as_it_says,
       {"gains-no-energy"},
       "`stable_step` promises that shorter steps are stable; 0 promises that all are"},
      {"says-when-a-step-fails",
       says_when_a_step_fails,
       {"no-exception-escapes"},
       "check the results of `solve` and `accelerate`; Step::shorter reports that the step was not found"},
      {"stops-at-an-error",
       stops_at_an_error_of_a_step,
       {"no-exception-escapes"},
       "an error of the host ends the step with an error; a shorter step does not help"},
      {"no-hidden-state",
       integrator_has_no_hidden_state,
       {"fills-every-output"},
       "no static or mutable variables: the same steps have the same answer, bit for bit"},
      {"remembers-nothing-in-scratch",
       remembers_nothing_in_scratch,
       {"no-hidden-state"},
       "use scratch within a step only: a march that continues from a file must give the same results"},
      {"explicit-means-explicit",
       explicit_means_explicit,
       {"fills-every-output"},
       "remove traits(NETLOFT_EXPLICIT), or use `accelerate`"},
      {"steps-nothing", steps_nothing, {"no-exception-escapes"}, "a scene may have no unknowns at all"},
      {"starts-no-threads",
       method_starts_no_threads,
       {},
       "the program runs threads of its own; a thread started by a plugin slows them down"},
  };
  return checks;
}

/// Time per unknown and step.
TermTiming time_stepping(IntegratorBench& b) {
  constexpr int kSteps = 100;
  constexpr std::uint32_t kUnknowns = 300;
  const double spent =
      least_nanoseconds([] { return PracticeMotion({.unknowns = kUnknowns}); },
                        [&](PracticeMotion& motion) { b.run(motion, {1e-4}, kSteps * 1e-4); });
  return {"free motion", std::to_string(kSteps) + " steps", spent / kSteps / kUnknowns, "step and unknown"};
}

}  // namespace
}  // namespace conformance

ConformanceReport check_integrator(const IntegratorType& type, const ConformanceOptions& options) {
  using namespace conformance;
  ConformanceReport report;
  report.type = type.type;
  IntegratorBench bench(type, options);
  Doubtful doubtful;
  report.checks = run_all(integrator_table(), bench, doubtful);
  if (options.timings && !doubtful.among({"fills-every-output"})) report.timings = {time_stepping(bench)};
  return report;
}

std::vector<std::string> integrator_checks() {
  return conformance::names_of(conformance::integrator_table());
}

}  // namespace netloft
