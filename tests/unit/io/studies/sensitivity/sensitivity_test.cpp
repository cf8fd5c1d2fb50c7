// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/unit/io/studies/sensitivity/at_rest.hpp"

namespace netloft::studies {
namespace {

using test::AtRest;

std::size_t place_of(const Sensitivities& found, const std::string& figure) {
  for (std::size_t f = 0; f < found.figures.size(); ++f)
    if (found.figures[f].name == figure) return f;
  throw std::invalid_argument(figure);
}

double derivative(const Sensitivities& found, const std::string& figure, const std::string& path) {
  for (const NumberEffect& effect : found.effects)
    if (effect.number.path == path && effect.why_not.empty()) return effect.per_unit[place_of(found, figure)];
  throw std::invalid_argument(path);
}

// The exact horizontal tension H of the scene's elastic catenary, of weight w per metre (Irvine, Cable
// Structures, MIT Press 1981, eq. 2.24), with a = wL/2H:
//   F(H, EA, L) = HL/EA + (2H/w) asinh a = 8 m
TEST(Sensitivity, IsThatOfTheElasticCatenary) {
  AtRest rope("hanging-rope.toml", {"parts.rope.rope.sag=1", "analysis.tolerance=1e-12"});
  const Sensitivities found = rope.to({"parts.rope.length", "parts.rope.rope.EA"});
  const double H = 2.99708988, EA = 100, L = 10, w = 1, a = w * L / (2 * H), root = std::sqrt(1 + a * a);
  const double by_H = L / EA + 2 / w * std::asinh(a) - L / (H * root), by_EA = -H * L / (EA * EA),
               by_L = H / EA + 1 / root;
  // The tension acts on the hold at the end of the rope along −x.
  EXPECT_NEAR(std::abs(derivative(found, "horizontal_tension", "parts.rope.rope.EA")), std::abs(by_EA / by_H),
              1e-8);
  EXPECT_NEAR(std::abs(derivative(found, "horizontal_tension", "parts.rope.length")), std::abs(by_L / by_H),
              1e-7);
}

// The forces of a rope in air grow in proportion if its stiffness and its density grow in the same
// proportion. By Euler's theorem, tensions are homogeneous functions of the two of degree 1, and positions of
// degree 0.
TEST(Sensitivity, ObeysTheScalingOfForces) {
  AtRest rope("hanging-rope.toml", {"analysis.tolerance=1e-12"});
  const Sensitivities found = rope.to({"parts.rope.rope"});
  const auto scaled = [&](const std::string& figure) {
    return 100 * derivative(found, figure, "parts.rope.rope.EA") +
           324.58575169277043 * derivative(found, figure, "parts.rope.rope.density");
  };
  // A tension is rounded by 2.2e-16 EA; over a step of 2e-6 of EA, that is 1.1e-8 N of EA dT/dEA. Two
  // tensions are rounded for each of two derivatives.
  constexpr double kRounding = 4 * 1.1e-8;
  EXPECT_NEAR(scaled("end_tension"), rope.figure("end_tension"), kRounding);
  EXPECT_NEAR(scaled("horizontal_tension"), rope.figure("horizontal_tension"), kRounding);
  EXPECT_NEAR(scaled("sag_z"), 0, 1e-12);
}

// Derivatives with respect to numbers of the flow, of a law and of a moving hold, compared with
// central differences of equilibria.
TEST(Sensitivity, IsTheChangeOfEquilibriaOfATrawl) {
  const std::vector<std::string> coarse{"gear.nodes=300", "analysis.tolerance=1e-10"};
  AtRest trawl("83-112-flume-3.0kn.toml", coarse);
  const Sensitivities found =
      trawl.to({"tow.speed", "elements.netting.drag.measured_at", "points.towing-point.at[1]"});
  ASSERT_EQ(found.effects.size(), 3u);
  for (const NumberEffect& effect : found.effects) {
    const double h = 1e-4 * std::abs(effect.number.value);
    const auto beside = [&](double p) {
      auto changes = coarse;
      changes.push_back(effect.number.to(p).front().text);
      return AtRest("83-112-flume-3.0kn.toml", changes);
    };
    AtRest above = beside(effect.number.value + h), below = beside(effect.number.value - h);
    for (const char* figure : {"mouth/headline_height", "mouth/lower_wing_spread", "drag/all/x"}) {
      const double expected = (above.figure(figure) - below.figure(figure)) / (2 * h);
      EXPECT_NEAR(effect.per_unit[place_of(found, figure)], expected, 2e-4 * std::abs(expected))
          << effect.number.path << ", " << figure;
    }
  }
}

// Derivatives with respect to counts, mesh sizes, take-ups and lengths of the net plan, compared with central
// differences of equilibria on the same mesh topology.
TEST(Sensitivity, IsTheChangeOfEquilibriaForNumbersOfThePlan) {
  AtRest trawl("83-112-flume-3.0kn.toml", {"gear.nodes=300", "analysis.tolerance=1e-11"});
  const Sensitivities found = trawl.to({"panels.top-wing.depth", "panels.bottom-body.fore[0].meshes",
                                        "panels.top-body.aft", "hang[1].length", "ropes.footrope.length"});
  ASSERT_EQ(found.effects.size(), 5u);
  for (const NumberEffect& effect : found.effects) {
    ASSERT_EQ(effect.why_not, "") << effect.number.path;
    const double h = 1e-5 * effect.number.value;
    const auto figures_at = [&](double p) {
      runs::CaseSource source = trawl.scene.source();
      formats::append(source.changes, effect.number.to(p));
      runs::PreparedScene beside(std::move(source), test::shipped_plugins());
      EXPECT_EQ(beside.prepare_like(trawl.scene), runs::PreparedScene::State::ready);
      const Solution s =
          runs::continue_equilibrium(beside, beside.assembler().displacements_to(trawl.solution.x), 50);
      EXPECT_EQ(s.status, SolveStatus::converged) << effect.number.path << ": " << s.reason;
      return all_figures(results::make_result(beside.loaded(), beside.assembler(), s));
    };
    const auto above = figures_at(effect.number.value + h), below = figures_at(effect.number.value - h);
    for (const char* figure : {"mouth/headline_height", "mouth/lower_wing_spread", "drag/all/x"}) {
      const std::size_t f = place_of(found, figure);
      const double expected = (above[f].value - below[f].value) / (2 * h);
      EXPECT_NEAR(effect.per_unit[f], expected, 1e-4 * std::abs(expected) + 1e-7)
          << effect.number.path << ", " << figure;
    }
  }
}

TEST(Sensitivity, HasNoDerivativesForCells) {
  AtRest rope("hanging-rope.toml", {});
  for (const NumberEffect& effect : rope.to({"parts.rope"}).effects) {
    const bool is_count = effect.number.path == "parts.rope.cells";
    EXPECT_EQ(!effect.why_not.empty(), is_count) << effect.number.path << ": " << effect.why_not;
  }
}

// The density of the water cannot be below zero. If the rope hangs in air, water of a low density reduces its
// weight by the buoyancy, as a lower density of the rope would.
TEST(Sensitivity, LooksToOneSideAtAnEndOfARange) {
  AtRest rope("hanging-rope.toml", {"analysis.tolerance=1e-12"});
  const Sensitivities found = rope.to({"water.density", "parts.rope.rope.density"});
  for (const char* figure : {"end_tension", "horizontal_tension"})
    EXPECT_NEAR(derivative(found, figure, "water.density"),
                -derivative(found, figure, "parts.rope.rope.density"), 1e-7);
}

// A rope that is straight between its holds is about to become slack: a shorter rope is taut, a longer rope
// slack.
TEST(Sensitivity, MarksAMemberThatIsAboutToBecomeSlack) {
  const std::vector<std::string> straight{"parts.rope.cells=4", "water.gravity=0",
                                          "parts.rope.sketch=[[-4, 0, 0], [4, 0, 0]]"};
  const auto marks = [&](const std::string& length) {
    auto changes = straight;
    changes.push_back("parts.rope.length=" + length);
    AtRest rope("hanging-rope.toml", changes);
    const Sensitivities found = rope.to({"parts.rope.length"}, true);
    return depends_on_step(found, found.effects.at(0), place_of(found, "horizontal_tension"));
  };
  EXPECT_FALSE(marks("7.5"));
  EXPECT_TRUE(marks("7.9999"));
}

TEST(SceneNumbers, AreThoseOfTheTablesThatSayWhatTheSceneIs) {
  AtRest rope("hanging-rope.toml", {"analysis.tolerance=1e-8"});
  const auto numbers = rope.numbers({});
  const auto has = [&](const std::string& path) {
    return std::ranges::any_of(numbers, [&](const SceneNumber& n) { return n.path == path; });
  };
  EXPECT_TRUE(has("parts.rope.length") && has("water.density") && has("parts.rope.sketch[1][2]"));
  EXPECT_FALSE(has("analysis.tolerance"));
  EXPECT_EQ(rope.numbers({"parts.rope.length"}).at(0).unit, "m");
  EXPECT_EQ(rope.numbers({"parts.rope.sketch[1]"}).size(), 3u);
  EXPECT_EQ(rope.numbers({"parts.rope.length"}).at(0).to(10.5).front().text, "parts.rope.length=\"10.5 m\"");
}

// The twine of a panel is one of the catalogue, named by the plan.
TEST(SceneNumbers, OfAPartIncludeThoseOfTheCatalogue) {
  AtRest trawl("83-112-flume-3.0kn.toml", {"gear.nodes=300", "analysis.tolerance=1e-10"});
  EXPECT_GT(trawl.numbers({"elements.headrope"}).size(), 2u);
  EXPECT_EQ(trawl.numbers({"elements.top-wing.twine.diameter"}).at(0).unit, "m");
  const Sensitivities found = trawl.to({"elements.top-wing.twine.diameter"});
  EXPECT_EQ(found.effects.at(0).why_not, "");
  EXPECT_GT(std::abs(derivative(found, "drag/all/x", "elements.top-wing.twine.diameter")), 1e4);
}

// The variance is the sum of the squared effects of two deviations, one of them in per cent.
TEST(Sensitivity, PropagatesStandardDeviations) {
  AtRest rope("hanging-rope.toml", {"analysis.tolerance=1e-12"});
  const Sensitivities found = rope.to({"parts.rope.length=2 cm", "parts.rope.rope.EA=10%", "water.density"});
  const std::size_t f = place_of(found, "end_tension");
  const double by_length = 0.02 * derivative(found, "end_tension", "parts.rope.length"),
               by_EA = 10 * derivative(found, "end_tension", "parts.rope.rope.EA");
  EXPECT_NEAR(propagated_deviation(found, f), std::hypot(by_length, by_EA), 1e-12);
  EXPECT_EQ(propagated_deviation(rope.to({"parts.rope.length"}), f), 0);
  for (const char* wrong : {"parts.rope.length=2 kg", "parts.rope.length=", "parts.rope.length=-1 cm"})
    EXPECT_THROW(rope.numbers({wrong}), std::invalid_argument) << wrong;
}

TEST(SceneNumbers, AreNamedIfAPathIsWrong) {
  AtRest rope("hanging-rope.toml", {});
  try {
    rope.numbers({"parts.rope.lenght"});
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean \"parts.rope.length\"?"), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace netloft::studies
