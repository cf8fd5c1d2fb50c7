// SPDX-License-Identifier: BSD-3-Clause
//
// A fold, and members or nodes that switch, end the validity of a derivative.
#include "io/studies/sensitivity/sensitivity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/formats/hdf5/read.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"
#include "tests/unit/io/studies/truss.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::studies {
namespace {

using test::height_at;
using test::kTruss;
using test::load_of_fold;
using test::slope_of;

/// A rope of 1 N/m that is stretched between two holds that are 8 m apart.
constexpr const char* kStraight = R"([water]
gravity = 0
[parts.rope]
type = "rope/bar"
cells = 4
length = "7.5 m"
sketch = [[-4, 0, 0], [4, 0, 0]]
rope = { diameter = "10 mm", EA = 100, density = 1000 }
[[hold]]
on = ["rope.start", "rope.end"]
[results]
tension = { of = "rope", take = "max tension" }
)";

/// A rope of 10 m that hangs straight over a plane bed.
constexpr const char* kOverBed = R"([parts.rope]
type = "rope/bar"
cells = 2
length = "10 m"
sketch = [[0, 0, 0], [0, 0, -10]]
rope = { diameter = "20 mm", EA = "10 kN", density = 2000 }
[parts.bed]
type = "seabed/plane"
on = "rope"
seabed = { depth = "12 m" }
[[hold]]
on = "rope.start"
[results]
tension = { of = "rope", take = "max tension" }
)";

/// A weight on a wire whose strain is a tenth of the step of the derivatives.
constexpr const char* kStiffWire = R"([water]
density = 0
[parts.wire]
type = "rope/bar"
cells = 1
length = 10
sketch = [[0, 0, 0], [0, 0, -10]]
rope = { diameter = "20 mm", EA = 1e9, density = 1e-6 }
[parts.weight]
type = "force/constant"
on = "wire.end"
force = { z = -100 }
[[hold]]
on = "wire.start"
[results]
z = { of = "wire.end", take = "z" }
)";

class ReachOfDerivatives : public formats::test::Scratch {
 protected:
  struct Found : Sensitivities {
    double z = 0;  // of the third node
  };
  /// The solver continues from the sketch, which is near the equilibrium; strategies may find another
  /// equilibrium beyond the fold.
  static constexpr int kIterations = 200;
  Found find(const char* scene, const std::vector<std::string>& changes, const std::string& number) {
    runs::PreparedScene one({write("s.toml", scene), changes, 1}, test::shipped_plugins());
    EXPECT_EQ(one.prepare(), runs::PreparedScene::State::ready) << one.diagnostics().render(false);
    const Solution solution = runs::continue_equilibrium(
        one, one.assembler().displacements_to(one.assembler().start()), kIterations);
    EXPECT_EQ(solution.status, SolveStatus::converged) << solution.reason;
    const auto result = results::make_result(one.loaded(), one.assembler(), solution);
    Found found{find_sensitivities(
        one, solution,
        {.figures = all_figures(result), .numbers = chosen_numbers(one, {number}), .with_reach = true})};
    found.z = found.figures.at(0).value;
    return found;
  }
  NumberEffect effect_of(const char* scene, const std::vector<std::string>& changes,
                         const std::string& number) {
    return find(scene, changes, number).effects.at(0);
  }
  /// The truss under a load that is smaller than the load at its fold by the fraction `distance`.
  Found truss_at(double distance, const std::string& deviation = "") {
    const double load = (1 - distance) * load_of_fold();
    const Found found =
        find(kTruss,
             {fmt::format("parts.load.force.z={:.17g}", load),
              fmt::format("parts.truss.sketch[1][2]={:.17g}", height_at(load)), "analysis.tolerance=1e-12"},
             "parts.load.force.z" + deviation);
    EXPECT_NEAR(found.z, height_at(load), 1e-6) << "has not snapped through";
    return found;
  }
};

TEST_F(ReachOfDerivatives, OfATrussIsThatOfItsClosedFormUpToTheFold) {
  for (const double distance : {0.9, 0.1, 0.02}) {
    const Found found = truss_at(distance);
    ASSERT_EQ(found.effects.at(0).why_not, "") << distance;
    EXPECT_NEAR(found.effects[0].per_unit.at(0) * slope_of(found.z), 1, 1e-5) << distance;
  }
}

TEST_F(ReachOfDerivatives, GrowAsTheRootOfTheDistanceToAFold) {
  const std::string little = "=1e-6";  // a deviation that reaches no fold
  const double far = truss_at(4e-4, little).effects.at(0).per_unit.at(0),
               near = truss_at(1e-4, little).effects.at(0).per_unit.at(0);
  EXPECT_NEAR(near / far, 2, 0.02);
}

TEST_F(ReachOfDerivatives, EndsAtAFoldWithinOnePercent) {
  for (const double distance : {0.009, 1e-3}) {
    const NumberEffect effect = truss_at(distance).effects.at(0);
    EXPECT_TRUE(effect.per_unit.empty());
    EXPECT_NE(effect.why_not.find("ends in a fold near"), std::string::npos) << effect.why_not;
    EXPECT_NEAR(effect.fold_at / load_of_fold(), 1, 0.1 * distance);
  }
}

