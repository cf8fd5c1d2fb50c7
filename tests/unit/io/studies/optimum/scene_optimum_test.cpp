// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/optimum/scene_optimum.hpp"

#include <fstream>

#include "io/runs/equilibrium.hpp"
#include "io/studies/sweep/path_run.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::studies {
namespace {

/// The elastic catenary of the library, whose length is sought. The variable begins on line 3, the objective
/// on line 7, the constraint on line 10.
const std::string kRope = "scene = \"" + test::source_folder() + R"(/gear-library/scenes/hanging-rope.toml"
set = ["parts.rope.rope.sag=1", "analysis.tolerance=1e-10"]
[variables.length]
key = "parts.rope.length"
range = ["8.5 m", "12 m"]
start = "11 m"
[objective]
minimise = "results/end_tension"
unit = "mN"
[[constraints]]
figure = "results/sag_z"
at_least = "-200 cm"
)";

class SceneOptimumTest : public formats::test::Scratch {
 protected:
  static std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  }
  OptimumFile open(const std::string& text) {
    diagnostics_ = {};
    const OptimumFile file = read_optimum_file(write("o.toml", text), diagnostics_);
    checked_ = check_optimum(file, folder_, test::shipped_plugins(), diagnostics_);
    return file;
  }
  /// All errors as "line:column: message", one per line.
  std::string errors_of(const std::string& text) {
    open(text);
    std::string all;
    for (const auto& d : diagnostics_.sorted())
      if (d.severity == formats::Severity::error)
        all += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": " + d.message +
               (d.hint.empty() ? "" : " (" + d.hint + ")") + "\n";
    return all;
  }
  SceneOptimum optimise(const std::string& text, int interrupt_after = 1000) {
    const OptimumFile file = open(text);
    EXPECT_EQ(errors(), "");
    PointHistory history(folder_ / "history.jsonl", checked_.inputs);
    std::atomic<bool> interrupt = false;
    int points = 0;
    return optimise_scene(file, checked_, folder_, test::shipped_plugins(), history,
                          {.interrupt = &interrupt},
                          [&](const OptimumPoint&) { interrupt = ++points >= interrupt_after; });
  }

  CheckedOptimum checked_;
};

// The elastic catenary of weight w = 1 N/m, span 8 m and EA = 100 N (Irvine, Cable Structures, MIT Press
// 1981, eq. 2.21 to 2.27): the tension at its ends, √(H² + (wL/2)²), with H from 8 m = HL/EA + (2H/w)
// asinh(wL/2H), is least at L = 9.605983862 m (golden section of these formulas).
TEST_F(SceneOptimumTest, FindsTheLengthWithTheLeastTension) {
  const SceneOptimum done = optimise(kRope.substr(0, kRope.find("[[constraints]]")));
  ASSERT_EQ(done.status(), "optimal") << done.trouble;
  EXPECT_NEAR(done.found.best.predictions[0], 5.800736845, 1e-7);
  EXPECT_NEAR(done.found.best.parameters[0], 9.605983862, 1e-4);
  EXPECT_LE(done.solves, 10);
}

// The sag of 2 m is reached at L = 8.783713866 m; by the same formulas, the derivative of the tension with
// respect to the sag is 0.764646125 at this length. The start sags too much.
TEST_F(SceneOptimumTest, FindsThePriceOfASag) {
  const SceneOptimum done = optimise(kRope);
  ASSERT_EQ(done.status(), "optimal") << done.trouble;
  EXPECT_GT(done.found.history.front().violation, 0.8);
  EXPECT_NEAR(done.found.best.parameters[0], 8.783713866, 1e-6);
  EXPECT_NEAR(done.found.best.predictions[0], 6.018188224, 1e-6);
  EXPECT_NEAR(done.found.constraint_prices[0], 0.764646125, 1e-5);
  EXPECT_LE(done.found.best.remainder, 1e-6);
  const std::string text = optimum_text(done);
  EXPECT_NE(text.find("results/sag_z                                   -200 cm         +7.646 mN per cm"),
            std::string::npos)
      << text;
}

