// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace netloft::studies {
namespace {

bool has_text(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

Trial trial(double tolerance, SolveStatus status, double error, double seconds) {
  Trial t;
  t.tolerance = tolerance, t.status = status, t.error = error, t.cpu_seconds = seconds;
  t.reason = "because";
  return t;
}

Comparison example() {
  Comparison c;
  c.scene = "panel", c.mesh = "8 x 8 cells of net", c.unknowns = 216, c.factorisation_seconds = 0.01,
  c.size = 40;
  ReferenceAnswer r{{"ptc"}, true, 1e-9, Stability::stable, {}};
  r.answer.residual = 1e-12, r.answer.load = 100, r.answer.uncertainty = 1e-14;
  MethodResult newton{{"newton:method=classic,damping=0"}, {}, r, {}};
  newton.trials = {trial(1e-2, SolveStatus::converged, 0.5, 0.02),
                   trial(1e-6, SolveStatus::converged, 0, 0.04)};
  MethodResult lost{{"lbfgs"}, {}, r, OtherEquilibrium{1.5, -0.25, true}};
  lost.trials = {trial(1e-2, SolveStatus::converged, std::nan(""), 1),
                 trial(1e-6, SolveStatus::not_converged, std::nan(""), 2)};
  c.methods = {newton, lost};
  Discretisation d;
  d.part = "net", d.order = 1.1, d.steady = true;
  for (const int cells : {8, 16}) {
    d.levels.emplace_back();
    d.levels.back().cells = cells, d.levels.back().error = 4.0 / cells;
  }
  c.discretisation = d;
  return c;
}

TEST(ComparisonText, SaysWhoJudgedWhomAndWhatIsNoError) {
  const std::string text = comparison_text(example());
  EXPECT_TRUE(has_text(text, "the reference is ptc, converged to 1e-09")) << text;
  EXPECT_TRUE(has_text(
      text,
      "lbfgs: found another equilibrium than ptc, up to 1.5 m away, with an energy that differs by -0.25 J"))
      << text;
  EXPECT_TRUE(has_text(text, "lbfgs: not converged at 1e-06: because")) << text;
  EXPECT_TRUE(has_text(text, "order 1.10 observed")) << text;
}

TEST(ComparisonCsv, HasAsManyCellsInEveryRow) {
  std::istringstream lines(comparison_csv(example()));
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line); ++rows) {
    std::size_t commas = 0;
    bool quoted = false;
    for (const char c : line) quoted ^= c == '"', commas += c == ',' && !quoted;
    EXPECT_EQ(commas, 17u) << line;
    EXPECT_FALSE(has_text(line, "nan")) << line;
  }
  EXPECT_EQ(rows, 1u + 4 + 2);
}

TEST(ComparisonCsv, CountsWorkInFactorisations) {
  EXPECT_TRUE(has_text(comparison_csv(example()), ",0.5,,0.02,2,")) << comparison_csv(example());
}

TEST(ComparisonPlot, DrawsAnErrorOfZeroAtTheRoundOffOfTheGear) {
  const formats::LinePlot plot = comparison_plot(example());
  ASSERT_EQ(plot.series[0].points.size(), 2u);
  EXPECT_EQ(plot.series[0].points[0].x, 0.5);
  EXPECT_DOUBLE_EQ(plot.series[0].points[1].x, 40 * 2.220446049250313e-16);
}

TEST(ComparisonPlot, DrawsNoErrorsOfAnotherEquilibrium) {
  const formats::LinePlot plot = comparison_plot(example());
  EXPECT_TRUE(plot.series[1].points.empty());
  EXPECT_EQ(plot.series[1].name, "lbfgs (other equilibrium)");
  ASSERT_EQ(plot.marks.size(), 2u);
  EXPECT_EQ(plot.marks[0].label, "8 cells");
}

Comparison motions() {
  Comparison c = example();
  c.is_of_motions = true, c.factorisation_seconds = 0, c.discretisation.reset();
  c.methods[0].method = {"integrator newmark"}, c.methods[1].method = {"integrator energy-momentum"};
  c.methods[1].other.reset();
  for (MethodResult& m : c.methods)
    for (Trial& t : m.trials) t.of_motion = t.converged() ? "finished" : "lost", t.steps = 7, t.rejected = 2;
  c.methods[1].trials[0].error = 0.25;
  c.methods[0].reference->method = {"integrator energy-momentum"};
  return c;
}

TEST(ComparisonOfMotions, NamesTheLostInTableAndPlot) {
  const std::string text = comparison_text(motions());
  EXPECT_TRUE(has_text(text, "energy-momentum: lost at 1e-06: because")) << text;
  EXPECT_TRUE(has_text(text, "newmark: the reference is energy-momentum at an accuracy of 1e-09")) << text;
  const formats::LinePlot plot = comparison_plot(motions());
  EXPECT_EQ(plot.series[1].name, "energy-momentum (lost at 1e-06)");
  ASSERT_EQ(plot.series[1].points.size(), 1u);
  EXPECT_EQ(plot.series[1].points[0].x, 0.25);
}

TEST(ComparisonOfMotions, CountsStepsInCsvAndJson) {
  EXPECT_TRUE(has_text(comparison_csv(motions()), "motion,integrator newmark,0.01,,216,finished,0.5,,0.02,,"))
      << comparison_csv(motions());
  EXPECT_TRUE(has_text(comparison_csv(motions()), ",7,2\n"));
  EXPECT_TRUE(has_text(comparison_json(motions()), "\"steps\": 7")) << comparison_json(motions());
}

TEST(ComparisonJson, HasNullForWhatIsNotKnown) {
  const std::string json = comparison_json(example());
  EXPECT_TRUE(has_text(json, "\"error\": null")) << json;
  EXPECT_TRUE(has_text(json, "\"distance\": 1.5")) << json;
}

}  // namespace
}  // namespace netloft::studies
