// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/settings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft {
namespace {

/// Ropes of 100 m, each of two bars of 50 m, and elements whose data have no length.
Scene ropes(const std::vector<double>& wanted) {
  Scene scene;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const std::string name = "warp " + std::to_string(k);
    Part rope{name, "rope/bar", {}, {}, {{"rest_length", {50, 50}}}, {}, false};
    Part companion{name, "rope/bending", {}, {}, {{"rest_length", {100}}}, {}, true};
    scene.parts.push_back(rope), scene.parts.push_back(companion);
    scene.settings.push_back({"length of " + name, name, "rest_length", "m", 0, wanted[k]});
  }
  return scene;
}

/// A model that gives reactions as a function of lengths and counts its calls. Below the length `shortest`
/// there is no equilibrium.
struct Model {
  std::function<std::vector<double>(std::vector<double>)> reactions;
  double shortest = 0;
  int asked = 0;

  Solution find(const Scene& scene) {
    return find_settings(
        scene,
        [&](std::span<const double> factors, const std::vector<double>& start) {
          ++asked;
          SetEquilibrium found;
          EXPECT_EQ(start.empty(), asked == 1) << "every equilibrium is looked for from the one before";
          found.solution.u = {1}, found.solution.cost.work = 1;
          std::vector<double> lengths;
          for (const double factor : factors) lengths.push_back(100 * factor);
          if (lengths[0] < shortest) {
            found.solution.status = SolveStatus::not_converged, found.solution.reason = "it breaks";
            return found;
          }
          found.solution.status = SolveStatus::converged;
          found.reactions = reactions(lengths);
          return found;
        },
        {});
  }
};

TEST(Settings, MultiplyTheDataOfAPartAndOfWhatRidesOnIt) {
  Scene scene = ropes({1, 1});
  set_factors(scene, std::vector{1.5, 1.0});
  set_factors(scene, std::vector{1.2, 1.0});
  EXPECT_DOUBLE_EQ(amount_of(scene, scene.settings[0]), 120);
  EXPECT_DOUBLE_EQ(scene.parts[1].data.at("rest_length")[0], 120);
  EXPECT_DOUBLE_EQ(amount_of(scene, scene.settings[1]), 100);
}

TEST(Settings, FindALengthFarFromWhereTheyBegin) {
  const Scene scene = ropes({8e3});
  Model model{[](auto L) { return std::vector{20 * L[0] + 0.3 * L[0] * L[0]}; }};
  const Solution s = model.find(scene);
  const double exact = (-20 + std::sqrt(400 + 4 * 0.3 * 8e3)) / 0.6;
  ASSERT_EQ(s.status, SolveStatus::converged);
  EXPECT_NEAR(100 * s.factors[0], exact, 1e-8 * exact);
  EXPECT_LT(model.asked, 3 + std::log(exact / 100) / 0.05 + 6) << "steps of 5 %, and few at the end";
  EXPECT_DOUBLE_EQ(s.cost.work, model.asked);
}

TEST(Settings, FindTwoLengthsThatPullAtOneAnother) {
  const Scene scene = ropes({5e3, 7e3});
  Model model{[](auto L) {
    return std::vector{60 * L[0] - 20 * L[1] + 0.1 * L[0] * L[0], 55 * L[1] - 10 * L[0] + 0.2 * L[0] * L[1]};
  }};
  const Solution s = model.find(scene);
  ASSERT_EQ(s.status, SolveStatus::converged);
  const auto found = model.reactions({100 * s.factors[0], 100 * s.factors[1]});
  EXPECT_NEAR(found[0], 5e3, 5e-6);
  EXPECT_NEAR(found[1], 7e3, 7e-6);
}

TEST(Settings, TakeHalfAStepWhereAWholeOneLeadsToNoEquilibrium) {
  const Scene scene = ropes({1000});
  Model model{[](auto L) { return std::vector{2000 * std::sqrt((L[0] - 80) / 20)}; }, 84.9};
  const Solution s = model.find(scene);
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_NEAR(100 * s.factors[0], 85, 1e-6);
}

TEST(Settings, SayWhatCameNearestWhereNoLengthBearsWhatIsWanted) {
  const Scene scene = ropes({900});
  Model model{[](auto L) { return std::vector{1000 + 0.02 * (L[0] - 120) * (L[0] - 120)}; }};
  const Solution s = model.find(scene);
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NEAR(100 * s.factors[0], 120, 2) << "the least there is";
  EXPECT_TRUE(s.reason.starts_with(
      "no length of warp 0 was found at which the tension at its end is 900 N; the nearest tension is 1000"))
      << s.reason;
}

TEST(Settings, SayWhyTheyEndWhereThereIsNoEquilibriumBeyond) {
  const Scene scene = ropes({1000});
  Model model{[](auto L) { return std::vector{20 * L[0]}; }, 95};
  const Solution s = model.find(scene);
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("it breaks"), std::string::npos) << s.reason;
  EXPECT_LT(100 * s.factors[0], 96);
}

/// Finds the length of a hanging wire whose upper end carries `wanted` newtons, its own weight. The wire has
/// 4 bars, each of length `l0` at first.
Solution hang(double l0, double wanted) {
  test::Sketch s;
  std::vector<std::uint32_t> chain{s.node(0, 0, 0, kAllAxes)};
  for (int i = 1; i <= 4; ++i) chain.push_back(s.node(0.3 * i, 0, -l0 * i));
  Part& wire = s.rope("wire", chain, l0, 2e7);
  wire.parameters["rope.diameter"] = 0.02, wire.parameters["rope.density"] = 6000.0;
  s.scene.settings.push_back({"length of wire", "wire", "rest_length", "m", chain[0], wanted});
  test::Solved solved = test::solve(s.scene, {.strategy = "auto"});
  return solved.solution;
}

TEST(Settings, HangAWireAsLongAsTheClosedFormSays) {
  const double per_metre = std::acos(-1.0) / 4 * 0.02 * 0.02 * (6000 - 1025) * 9.81;
  for (const double l0 : {10.0, 40.0}) {
    const Solution s = hang(l0, 1500);
    ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
    EXPECT_NEAR(s.factors.at(0) * 4 * l0 * per_metre / 1500, 1, 1e-9);
    EXPECT_EQ(s.stability, Stability::stable);
  }
}

}  // namespace
}  // namespace netloft
