// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/figure_indices.hpp"

#include "io/studies/sweep/unit_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

namespace netloft::studies {
namespace {

using Numbers = std::vector<double>;
constexpr double kPi = 3.141592653589793;

/// A variable from `low` to `high`; one without levels is sampled.
struct Axis {
  const char *name, *unit;
  double low, high;
  std::size_t levels = 0;
};

/// A table of a function over a grid of listed variables, which come first, and samples of the others.
StudyTable table_of(const std::vector<Axis>& axes, std::size_t samples,
                    const std::function<double(const Numbers&)>& f) {
  StudyTable table;
  std::size_t cells = 1, sampled = 0;
  for (const Axis& axis : axes) {
    StudyColumn column;
    column.variable.name = axis.name, column.variable.unit = axis.unit, column.is_sampled = axis.levels == 0;
    table.columns.push_back(column);
    axis.levels ? cells *= axis.levels : ++sampled;
  }
  table.figures = {{"gear/height", "m", 0}, {"gear/drag_by_part/net", "N", 0}};
  const auto units = unit_points(Sampling::sobol, samples, sampled, 7);
  for (std::size_t sample = 0; sample < std::max<std::size_t>(samples, 1); ++sample)
    for (std::size_t cell = 0; cell < cells; ++cell) {
      Numbers x;
      std::size_t rest = cell;
      for (const Axis& axis : axes) {
        const double p = axis.levels
                             ? static_cast<double>(rest % axis.levels) / static_cast<double>(axis.levels - 1)
                             : units[sample][x.size() - (axes.size() - sampled)];
        x.push_back(axis.low + p * (axis.high - axis.low));
        if (axis.levels) rest /= axis.levels;
      }
      StudyRow row{sample + 1, sampled ? sample + 1 : 0, cell + 1, {}, {}, {f(x), 1}};
      for (std::size_t v = 0; v < x.size(); ++v)
        row.values.push_back(table.columns[v].variable.value_of(x[v]));
      row.record.status = "converged";
      table.rows.push_back(std::move(row));
    }
  return table;
}

StudyIndices found(const StudyTable& table, const IndicesRequest& request = {}) {
  formats::Diagnostics diagnostics;
  const auto answer = study_indices(table, request, diagnostics);
  EXPECT_TRUE(answer) << diagnostics.render(false);
  return answer ? *answer : StudyIndices{};
}

std::string refused_table(const StudyTable& table, const IndicesRequest& request = {}) {
  formats::Diagnostics diagnostics;
  EXPECT_FALSE(study_indices(table, request, diagnostics));
  return diagnostics.render(false);
}

const std::vector<Axis> kSpeedAndDepth{{"speed", "kn", 2, 4, 5}, {"depth", "m", 50, 150, 6}};
double headline(const Numbers& x) { return 3 * x[0] + 0.02 * x[1]; }

// Ishigami's function, with the closed forms of sobol_indices_test.cpp, and a response to 300 samples of it.
TEST(StudyIndices, OfDrawsIsThatOfIshigamisFunctionWithinItsErrors) {
  const std::vector<Axis> axes{{"a", "", -kPi, kPi}, {"b", "", -kPi, kPi}, {"c", "", -kPi, kPi}};
  const StudyTable table = table_of(axes, 300, [](const Numbers& x) {
    return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
  });
  const FigureIndices figure = found(table).figures.at(0);
  const double first[] = {0.3139, 0.4424, 0}, total[] = {0.5576, 0.4424, 0.2437};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(figure.variables[i].first.value, first[i], figure.variables[i].first.error) << i;
    EXPECT_NEAR(figure.variables[i].total.value, total[i], figure.variables[i].total.error) << i;
    EXPECT_LT(figure.variables[i].first.error, 0.06) << i;
    EXPECT_LT(figure.variables[i].total.error, 0.06) << i;
  }
  EXPECT_LT(figure.off, 0.3);
}
// The function changes by 6 over the range of speed and by 2 over that of depth, so that the indices are 0.9
// and 0.1.
TEST(StudyIndices, OfAGridIsThatOfALinearFunction) {
  const FigureIndices figure = found(table_of(kSpeedAndDepth, 0, headline)).figures.at(0);
  EXPECT_NEAR(figure.variables[0].first.value, 0.9, 0.005);
  EXPECT_NEAR(figure.variables[1].total.value, 0.1, 0.005);
  EXPECT_NEAR(figure.mean, 11, 0.01);
  EXPECT_NEAR(figure.deviation, std::sqrt(40.0 / 12), 0.01);
  EXPECT_LT(figure.off, 1e-4);
}
// The variables are speed, depth and a sampled friction, which has no effect on the height.
TEST(StudyIndices, IsOfListedAndDrawnVariablesTogether) {
  std::vector<Axis> axes = kSpeedAndDepth;
  axes.push_back({"friction", "", 0.4, 0.5});
  const StudyIndices s = found(table_of(axes, 12, headline));
  ASSERT_EQ(s.variables.size(), 3u);
  EXPECT_TRUE(s.variables[2].is_sampled);
  const FigureIndices& figure = s.figures.at(0);
  EXPECT_NEAR(figure.variables[0].first.value, 0.9, figure.variables[0].first.error + 0.005);
  EXPECT_NEAR(figure.variables[2].total.value, 0, 0.005);
}
// A held variable has no index. It may be held at a value of the grid, or between two of them.
TEST(StudyIndices, IsOfTheVariablesThatAreNotHeld) {
  const StudyTable table = table_of(kSpeedAndDepth, 0, headline);
  for (const char* at : {"speed=2.5 kn", "speed=2.7 kn"}) {
    const StudyIndices s = found(table, {{at}, {}});
    ASSERT_EQ(s.variables.size(), 1u);
    EXPECT_EQ(s.variables[0].name, "depth");
    EXPECT_NEAR(s.figures[0].variables[0].first.value, 1, 0.01);
  }
}
TEST(StudyIndices, HasLargeErrorsWhereTheResponseIsNotKnown) {
  const auto kink = [](const Numbers& x) { return std::abs(x[0] - 3.2) + 0.002 * x[1]; };
  const FigureIndices rough = found(table_of(kSpeedAndDepth, 0, kink)).figures.at(0);
  const FigureIndices smooth = found(table_of(kSpeedAndDepth, 0, headline)).figures.at(0);
  EXPECT_GT(rough.variables[0].first.error, 5 * smooth.variables[0].first.error);
  EXPECT_GT(rough.off, 0.1);
}
TEST(StudyIndices, LeavesOutAndCountsWhatHasNoEquilibrium) {
  StudyTable table = table_of(kSpeedAndDepth, 0, headline);
  for (const std::size_t r : {7u, 14u})
    table.rows[r].record.status = "not converged", table.rows[r].figures[0] = 1e6;
  const StudyIndices s = found(table);
  EXPECT_EQ(s.left_out, 2u);
  EXPECT_NEAR(s.figures[0].variables[0].first.value, 0.9, 0.01);
  for (StudyRow& row : table.rows) row.record.status = "missing";
  formats::Diagnostics diagnostics;
  EXPECT_THROW(study_indices(table, {}, diagnostics), StudyError);
}
TEST(StudyIndices, SaysOfAFigureWhyItHasNoIndices) {
  const auto table = table_of(kSpeedAndDepth, 0, headline);
  EXPECT_EQ(found(table, {{}, {"gear/drag_by_part/net"}}).figures[0].why_not, "it does not vary");
  const auto few = table_of({{"a", "", 0, 1}, {"b", "", 0, 1}}, 4, [](const Numbers& x) { return x[0]; });
  EXPECT_EQ(found(few).figures[0].why_not, "4 samples are too few for 2 sampled variables");
}
TEST(StudyIndices, IsRefusedWhereVariablesDoNotVaryByThemselves) {
  StudyTable table = table_of(kSpeedAndDepth, 0, headline);
  EXPECT_NE(refused_table(table, {{"sped=2 kn"}, {"gear/heigt"}}).find("did you mean \"speed\"?"),
            std::string::npos);
  EXPECT_NE(refused_table(table, {{"sped=2 kn"}, {"gear/heigt"}}).find("did you mean \"gear/height\"?"),
            std::string::npos);
  EXPECT_NE(refused_table(table, {{"speed=2 kn,depth=50 m"}, {}}).find("no variable varies"),
            std::string::npos);
  EXPECT_NE(refused_table(table_of({{"speed", "kn", 2, 4, 2}, {"depth", "m", 50, 150, 6}}, 0, headline))
                .find("speed has two values"),
            std::string::npos);
  StudyTable list = table;
  std::erase_if(list.rows, [](const StudyRow& row) { return row.point % 6 != 1; });
  EXPECT_NE(refused_table(list).find("one by one"), std::string::npos);
  StudyColumn gears;
  gears.variable.name = "gear", gears.is_number = false;
  table.columns.push_back(gears);
  for (std::size_t r = 0; r < table.rows.size(); ++r) table.rows[r].values.push_back({r % 2 ? "a" : "b", {}});
  EXPECT_NE(refused_table(table).find("gear has values that are no numbers"), std::string::npos);
}
TEST(StudyIndices, IsATableJsonAndBars) {
  const StudyIndices s = found(table_of(kSpeedAndDepth, 0, headline));
  EXPECT_NE(indices_text("s", s).find("s: Sobol indices over speed 2 to 4 kn, depth 50 to 150 m\n"),
            std::string::npos);
  const auto json = nlohmann::json::parse(indices_json("s", s));
  EXPECT_NEAR(json["figures"]["gear/height"]["variables"]["speed"]["first"]["value"], 0.9, 0.005);
  const std::string svg = formats::draw_svg(indices_bars(s));
  EXPECT_NE(svg.find(">depth<"), std::string::npos);
  EXPECT_NE(svg.find(">first order<"), std::string::npos);
}
TEST(StudyIndices, IsTheSameEveryTime) {
  const StudyTable table =
      table_of({{"a", "", 0, 1}, {"b", "", 0, 1}}, 40, [](const Numbers& x) { return x[0] * x[1]; });
  EXPECT_EQ(indices_json("s", found(table)), indices_json("s", found(table)));
}

}  // namespace
}  // namespace netloft::studies