// The optimum is nearest to 8.8 m, a multiple of 0.1 m at which the rope sags too much.
TEST_F(SceneOptimumTest, RoundsToMultiplesThatSatisfyTheConstraints) {
  const SceneOptimum done = optimise(replaced(kRope, "start =", "step = \"10 cm\"\nstart ="));
  ASSERT_EQ(done.status(), "optimal") << done.found.reason;
  EXPECT_EQ(done.found.best.parameters[0], 8.7);
  EXPECT_GT(done.found.best.predictions[0], 6.0182);
  ASSERT_TRUE(done.unrounded);
  EXPECT_NEAR(*done.unrounded, 6.018188224, 1e-6);
  EXPECT_NE(optimum_text(done).find("6018.2 mN before variables were rounded"), std::string::npos)
      << optimum_text(done);
  EXPECT_EQ(
      errors_of(replaced(kRope, "start =", "step = \"15 m\"\nstart =")),
      "6:8: variables.length.step: must be above zero, and the range must contain a whole multiple of it\n");
}

TEST_F(SceneOptimumTest, WritesAScene) {
  const SceneOptimum done = optimise(kRope);
  const auto path = write("best.toml", scene_text(done, folder_, folder_));
  runs::PreparedScene scene({path, {}, 1}, test::shipped_plugins());
  ASSERT_EQ(scene.prepare(), runs::PreparedScene::State::ready) << scene.diagnostics().render(false);
  const auto figures = figures_of(scene, runs::find_equilibrium(scene));
  EXPECT_EQ(figures[0].name, "results/sag_z");
  EXPECT_NEAR(figures[0].value, -2, 1e-6);
}

TEST_F(SceneOptimumTest, GoesOnWhereItWasInterrupted) {
  const SceneOptimum whole = optimise(kRope);
  std::filesystem::remove(folder_ / "history.jsonl");
  const SceneOptimum first = optimise(kRope, 3);
  EXPECT_EQ(first.status(), "interrupted");
  std::ofstream(folder_ / "history.jsonl", std::ios::app) << "{\"inputs\": \"half of a li";  // damaged
  const SceneOptimum second = optimise(kRope);
  EXPECT_EQ(second.status(), "optimal");
  EXPECT_EQ(second.found.history.size(), whole.found.history.size());
  EXPECT_EQ(second.solves, whole.solves - 3 + 1);  // the last accepted point is solved again
  EXPECT_NEAR(second.found.best.parameters[0], whole.found.best.parameters[0], 1e-8);
  EXPECT_EQ(optimise(kRope).solves, 0);
  EXPECT_EQ(optimise(replaced(kRope, "-200 cm", "-210 cm")).found.history.front().predictions,
            whole.found.history.front().predictions);
}

// At all points, the mesh has the topology that it has at the scene's own numbers, so that the figures at a
// point do not depend on earlier points.
TEST_F(SceneOptimumTest, GoesOnWithTheSameMeshWhereACountIsVaried) {
  const std::string trawl = "scene = \"" + test::source_folder() +
                            R"(/gear-library/scenes/83-112-flume-3.0kn.toml"
set = ["gear.nodes=200", "analysis.tolerance=1e-10"]
[variables.depth]
key = "panels.top-body.depth"
range = [190, 192]
start = 190.5
[variables.footrope]
key = "ropes.footrope.length"
range = ["34 m", "34.2 m"]
[objective]
minimise = "gear/drag/all/x"
unit = "kN"
)";
  const SceneOptimum whole = optimise(trawl);
  ASSERT_EQ(whole.status(), "optimal") << whole.trouble;
  std::filesystem::remove(folder_ / "history.jsonl");
  EXPECT_EQ(optimise(trawl, 2).status(), "interrupted");
  const SceneOptimum second = optimise(trawl);
  ASSERT_EQ(second.found.history.size(), whole.found.history.size());
  for (std::size_t p = 0; p < whole.found.history.size(); ++p)
    EXPECT_NEAR(second.found.history[p].predictions.at(0), whole.found.history[p].predictions.at(0), 1e-4);
}