TEST_F(ReachOfDerivatives, EndsAtAFoldWithinADeviation) {
  const std::string load = std::to_string(0.1 * std::abs(load_of_fold()));
  EXPECT_EQ(truss_at(0.2, "=" + load).effects.at(0).why_not, "");
  EXPECT_NE(truss_at(0.08, "=" + load).effects.at(0).why_not, "");
}

// A wire that is longer by a millionth would be slack at the present position of the weight.
TEST_F(ReachOfDerivatives, IncludesAWireThatMovesInOrderToStayTaut) {
  const NumberEffect effect = effect_of(kStiffWire, {}, "parts.wire.length");
  ASSERT_EQ(effect.why_not, "");
  EXPECT_NEAR(effect.per_unit.at(0), -(1 + 100 / 1e9), 1e-8);
  EXPECT_FALSE(effect.switches.any());
}

// With the strain e = 8 m/L − 1, de/dL = −8 m/L²: to first order, the rope is slack when L has grown by
// L (8 m − L)/8 m, which is 0.469 m.
TEST_F(ReachOfDerivatives, EndsWhereAStraightRopeBecomesSlack) {
  const std::map<std::string, std::size_t> all{{"rope", 4}};
  EXPECT_FALSE(effect_of(kStraight, {}, "parts.rope.length").switches.any());
  EXPECT_FALSE(effect_of(kStraight, {}, "parts.rope.length=0.465 m").switches.any());
  EXPECT_EQ(effect_of(kStraight, {}, "parts.rope.length=0.473 m").switches.members, all);
  EXPECT_EQ(effect_of(kStraight, {"parts.rope.length=7.9999 m"}, "parts.rope.length").switches.members, all);
  EXPECT_FALSE(effect_of(kStraight, {}, "parts.rope.rope.EA=50").switches.any()) << "stays as long";
}

TEST_F(ReachOfDerivatives, EndsWhereANodeTouchesTheBed) {
  const double weight = 1.5707963e-4 * (2000 - 1025) * 9.81 * 2;  // per two metres, roughly
  ASSERT_LT(weight * 50 / 1e4, 0.02) << "the rope stretches by less than 2 cm";
  const std::map<std::string, std::size_t> end{{"rope", 1}};
  EXPECT_FALSE(effect_of(kOverBed, {}, "parts.bed.seabed.depth=1.97 m").switches.any());
  EXPECT_EQ(effect_of(kOverBed, {}, "parts.bed.seabed.depth=2.01 m").switches.nodes, end);
  EXPECT_EQ(effect_of(kOverBed, {}, "parts.rope.length=2.01 m").switches.nodes, end);
  EXPECT_FALSE(effect_of(kOverBed, {}, "parts.rope.length=1.95 m").switches.any());
}

TEST_F(ReachOfDerivatives, IsThatOfTheSideOnWhichEverythingIs) {
  const SwitchSides hanging = find(kOverBed, {}, "parts.rope.length").sides;
  EXPECT_EQ(hanging.members, 2u);
  EXPECT_EQ(hanging.slack, 0u);
  EXPECT_EQ(hanging.nodes, 3u);
  EXPECT_EQ(hanging.touching, 0u);
  const std::string number = "parts.bed.seabed.depth=0.5 m";
  const Found lying = find(
      kOverBed,
      {"parts.rope.sketch=[[0, 0, 0], [4, 0, -2], [8, 0, 0]]", "hold[0].on=[\"rope.start\", \"rope.end\"]",
       "parts.rope.cells=4", "parts.bed.seabed.depth=2.7 m"},
      number);
  EXPECT_EQ(lying.sides.touching, 1u);
  EXPECT_EQ(lying.effects.at(0).switches.nodes, (std::map<std::string, std::size_t>{{"rope", 1}}));
  const std::string text = sensitivity_text(lying, {});
  EXPECT_NE(text.find("0 of 4 bars and twines are slack, 1 of 5 nodes touch the ground"), std::string::npos)
      << text;
  EXPECT_NE(text.find("nodes: 1, 20 % (rope 1)"), std::string::npos) << text;
}

TEST_F(ReachOfDerivatives, IsInATable) {
  const Found found = find(kOverBed, {}, "parts.rope.length=2.01 m");
  const auto path = write("table.hdf", sensitivity_hdf(found, {0}, "converged"));
  const auto table = formats::Reader::of_own(path);
  const std::string at = "/netloft/sensitivities/";
  EXPECT_EQ(table.strings(at + "figures/name"), std::vector<std::string>{"tension"});
  EXPECT_EQ(table.strings(at + "numbers/path"), std::vector<std::string>{"parts.rope.length"});
  EXPECT_EQ(table.reals(at + "derivatives"), std::vector<double>{found.effects.at(0).per_unit.at(0)});
  EXPECT_EQ(table.shape(at + "derivatives"), (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(table.reals(at + "numbers/deviation"), std::vector<double>{2.01});
  EXPECT_EQ(table.integers(at + "numbers/switching_nodes"), std::vector<std::int64_t>{1});
  EXPECT_EQ(table.integer(at + "frozen/ground_nodes"), 3);
}

}  // namespace
}  // namespace netloft::studies
