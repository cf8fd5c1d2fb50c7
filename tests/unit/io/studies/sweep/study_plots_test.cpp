// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study_plots.hpp"

#include <gtest/gtest.h>

namespace netloft::studies {
namespace {

StudyColumn column(const std::string& name, bool sampled) {
  StudyColumn c;
  c.variable.name = name, c.is_sampled = sampled;
  return c;
}

/// A table of a height over two speeds and four samples of a friction; at the second speed one sample has no
/// equilibrium.
StudyTable table_of_heights() {
  StudyTable table;
  table.columns = {column("speed", false), column("friction", true)};
  table.figures = {{"gear/height", "m", 0}};
  for (std::size_t sample = 1; sample <= 4; ++sample)
    for (const double speed : {2.0, 3.0}) {
      StudyRow row{sample, sample, table.rows.size() + 1,
                   {},     {},     {speed + 0.1 * static_cast<double>(sample)}};
      row.values = {table.columns[0].variable.value_of(speed),
                    table.columns[1].variable.value_of(0.1 * static_cast<double>(sample))};
      row.record.status = sample == 4 && speed == 3 ? "unstable" : "converged";
      table.rows.push_back(std::move(row));
    }
  return table;
}

TEST(StudyPlots, HaveTheMedianOfTheDrawsThatAreFoundAndAHollowMarkerWhereOthersAreNot) {
  const auto plots = plots_of(table_of_heights(), {{"gear/height"}, "speed", "", {}});
  ASSERT_EQ(plots.size(), 1u);
  ASSERT_EQ(plots[0].series.size(), 1u);
  const auto& points = plots[0].series[0].points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points[0].y, 2.25, 1e-12);
  EXPECT_FALSE(points[0].is_hollow);
  EXPECT_NEAR(points[1].y, 3.2, 1e-12);  // the median of three samples
  EXPECT_TRUE(points[1].is_hollow);
  EXPECT_FALSE(plots[0].hollow.empty());
}

TEST(StudyPlots, OverWhatIsDrawnHaveAMarkerForEveryRow) {
  const auto plots = plots_of(table_of_heights(), {{"gear/height"}, "friction", "", {{"speed", "3"}}});
  ASSERT_EQ(plots.at(0).series.size(), 1u);
  EXPECT_EQ(plots[0].series[0].points.size(), 3u);
  EXPECT_FALSE(plots[0].series[0].is_line);
}

}  // namespace
}  // namespace netloft::studies