// The horizontal tension H of the catenary is at least 4 N, where 8 m = HL/EA + (2H/w) asinh(wL/2H).
TEST_F(SceneOptimumTest, LimitsTheForceOfAHold) {
  const std::string limited = kRope.substr(0, kRope.find("[[constraints]]")) +
                              "[[constraints]]\nfigure = \"held/rope.start/x\"\nat_most = \"-4 N\"\n";
  const SceneOptimum done = optimise(replaced(limited, "[\"8.5 m\", \"12 m\"]", "[\"8.1 m\", \"12 m\"]"));
  ASSERT_EQ(done.status(), "optimal") << done.trouble;
  const double L = done.found.best.parameters[0];
  EXPECT_NEAR(4 * L / 100 + 2 * 4 * std::asinh(L / (2 * 4)), 8, 1e-5);
}

// The variable changes stiffness and density in the same proportion. All tensions change in that proportion,
// too (Euler's theorem), so that the least allowed value of the variable is the best.
TEST_F(SceneOptimumTest, ChangesSeveralKeysTogether) {
  const SceneOptimum done = optimise(replaced(
      replaced(kRope.substr(0, kRope.find("[[constraints]]")), "\"parts.rope.length\"",
               R"(["parts.rope.rope.EA", { key = "parts.rope.rope.density", factor = 3.2458575169277043 }])"),
      "range = [\"8.5 m\", \"12 m\"]\nstart = \"11 m\"", "range = [50, 200]"));
  ASSERT_EQ(done.status(), "optimal") << done.trouble;
  EXPECT_EQ(done.found.best.parameters[0], 50);
  EXPECT_NEAR(done.found.best.predictions[0], 5.82945518 / 2, 1e-6);
  EXPECT_NEAR(done.found.parameter_prices[0], 5.82945518 / 100, 1e-7);
}

TEST_F(SceneOptimumTest, SaysWhyASceneHasNoEquilibrium) {
  const SceneOptimum done = optimise(
      replaced(kRope, "1e-10\"", "1e-10\", \"analysis.max_iterations=1\", \"analysis.solver=newton\""));
  EXPECT_EQ(done.status(), "not converged");
  EXPECT_EQ(done.found.reason, "the model has no solution at the start");
  EXPECT_NE(done.trouble, "");
  EXPECT_TRUE(done.found.best.parameters.empty());
  EXPECT_NE(optimum_text(done).find("no equilibrium"), std::string::npos);
  EXPECT_NE(optimum_json(done).find("\"after\": null"), std::string::npos);
}

TEST_F(SceneOptimumTest, RefusesWrongObjectives) {
  EXPECT_EQ(errors_of(replaced(kRope, "unit = \"mN\"\n", "")),
            "7:1: missing key \"unit\" in objective: a text (unit of the objective, such as kN; 1 for a pure "
            "number)\n");
  EXPECT_EQ(errors_of(replaced(kRope, "unit = \"mN\"", "unit = \"mm\"")),
            "9:8: objective.unit: results/end_tension is a force in N, which \"mm\" cannot express (unit = "
            "\"N\")\n");
  EXPECT_EQ(
      errors_of(replaced(kRope, "minimise", "maximise = \"results/sag_z\"\nminimise")),
      "7:1: objective has both minimise and maximise; there is only one objective (limit the other figure "
      "by [[constraints]])\n");
  EXPECT_EQ(errors_of(replaced(kRope, "minimise", "least")),
            "7:1: objective has neither minimise nor maximise (such as minimise = \"gear/drag/all/x\")\n"
            "8:1: unknown key \"least\" in objective (allowed here: \"minimise\", \"maximise\", \"unit\")\n");
  EXPECT_EQ(errors_of(replaced(kRope, "end_tension", "end_tensoin")),
            "8:12: the scene does not report a figure \"results/end_tensoin\" (did you mean "
            "\"results/end_tension\"?)\n");
}

