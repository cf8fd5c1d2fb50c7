// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/other_integrators.hpp"

#include <malloc.h>

#include <atomic>
#include <limits>

#include "framework/conformance/conformance.hpp"

namespace netloft::test {
namespace {

using conformance::PracticeMotion;
using conformance::PracticeSwing;

Chosen with_radius(const std::string& integrator, double rho) {
  return {integrator, {{"spectral_radius", rho}}};
}

class TsRadius : public testing::TestWithParam<double> {
 protected:
  const Chosen ts_ = with_radius("ts", GetParam());
};

TEST_P(TsRadius, HasOrderTwoInAMotionWithDamping) {
  EXPECT_NEAR(order_in_a_motion_with_damping(ts_), 2, 0.05);
}

TEST_P(TsRadius, EstimatesErrorsThatShrinkAsItSays) {
  EXPECT_NEAR(order_of_estimates(ts_), ts_.type.integrator.order(ts_.block.data()), 0.2);
}

/// Column `c` of what one step of h makes of (u, h v, h² a) of a mass that swings with 1 rad/s.
std::array<double, 3> amplified(const Chosen& scheme, double h, std::size_t c) {
  PracticeMotion motion({.unknowns = 1});
  motion.u[0] = c == 0, motion.v[0] = (c == 1) / h, motion.a[0] = (c == 2) / (h * h);
  EXPECT_EQ(motion.run(scheme.type.integrator, scheme.block.data(), {h}, h), NETLOFT_OK);
  return {motion.u[0], h * motion.v[0], h * h * motion.a[0]};
}

// Chung and Hulbert chose α_m and α_f such that all three eigenvalues tend to −ρ: (λ + ρ)³ = 0.
TEST_P(TsRadius, IsAsAskedFarAboveTheStep) {
  const double h = 1e4, rho = GetParam();
  const auto A = amplified(ts_, h, 0), B = amplified(ts_, h, 1), C = amplified(ts_, h, 2);
  const auto minor = [](const auto& p, const auto& q, std::size_t i, std::size_t k) {
    return p[i] * q[k] - p[k] * q[i];
  };
  EXPECT_NEAR(A[0] + B[1] + C[2], -3 * rho, 1e-6);
  EXPECT_NEAR(minor(A, B, 0, 1) + minor(A, C, 0, 2) + minor(B, C, 1, 2), 3 * rho * rho, 1e-6);
  EXPECT_NEAR(A[0] * minor(B, C, 1, 2) + A[1] * minor(B, C, 2, 0) + A[2] * minor(B, C, 0, 1),
              -rho * rho * rho, 1e-6);
}

// The same recurrence in another implementation: after one step from the same state the ends differ by
// rounding alone, of u, of u/h and of u/h².
TEST_P(TsRadius, TakesTheStepsOfOurOwnGeneralizedAlpha) {
  const Chosen generalized_alpha = with_radius("generalized-alpha", GetParam());
  const auto step = [](PracticeMotion& m, const Chosen& scheme, double h) {
    ASSERT_EQ(m.run(scheme.type.integrator, scheme.block.data(), {h}, m.t + h), NETLOFT_OK);
  };
  for (const PracticeSwing& like : {PracticeSwing{.damping = 0.2}, PracticeSwing{.push = 1}}) {
    PracticeMotion own(like);
    for (const double h : {0.1, 0.03, 0.2, 1.0, 1e-3, 0.1, 0.01}) {
      PracticeMotion ts(like);
      ts.t = own.t, ts.u = own.u, ts.v = own.v, ts.a = own.a;
      step(ts, ts_, h);
      step(own, generalized_alpha, h);
      const double rounding = 32 * std::numeric_limits<double>::epsilon();  // of numbers up to 1
      EXPECT_LT(largest_distance(ts.u, own.u), rounding);
      EXPECT_LT(largest_distance(ts.v, own.v), rounding * std::max(1.0, 1 / h));
      EXPECT_LT(largest_distance(ts.a, own.a), rounding * std::max(1.0, 1 / (h * h)));
      EXPECT_NEAR(ts.estimate, own.estimate, rounding);
    }
  }
}

/// The panel of the gear library in a coarse mesh, let go flat in a current.
MarchResult panel_in_current(const std::string& integrator, double rho, const std::string& duration) {
  return end_of("panel-in-current.toml",
                {"parts.net.cells=[5,5]", "parts.weights.number=6", "analysis.output_interval=0",
                 "analysis.solver=chord", "analysis.tolerance=1e-11", "analysis.adaptive=false",
                 "analysis.step=0.005", "analysis.duration=" + duration, "analysis.integrator=" + integrator,
                 "analysis." + integrator + ".spectral_radius=" + std::to_string(rho)});
}

TEST_P(TsRadius, MovesAPanelInACurrentAsOurOwnGeneralizedAlphaDoes) {
  const MarchResult ts = panel_in_current("ts", GetParam(), "0.1");
  EXPECT_EQ(ts.steps, 20);
  EXPECT_LT(largest_distance(ts, panel_in_current("generalized-alpha", GetParam(), "0.1")), 1e-12);  // [m]
}

INSTANTIATE_TEST_SUITE_P(Each, TsRadius, testing::Values(0.0, 0.5, 1.0), [](const auto& tested) {
  return "Of" + std::to_string(static_cast<int>(10 * tested.param)) + "Tenths";
});

TEST(Ts, MovesASpringAsItsClosedFormSays) { EXPECT_LT(distance_from_closed_form_of_a_spring("ts"), 1e-3); }

TEST(Ts, LetsTheHostChooseTheSteps) {
  const auto adaptive = [](const std::string& integrator) {
    return swing({"analysis.accuracy=1e-3", "analysis.integrator=" + integrator});
  };
  const MarchResult ts = adaptive("ts"), own = adaptive("generalized-alpha");
  EXPECT_EQ(ts.steps, own.steps);
  EXPECT_EQ(ts.rejected, own.rejected);
  EXPECT_GT(ts.longest, 2 * ts.shortest);
  EXPECT_LT(largest_distance(ts, own), 1e-9);
}

// A thread of MPI's comes with the first step of a process, and sleeps.
TEST(Ts, KeepsThePromisesOfIntegrators) {
  const Chosen chosen("ts", {});
  after(chosen, 1, 0.01, {});
  const ConformanceReport report = check_integrator(chosen.type, {.timings = false});
  EXPECT_TRUE(report.passed()) << failures(report);
}

TEST(Ts, TakesShorterStepsWhereAStageIsNotFound) {
  EXPECT_EQ(step_where_the_host_answers(NETLOFT_OUTSIDE_DOMAIN, {"ts", {}}), NETLOFT_OUTSIDE_DOMAIN);
}

TEST(Ts, StepsAsBeforeAfterAnErrorOfTheHost) {
  const Chosen chosen("ts", {});
  const auto before = after(chosen, 7, 1, {});
  EXPECT_LT(step_where_the_host_answers(NETLOFT_ERROR, chosen), 0);
  EXPECT_EQ(after(chosen, 7, 1, {}).u, before.u);
}

/// The spring of `Oscillator`, let go 0.1 m from its rest.
struct LetGo {
  LetGo() : moving(Oscillator().scene()), from(state_at_rest(moving.assembler)) {
    from.u[0] = 0.1;
    settings.duration = 20 / Oscillator().omega(), settings.step = 0.02 / Oscillator().omega(),
    settings.adaptive = false;
  }
  MarchResult run(const std::string& integrator) { return moving.run(integrator, {}, settings, &from); }

