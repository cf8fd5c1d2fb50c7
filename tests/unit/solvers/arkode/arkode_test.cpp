// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framework/conformance/practice_motion.hpp"
#include "io/analysis/case.hpp"
#include "tests/unit/framework/problem/oscillator.hpp"

namespace netloft::test {
namespace {

struct Method {
  const char* name;
  double order;
};
void PrintTo(const Method& method, std::ostream* out) { *out << method.name; }

const Method kMethods[] = {{"tr-bdf2", 2}, {"esdirk3", 3}, {"kvaerno4", 4}};

Values called(const Method& method) { return {{"method", std::string(method.name)}}; }

class ArkodeMethod : public testing::TestWithParam<Method> {
 protected:
  const Chosen chosen_{"arkode", called(GetParam())};

  /// A practice motion, whose answer is known, after `n` steps that lead to `end` [s].
  conformance::PracticeMotion after(int n, double end, const conformance::PracticeSwing& like) const {
    conformance::PracticeMotion motion(like);
    EXPECT_EQ(motion.run(chosen_.type.integrator, chosen_.block.data(), {end / n}, end), NETLOFT_OK);
    return motion;
  }
};

TEST_P(ArkodeMethod, HasItsOrderInAMotionWithDamping) {
  const conformance::PracticeSwing damped{.damping = 0.2};
  const double coarse = after(160, 4, damped).error(), fine = after(320, 4, damped).error();
  EXPECT_NEAR(std::log2(coarse / fine), GetParam().order, 0.15) << coarse << " " << fine;
}

TEST_P(ArkodeMethod, EstimatesErrorsThatShrinkAsItSays) {
  const double coarse = after(10, 0.5, {}).estimate, fine = after(20, 0.5, {}).estimate;
  const double said = chosen_.type.integrator.order(chosen_.block.data());
  EXPECT_NEAR(std::log2(coarse / fine), said, 0.2) << coarse << " " << fine;
}

TEST_P(ArkodeMethod, EndsWhatIsFarTooFastForTheStep) { EXPECT_LT(after(100, 1e5, {}).energy(), 1e-6); }

// F(t, u, v, a) = 0 at the end of every step, of a motion with a damping of 0.2 and 1 to 2 rad/s.
TEST_P(ArkodeMethod, LeavesTheAccelerationThatBelongsToPositionAndVelocity) {
  const auto motion = after(7, 1, {.damping = 0.2});
  for (std::size_t i = 0; i < motion.u.size(); ++i) {
    const double w = 1 + 0.5 * static_cast<double>(i);
    EXPECT_NEAR(motion.a[i], -2 * 0.2 * w * motion.v[i] - w * w * motion.u[i], 1e-12);
  }
}

TEST(Arkode, MovesASpringAsItsClosedFormSays) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s;
  s.duration = 20 / o.omega(), s.step = 0.02 / o.omega(), s.adaptive = false;
  MarchState from = state_at_rest(m.assembler);
  from.u[0] = 0.1;
  const MarchResult r = m.run("arkode", {}, s, &from);
  ASSERT_EQ(r.status, MarchStatus::finished) << r.reason;
  EXPECT_NEAR(r.u[0], 0.1 * std::cos(o.omega() * s.duration), 1e-6);
}

/// Where a scene of the gear library is at its end.
MarchResult end_of(const std::string& scene, const std::vector<std::string>& overrides) {
  io::Case c({NETLOFT_SOURCE_DIR "/gear-library/scenes/dynamics/" + scene, overrides, 1}, shipped_plugins());
  if (c.open() != io::Case::State::ready) throw std::invalid_argument(c.diagnostics().render(false));
  MarchResult r = c.march({});
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  return r;
}

/// Of four bars as stiff in compression as in tension, and a ball, after 0.5 s.
MarchResult swing(const std::vector<std::string>& overrides) {
  std::vector<std::string> all = {"parts.rope.rope.EA=2000", "parts.rope.rope.EA_compression=2000",
                                  "analysis.duration=0.5",   "analysis.output_interval=0",
                                  "analysis.solver=chord",   "analysis.tolerance=1e-11"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return end_of("elastic-pendulum.toml", all);
}

double largest_distance(const MarchResult& a, const MarchResult& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.u.size(); ++i) most = std::max(most, std::abs(a.u[i] - b.u[i]));
  return most;
}

TEST(Arkode, SwingsThePendulumAsGeneralizedAlphaDoes) {
  const auto alpha = [](const char* step) {
    return swing({"analysis.integrator=generalized-alpha", "analysis.adaptive=false", step});
  };
  const MarchResult fine = alpha("analysis.step=5e-5");
  const double its_own = largest_distance(alpha("analysis.step=1e-4"), fine);
  const MarchResult arkode =
      swing({"analysis.integrator=arkode", "analysis.adaptive=false", "analysis.step=5e-4"});
  EXPECT_LT(largest_distance(arkode, fine), its_own);
}

// Steel that could ring at 38 000 rad/s: with other methods of ARKODE it takes thousands of steps.
TEST_P(ArkodeMethod, TakesLongStepsWithStiffBars) {
  const auto bars = [](const std::string& integrator, const std::string& accuracy) {
    return end_of(
        "pendulum-of-bars.toml",
        {"analysis.duration=1", "analysis.output_interval=0", "analysis.accuracy=" + accuracy,
         "analysis.integrator=" + integrator, "analysis.arkode.method=" + std::string(GetParam().name)});
  };
  const MarchResult r = bars("arkode", "1e-3");
  EXPECT_LT(r.steps + r.rejected, 100);
  EXPECT_LT(largest_distance(r, bars("generalized-alpha", "1e-5")), 5e-3);  // [m] of 1 m
}

TEST(Arkode, LetsTheHostChooseTheSteps) {
  const MarchResult fine =
      swing({"analysis.integrator=arkode", "analysis.adaptive=false", "analysis.step=2e-4"});
  double before = 1;
  for (const char* accuracy : {"analysis.accuracy=1e-3", "analysis.accuracy=1e-5"}) {
    const MarchResult r = swing({"analysis.integrator=arkode", accuracy});
    EXPECT_LT(largest_distance(r, fine), 0.2 * before);
    before = largest_distance(r, fine);
  }
}

TEST(Arkode, TakesShorterStepsWhereAStageIsNotFound) {
  const Chosen chosen("arkode", {});
  conformance::PracticeMotion motion({.fails = NETLOFT_OUTSIDE_DOMAIN});
  EXPECT_EQ(motion.run(chosen.type.integrator, chosen.block.data(), {0.01}, 0.01), NETLOFT_OUTSIDE_DOMAIN);
}

TEST(Arkode, RefusesAMethodThatItDoesNotHave) {
  const Chosen chosen("arkode", {{"method", std::string("euler")}});
  ASSERT_EQ(chosen.faults.size(), 1u);
  EXPECT_NE(chosen.faults[0].find("tr-bdf2"), std::string::npos) << chosen.faults[0];
}

INSTANTIATE_TEST_SUITE_P(Each, ArkodeMethod, testing::ValuesIn(kMethods), [](const auto& tested) {
  std::string name = tested.param.name;
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace netloft::test
