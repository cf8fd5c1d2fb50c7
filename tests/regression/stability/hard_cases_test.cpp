// SPDX-License-Identifier: BSD-3-Clause
#include "tests/folders.hpp"
#include "tests/stability/suite/matrix.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace netloft::hard_cases {
namespace {

std::vector<Row> run_small(const Suite& suite, const Column& column) {
  References references(suite.folder / "references.json");
  RunOptions options;
  options.sizes = {"small"};
  options.seconds = 60;  // wall time, generous because test machines are busy
  return run_suite(suite, {column}, references, test::shipped_plugins(), options);
}

template <class Is>
std::string rows_where(const std::vector<Row>& rows, const Is& is) {
  std::string names;
  for (const auto& row : rows)
    if (is(row.cells.at(0))) names += row_text(row) + "\n";
  return names;
}

/// Whether success was claimed although there is no equilibrium, the only equilibrium is elsewhere, or a
/// disturbance grows.
bool claims_wrong(const Cell& c) { return is_claimed_wrong(c.verdict.where); }
/// Whether a converged result has an unknown stability. The suite must examine it also if forces have no
/// potential.
bool is_not_asked(const Cell& c) { return c.status == "converged" && c.stability == "unknown"; }
bool is_not_set_up(const Cell& c) {
  return c.verdict.where == Where::not_run && c.expected != Expected::none;
}
bool is_not_given_up(const Cell& c) { return c.expected == Expected::none && !is_right(c.verdict.where); }
bool has_not_arrived(const Cell& c) { return !is_right(c.verdict.where); }
bool is_missed_rope(const Cell& c) {
  return c.name.starts_with("rope/straight") && c.verdict.where != Where::reference;
}

Suite shipped_suite() {
  formats::Diagnostics diagnostics;
  auto suite = read_suite(test::source_folder() + "/tests/stability", 1, diagnostics);
  EXPECT_EQ(diagnostics.errors(), 0) << diagnostics.render(false);
  return suite;
}

TEST(HardCases, NewtonTellsTheTruthAboutAllOfThem) {
  const auto suite = shipped_suite();
  const auto rows = run_small(suite, column_of("newton"));
  EXPECT_GE(rows.size(), 100u);
  EXPECT_EQ(rows_where(rows, is_not_set_up), "");
  EXPECT_EQ(rows_where(rows, claims_wrong), "");
  EXPECT_EQ(rows_where(rows, is_not_asked), "");
  EXPECT_EQ(rows_where(rows, is_not_given_up), "");
  EXPECT_EQ(rows_where(rows, is_missed_rope), "");
}

// Random cases are left out, because no stable shape of some cod-ends is known. A few nets that resist
// compression have many equilibria, and restarts need not find the one of least energy.
constexpr std::size_t kMostMissed = 2;

TEST(HardCases, AutoClaimsNothingWrongAndMissesAFewAtTheMost) {
  auto suite = shipped_suite();
  std::erase_if(suite.cases, [](const HardCase& c) { return c.is_random; });
  const auto rows = run_small(suite, {"", "auto"});
  EXPECT_GE(rows.size(), 80u);
  EXPECT_EQ(rows_where(rows, claims_wrong), "");
  const auto missed = std::count_if(rows.begin(), rows.end(),
                                    [](const Row& row) { return has_not_arrived(row.cells.front()); });
  EXPECT_LE(static_cast<std::size_t>(missed), kMostMissed) << rows_where(rows, has_not_arrived);
}

}  // namespace
}  // namespace netloft::hard_cases