  Moving moving;
  MarchState from;
  MarchSettings settings;
};

TEST(Ts, LeavesItToTheHostToSayWhyAStepIsNotFound) {
  LetGo ts, own;
  ts.moving.limits.iterations = own.moving.limits.iterations = 0;
  const MarchResult r = ts.run("ts");
  EXPECT_EQ(r.status, MarchStatus::failed);
  EXPECT_NE(r.reason.find("too many iterations in a step"), std::string::npos) << r.reason;
  EXPECT_EQ(r.reason, own.run("generalized-alpha").reason);
}

TEST(Ts, StopsWhenInterrupted) {
  LetGo spring;
  std::atomic<bool> interrupt{false};
  spring.moving.limits.interrupt = &interrupt;
  spring.settings.output_interval = spring.settings.duration / 4;
  spring.moving.watch.on_output = [&](const Snapshot& s) { interrupt = s.t > 0; };
  const MarchResult r = spring.run("ts");
  EXPECT_EQ(r.status, MarchStatus::interrupted);
  EXPECT_NEAR(r.t, spring.settings.output_interval, 1e-9);
}

#ifdef __GLIBC__

std::size_t memory_in_use() { return mallinfo2().uordblks; }

// One vector of 300 numbers a step would be 2.4 MB.
TEST(Ts, GivesBackWhatItTookForAStep) {
  for (const int status : {NETLOFT_OK, NETLOFT_OUTSIDE_DOMAIN, NETLOFT_ERROR}) {
    const Chosen chosen("ts", {});
    const auto steps = [&](int n) {
      PracticeMotion motion({.fails = status, .unknowns = 300});
      for (int i = 0; i < n; ++i)
        motion.run(chosen.type.integrator, chosen.block.data(), {0.01}, motion.t + 0.01);
    };
    steps(10);
    const std::size_t before = memory_in_use();
    steps(1000);
    EXPECT_LT(memory_in_use(), before + 10'000) << status;
  }
}

#endif

TEST(Ts, RefusesARadiusAboveOne) {
  const Chosen chosen = with_radius("ts", 1.5);
  ASSERT_EQ(chosen.faults.size(), 1u);
  EXPECT_NE(chosen.faults[0].find("spectral_radius"), std::string::npos) << chosen.faults[0];
}

}  // namespace
}  // namespace netloft::test
