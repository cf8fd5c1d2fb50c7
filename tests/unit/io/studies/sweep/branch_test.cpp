// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/branch.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"
#include "tests/unit/io/studies/truss.hpp"
#include "tests/verification/solving.hpp"

#include <cmath>
#include <regex>

namespace netloft::studies {
namespace {

using test::kTruss;
using test::load_of;
using test::load_of_fold;
using test::slope_of;

/// A steel wire that a force keeps taut.
constexpr const char* kWire = R"([water]
density = 0
[parts.wire]
type = "rope/bar"
cells = 8
length = 100
sketch = [[0, 0, 0], [60, 0, -80]]
rope = { diameter = "20 mm", EA = 2e7, EA_compression = 0, density = 7800 }
[parts.load]
type = "force/constant"
on = "wire.end"
force = { x = 30000, z = -20000 }
[[hold]]
on = "wire.start"
)";
class BranchTest : public formats::test::Scratch {
 protected:
  void SetUp() override {
    Scratch::SetUp();
    write("s.toml", kTruss);
    variable_.name = "load", variable_.unit = "N", variable_.keys = {{"parts.load.force.z", 1, 0}};
  }
  std::shared_ptr<runs::PreparedScene> opened(const std::vector<VariableValue>& values) {
    auto one = std::make_shared<runs::PreparedScene>(
        runs::CaseSource{folder_ / "s.toml", variable_.overrides(values[0]), 1}, test::shipped_plugins());
    EXPECT_EQ(one->prepare(), runs::PreparedScene::State::ready) << one->diagnostics().render(false);
    return one;
  }
  /// Follows the equilibrium over the loads, and returns the height at each of them.
  std::vector<double> follow(const std::vector<double>& loads) {
    const runs::Watch watch;
    Branch branch(
        {variable_}, [this](const auto& values) { return opened(values); }, watch);
    std::vector<double> heights;
    for (const double load : loads) {
      const std::vector<VariableValue> values{variable_.value_of(load)};
      const auto scene = opened(values);
      const Reached reached = branch.reach(scene, values);
      EXPECT_EQ(reached.solution.status, SolveStatus::converged) << reached.solution.reason;
      heights.push_back(scene->assembler().node_positions(reached.solution.x)[3 * 1 + 2]);
      factorisations_.push_back(reached.solution.cost.statistics.factorisations);
      for (const auto& event : reached.events) events_.push_back(event);
      was_continued_.push_back(reached.was_continued);
    }
    return heights;
  }

  Variable variable_;
  std::vector<std::string> events_;
  std::vector<bool> was_continued_;
  std::vector<int> factorisations_;
};

TEST_F(BranchTest, IsFollowedWithoutEventsWhereItIsSmooth) {
  const std::vector<double> loads{1, -5, -10, -15, -20, -25, -28};
  const auto z = follow(loads);
  for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(load_of(z[i]), loads[i], 1e-6);
  EXPECT_GT(z.back(), 0.11);
  EXPECT_TRUE(events_.empty()) << events_[0];
  EXPECT_EQ(was_continued_, (std::vector<bool>{false, true, true, true, true, true, true}));
}
TEST_F(BranchTest, EndsAtAFoldWhichIsFoundBetweenTheValuesThatEncloseIt) {
  const auto z = follow({1, -10, -20, -28, -32, -36});
  EXPECT_LT(z[4], -0.2) << "snapped through";
  ASSERT_EQ(events_.size(), 1u);
  const std::regex loads("(fold beyond|jump between) load (\\S+) N(?: and load (\\S+) N)?.* truss node 1");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(events_[0], found, loads)) << events_[0];
  const double before = std::stod(found[2]);
  EXPECT_GT(before, load_of_fold()) << events_[0];
  EXPECT_LT(before, load_of_fold() + 4.0 / 32 + 1e-9)
      << "no more than the smallest step of four newtons away";
  if (found[3].matched) {
    EXPECT_LT(std::stod(found[3]), load_of_fold());
  }
}
// The tangent dz/df is 1/f'.
TEST_F(BranchTest, HasTheTangentOfTheClosedForm) {
  constexpr double kLittle = -1e-5;  // [N]
  const auto here = opened({variable_.value_of(-10)}), near = opened({variable_.value_of(-10 + kLittle)});
  const Solution at = runs::find_equilibrium(*here);
  runs::Tangent from(*here, at.x);
  const auto tangent = from.towards(*near);
  ASSERT_TRUE(tangent);
  EXPECT_EQ(from.spent().factorisations, 1);
  const double z = here->assembler().node_positions(at.x)[3 * 1 + 2];
  EXPECT_NEAR(here->assembler().node_positions(*tangent)[3 * 1 + 2] / kLittle * slope_of(z), 1, 1e-5);
}
// A longer wire between the old positions of its ends is slack, and nothing holds its free end. The tangent
// moves this end outwards as the length grows. Without the tangent, steps would be halved until the wire
// stays taut, with ten times as many factorisations.
TEST_F(BranchTest, LeadsAlongTheTangentWhereTheNextPointIsOnNoLine) {
  write("s.toml", kWire);
  variable_.name = "length", variable_.unit = "", variable_.keys = {{"parts.wire.length", 1, 0}};
  follow({100, 130, 100, 160});
  EXPECT_TRUE(events_.empty()) << events_[0];
  EXPECT_EQ(was_continued_, (std::vector<bool>{false, true, true, true}));
  for (const std::size_t i : {1u, 2u, 3u}) EXPECT_LE(factorisations_[i], 6) << i;
}
TEST_F(BranchTest, StaysOnTheOtherSideOnTheWayBack) {
  const auto z = follow({-40, -20, -1, 20});
  EXPECT_TRUE(events_.empty());
  for (const double height : z) EXPECT_LT(height, -0.1);
  EXPECT_NEAR(load_of(z[3]), 20, 1e-6);
}

}  // namespace
}  // namespace netloft::studies