TEST_F(SceneOptimumTest, RefusesWrongConstraints) {
  EXPECT_EQ(errors_of(replaced(kRope, "at_least = \"-200 cm\"", "")),
            "10:1: constraints[0] has neither at_least nor at_most (such as at_least = \"2 m\")\n");
  EXPECT_EQ(errors_of(replaced(kRope, "at_least = \"-200 cm\"", "at_least = \"2 N\"")),
            "12:12: results/sag_z: \"2 N\" is a force (N); a length (m) is expected\n");
  EXPECT_EQ(errors_of(kRope + "at_most = \"-3 m\"\n"),
            "12:12: results/sag_z: at_least -200 cm is more than at_most -3 m\n");
}

TEST_F(SceneOptimumTest, RefusesWrongVariables) {
  const std::string wrong = replaced(kRope, "parts.rope.length", "parts.rope.lenght");
  EXPECT_EQ(errors_of(wrong), "4:7: unknown key \"lenght\" in parts.rope (did you mean \"length\"?)\n");
  EXPECT_EQ(
      errors_of(replaced(wrong, "start = \"11 m\"\n", "")),
      "4:7: length: the scene states no number \"parts.rope.lenght\"; did you mean \"parts.rope.length\"? "
      "(or give it a start, such as start = \"8.5 m\")\n");
  EXPECT_EQ(errors_of(replaced(kRope, "start = \"11 m\"", "start = \"13 m\"")),
            "6:9: variables.length.start: lies outside the range\n");
  const std::string range = "range = [\"8.5 m\", \"12 m\"]\nstart = \"11 m\"";
  EXPECT_EQ(
      errors_of(replaced(kRope, range, "range = [\"11 m\", \"12 m\"]")),
      "3:1: length is 10 m in the scene, outside its range, 11 m to 12 m (widen the range, or say where the "
      "search begins: start = \"11 m\")\n");
  EXPECT_EQ(
      errors_of(replaced(kRope, "parts.rope.length\"\n" + range, "parts.rope.cells\"\nrange = [100, 300]")),
      "3:1: length is not continuous: --set parts.rope.cells: parts.rope.cells is the number 199.9998; an "
      "integer is expected (number of bars of the rope) (only a study can vary it: netloft study)\n");
}

TEST_F(SceneOptimumTest, TakesCountsOfANetPlan) {
  EXPECT_EQ(errors_of("scene = \"" + test::source_folder() + R"(/gear-library/scenes/83-112-flume-3.0kn.toml"
set = ["gear.nodes=200"]
[variables.depth]
key = "panels.top-body.depth"
range = [190, 192]
[objective]
minimise = "gear/drag/all/x"
unit = "kN"
)"),
            "");
}

TEST_F(SceneOptimumTest, ReportsAllErrorsAtOnce) {
  EXPECT_EQ(
      errors_of("scene = \"" + test::source_folder() + R"(/gear-library/scenes/hanging-rope.toml"
[variables.length]
key = "parts.rope.length"
range = ["12 m", "8 m"]
start = "11 m"
[[constraints]]
figure = "results/sag"
at_least = "-2 m"
)"),
      "1:1: missing key \"objective\": a table (what is to be least or greatest: minimise or maximise, and "
      "unit)\n"
      "4:9: variables.length.range: 12 m is not less than 8 m (least and largest value of the variable)\n"
      "7:10: the scene does not report a figure \"results/sag\" (did you mean \"results/sag_z\"?)\n");
  const std::string without_scene =
      errors_of("scene = \"no.toml\"\n[variables]\n[objective]\nminimise = \"a\"\nunit = 1\n");
  EXPECT_NE(without_scene.find("no.toml cannot be opened"), std::string::npos);
  EXPECT_NE(without_scene.find("\n2:1: variables: is empty: there is nothing that may be changed"),
            std::string::npos);
  EXPECT_NE(without_scene.find("\n5:8: objective.unit is the integer 1; a text is expected"),
            std::string::npos);
}

}  // namespace
}  // namespace netloft::studies
