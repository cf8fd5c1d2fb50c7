// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/other_integrators.hpp"

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
};

TEST_P(ArkodeMethod, HasItsOrderInAMotionWithDamping) {
  EXPECT_NEAR(order_in_a_motion_with_damping(chosen_), GetParam().order, 0.15);
}

TEST_P(ArkodeMethod, EstimatesErrorsThatShrinkAsItSays) {
  EXPECT_NEAR(order_of_estimates(chosen_), chosen_.type.integrator.order(chosen_.block.data()), 0.2);
}

TEST_P(ArkodeMethod, EndsWhatIsFarTooFastForTheStep) {
  EXPECT_LT(after(chosen_, 100, 1e5, {}).energy(), 1e-6);
}

// The motion has a damping of 0.2 and frequencies of 1 to 2 rad/s; F(t, u, v, a) = 0 must hold at the end.
TEST_P(ArkodeMethod, LeavesTheAccelerationThatBelongsToPositionAndVelocity) {
  const auto motion = after(chosen_, 7, 1, {.damping = 0.2});
  for (std::size_t i = 0; i < motion.u.size(); ++i) {
    const double w = 1 + 0.5 * static_cast<double>(i);
    EXPECT_NEAR(motion.a[i], -2 * 0.2 * w * motion.v[i] - w * w * motion.u[i], 1e-12);
  }
}

TEST(Arkode, MovesASpringAsItsClosedFormSays) {
  EXPECT_LT(distance_from_closed_form_of_a_spring("arkode"), 1e-6);
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

// The steel bars can oscillate at 38 000 rad/s: other methods of ARKODE take thousands of steps.
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
  EXPECT_EQ(step_where_the_host_answers(NETLOFT_OUTSIDE_DOMAIN, {"arkode", {}}), NETLOFT_OUTSIDE_DOMAIN);
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
