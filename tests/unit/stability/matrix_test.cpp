// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/matrix.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace netloft::hard_cases {
namespace {

/// Two cases and two solvers. One case has no equilibrium, but the second solver claims to have found one.
class Matrix : public ::testing::Test {
 protected:
  Matrix() {
    panel.name = "panel/<slack>", panel.about = "slack & \"cold\"";
    none.name = "rope/loose", none.expected = Expected::none, none.is_random = true;
    none.scene = "rope.toml", none.overrides = {"parts.rope.EA=1e9"};
    none.start = {{.amplitude = 2.5, .seed = 7}, {.kind = StartStep::Kind::turn, .angle = 0.5, .axis = 2}};
    none.sizes["small"] = {"parts.rope.cells=67"}, none.sizes["large"] = {"parts.rope.cells=4000"};
    rows = {{&panel, "small", {cell(panel, "auto", Where::reference), cell(panel, "lbfgs", Where::unfit)}, 1},
            {&none, "small", {cell(none, "auto", Where::honest), cell(none, "lbfgs", Where::lied)}, 0}};
  }
  static Cell cell(const HardCase& c, const std::string& solver, Where where) {
    Cell cell;
    cell.name = c.name, cell.size = "small", cell.solver = solver, cell.expected = c.expected;
    cell.verdict.where = where, cell.unknowns = 216, cell.iterations = 12, cell.factorisations = 13;
    cell.confirmed = where != Where::reference, cell.cpu_seconds = 0.25, cell.reason = "1 < 2",
    cell.energy = -5;
    return cell;
  }
  HardCase panel, none;
  std::vector<Row> rows;
};

TEST_F(Matrix, CountsWhatIsRightAndWhatIsClaimedWrong) {
  const auto all = tally(rows);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].cases, 2u);
  EXPECT_EQ(all[0].right, 2u);
  EXPECT_EQ(all[0].claimed_wrong, 0u);
  EXPECT_EQ(all[0].unconfirmed, 1u);
  EXPECT_EQ(all[0].factorisations, 26u);
  EXPECT_EQ(all[1].cases, 1u);  // a case for which the solver is unfit does not count
  EXPECT_EQ(all[1].right, 0u);
  EXPECT_EQ(all[1].claimed_wrong, 1u);
}

TEST_F(Matrix, CountsEachKindByItself) {
  const auto kinds = tally_by_kind(rows);
  ASSERT_EQ(kinds.size(), 2u);
  EXPECT_EQ(kinds[0].kind, "panel");
  EXPECT_EQ(kinds[1].kind, "rope");
  EXPECT_EQ(kinds[0].columns.at(0).cases, 1u);
  EXPECT_EQ(kinds[0].columns.at(1).cases, 0u);
  EXPECT_EQ(kinds[1].columns.at(1).claimed_wrong, 1u);
  const std::string text = matrix_text({"suite", 3}, rows);
  EXPECT_NE(text.find("0/1 !!1"), std::string::npos) << text;
}

TEST_F(Matrix, TheTableNamesCasesAndMarksWhatIsClaimedWrong) {
  const std::string text = matrix_text({"suite", 3}, rows);
  EXPECT_NE(text.find("seed 3"), std::string::npos);
  EXPECT_NE(text.find("reference 12/13/0.25"), std::string::npos);
  EXPECT_NE(text.find("rope/loose * (none)"), std::string::npos);
  EXPECT_NE(text.find("!! lied 12/13/0.25"), std::string::npos);
  EXPECT_NE(text.find("right 2 of 2 (1 that no other solver found), claimed wrong 0"), std::string::npos)
      << text;
}

TEST_F(Matrix, JsonHasEveryCaseWithItsFigures) {
  rows[0].cells[0].energy = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(matrix_json({"suite", 3}, rows));
  ASSERT_EQ(json["cases"].size(), 4u);
  const auto& c = json["cases"][3];
  EXPECT_EQ(c["name"], "rope/loose");
  EXPECT_EQ(c["solver"], "lbfgs");
  EXPECT_EQ(c["unknowns"], 216);
  EXPECT_EQ(c["right"], false);
  EXPECT_EQ(c["claimed_wrong"], true);
  EXPECT_EQ(c["where"], "lied");
  EXPECT_EQ(c["expected"], "none");
  EXPECT_EQ(c["iterations"], 12);
  EXPECT_EQ(c["factorisations"], 13);
  EXPECT_EQ(c["cpu_seconds"], 0.25);
  EXPECT_EQ(c["energy"], -5);
  EXPECT_EQ(c["reason"], "1 < 2");
  EXPECT_EQ(c["scene"], "rope.toml");
  EXPECT_EQ(c["set"], nlohmann::json({"parts.rope.EA=1e9", "parts.rope.cells=67"}));
  ASSERT_EQ(c["start"].size(), 2u);
  EXPECT_EQ(c["start"][0], nlohmann::json({{"noise", 2.5}, {"seed", 7}}));
  EXPECT_EQ(c["start"][1]["turn"], 0.5);
  EXPECT_EQ(c["start"][1]["axis"], "z");
  EXPECT_TRUE(json["cases"][0]["start"].empty());
  EXPECT_EQ(json["cases"][0]["right"], true);
  EXPECT_EQ(json["cases"][0]["confirmed"], false);
  EXPECT_EQ(json["solvers"][1]["claimed_wrong"], 1);
  ASSERT_EQ(json["kinds"].size(), 4u);
  EXPECT_EQ(json["kinds"][2]["kind"], "rope");
  EXPECT_EQ(json["kinds"][2]["solver"], "auto");
  EXPECT_EQ(json["kinds"][2]["right"], 1);
  EXPECT_TRUE(json["cases"][0]["energy"].is_null());
}

TEST_F(Matrix, ThePageStandsAloneAndEscapesWhatItQuotes) {
  const std::string page = matrix_html({"suite", 3}, rows);
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_NE(page.find("panel/&lt;slack&gt;"), std::string::npos);
  EXPECT_NE(page.find("slack &amp; &quot;cold&quot;"), std::string::npos);
  EXPECT_NE(page.find("class=\"claimed-wrong\" title=\"1 &lt; 2\""), std::string::npos);
}

}  // namespace
}  // namespace netloft::hard_cases
