// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/result_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace netloft::results {
namespace {

Result with_sensitivities(KeySensitivities sensitivities) {
  Result result;
  result.figures = {{"mouth/headline_height", "m", "", 2.0}, {"mouth/area", "m2", "", 40.0}};
  result.scalars = {{"lift", "N", "", 0.0}};
  result.sensitivities = std::move(sensitivities);
  return result;
}

FigureTable table_of(const Result& result) {
  const auto tables = report_tables(result);
  const auto table = std::ranges::find(tables, "depends most on", &FigureTable::title);
  EXPECT_NE(table, tables.end());
  return table == tables.end() ? FigureTable{} : *table;
}

TEST(SensitivityTable, HasTheEffectOfOnePercentAndOfOneUnit) {
  const FigureTable table =
      table_of(with_sensitivities({"all",
                                   {{"mouth/headline_height", "m", "tow.speed", "kn", 3, -0.5},
                                    {"mouth/area", "m2", "panels.top.depth", "", -100, 0.25},
                                    {"lift", "N", "tow.speed", "kn", 3, 7}}}));
  ASSERT_EQ(table.rows.size(), 3u);
  using Cells = std::vector<std::string>;
  EXPECT_EQ(table.rows[0].name, "headline height");
  EXPECT_EQ(table.rows[0].cells, (Cells{"tow.speed", "3 kn", "-0.015 m", "-0.75 %", "-0.5 m per kn"}));
  EXPECT_EQ(table.rows[1].name, "mouth area");
  EXPECT_EQ(table.rows[1].cells, (Cells{"panels.top.depth", "-100", "+0.25 m²", "+0.62 %", "+0.25 m²"}));
  EXPECT_EQ(table.rows[2].name, "lift");
  EXPECT_EQ(table.rows[2].cells, (Cells{"tow.speed", "3 kn", "+0.21 N", "-", "+7 N per kn"}));
  EXPECT_EQ(table.headings.size(), 5u);
  EXPECT_TRUE(table_text(table).ends_with("\n    all\n")) << table_text(table);
}

TEST(SensitivityTable, SaysWhyThereAreNone) {
  const FigureTable table = table_of(with_sensitivities({"the run was interrupted", {}}));
  EXPECT_EQ(table.note, "the run was interrupted");
  EXPECT_TRUE(table.rows.empty() && table.headings.empty());
}

TEST(SensitivityTable, IsLeftOutIfTheyWereNotRequested) {
  Result result = with_sensitivities({});
  result.sensitivities.reset();
  EXPECT_TRUE(report_tables(result).empty());
}

}  // namespace
}  // namespace netloft::results
