// SPDX-License-Identifier: BSD-3-Clause
//
// The hanging panel of the paper's fig. 6a compared with an independent program (data/hanging-panel*.txt) on
// the same mesh, from sketches that are slack, exactly unstretched and far too long.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/sample_scenes.hpp"
#include "tests/verification/reference.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

// The height at which no twine is stretched: 60 bars of 0.6 m at a hanging ratio of 32/48.
const double kUnstretched = 48 * std::sqrt(1 - std::pow(32.0 / 48, 2));

struct Numbers {
  explicit Numbers(const Level& l)
      : energy(l.values.at(0)), elastic(l.values.at(1)), lowest_z(l.values.at(2)), top(l.values.at(3)) {}
  double energy, elastic, lowest_z, top;
};

/// Columns of a printed table; `worst_node` is over the nodes of the reference.
struct Errors {
  double worst_node = 0, lowest_z = 0, energy = 0, elastic = 0, top = 0;
};

Errors compare(const Solved& s, const Level& level) {
  const Numbers want(level);
  Errors e;
  for (const auto& node : level.nodes) {
    const auto row = static_cast<std::uint32_t>(node[1]), column = static_cast<std::uint32_t>(node[0]);
    const auto x = s.position(row * static_cast<std::uint32_t>(level.n + 1) + column);
    e.worst_node = std::max(e.worst_node, std::hypot(x[0] - node[2], x[1], x[2] - node[3]));
  }
  e.lowest_z = std::abs(s.lowest_z() - want.lowest_z);
  e.energy = relative(s.solution.energy, want.energy);
  e.elastic = relative(elastic_energy(s), want.elastic);
  e.top = relative(s.total_reaction()[2], want.top);
  return e;
}

void print(const char* what, const Solved& s, const Errors& e) {
  std::printf(
      "%-22s %4d iterations  node %.1e m  lowest z %.1e m  energy %.1e  elastic %.1e  reaction %.1e  %s\n",
      what, s.solution.cost.statistics.iterations, e.worst_node, e.lowest_z, e.energy, e.elastic, e.top,
      name_of(s.solution.stability));
}

class HangingPanel : public testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(HangingPanel, HangsAsTheIndependentProgramSays) {
  const auto [n, height] = GetParam();
  const Solved s = solve(sample::hanging_panel(n, height));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_EQ(s.solution.stability, Stability::stable);
  const Errors e = compare(s, read_level("hanging-panel.txt", n));
  print((std::to_string(n) + " cells, " + std::to_string(height) + " m").c_str(), s, e);
  EXPECT_LT(e.worst_node, kNodeTolerance);
  EXPECT_LT(e.lowest_z, kNodeTolerance);
  EXPECT_LT(e.energy, kRelativeTolerance);
  EXPECT_LT(e.elastic, kRelativeTolerance);
  EXPECT_LT(e.top, kRelativeTolerance);
}

std::string panel_name(const testing::TestParamInfo<std::tuple<int, double>>& info) {
  const double height = std::get<1>(info.param);
  return (height < 35   ? "Slack"
          : height > 36 ? "Overlong"
                        : "Unstretched") +
         std::to_string(std::get<0>(info.param)) + "Cells";
}

INSTANTIATE_TEST_SUITE_P(AllSketches, HangingPanel,
                         testing::Combine(testing::Values(4, 8, 16, 32, 64),
                                          testing::Values(34.0, kUnstretched, 54.0)),
                         panel_name);

class HangingPanelLevels : public testing::TestWithParam<int> {};

TEST_P(HangingPanelLevels, HangsDeeperInAir) {
  const int n = GetParam();
  Scene scene = sample::hanging_panel(n, 34);
  scene.water.density = 0;
  const Solved s = solve(std::move(scene));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  const Errors e = compare(s, read_level("hanging-panel-in-air.txt", n));
  print((std::to_string(n) + " cells, in air").c_str(), s, e);
  EXPECT_LT(e.worst_node, kNodeTolerance);
  EXPECT_LT(e.energy, kRelativeTolerance);
  EXPECT_LT(e.elastic, kRelativeTolerance);
  EXPECT_LT(e.top, kRelativeTolerance);
}

// The energy is convex, so its minimum has one value, but slack netting may have many shapes with this
// energy.
TEST_P(HangingPanelLevels, HasOneEnergyWithoutStiffnessInCompression) {
  const int n = GetParam();
  Scene scene = sample::hanging_panel(n, 34);
  scene.parts[0].parameters["twine.EA_compression"] = 0.0;
  const Solved s = solve(std::move(scene));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_TRUE(s.solution.stability == Stability::stable || s.solution.stability == Stability::neutral)
      << name_of(s.solution.stability);
  const Errors e = compare(s, read_level("hanging-panel-tension-only.txt", n));
  print((std::to_string(n) + " cells, slack is free").c_str(), s, e);
  EXPECT_LT(e.lowest_z, kNodeTolerance);
  EXPECT_LT(e.energy, kRelativeTolerance);
  EXPECT_LT(e.top, kRelativeTolerance);
}

INSTANTIATE_TEST_SUITE_P(AllCells, HangingPanelLevels, testing::Values(4, 8, 16, 32, 64),
                         testing::PrintToStringParamName());

double observed_order(double coarse, double middle, double fine) {
  return std::log2(std::abs((coarse - middle) / (middle - fine)));
}

// The order is below two because the lower edge ends closed and the top corners are singular. The independent
// program finds 1.09 for the lowest z at 32, 64, 128 cells, and orders that drift from level to level.
TEST(HangingPanelOrder, IsAboutOne) {
  std::vector<double> lowest, energy;
  std::printf("cells     lowest z [m]    order       energy [J]    order\n");
  for (const int n : {8, 16, 32, 64, 128}) {
    const Solved s = solve(sample::hanging_panel(n, 54));
    ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
    EXPECT_LT(compare(s, read_level("hanging-panel.txt", n)).worst_node, kNodeTolerance);
    lowest.push_back(s.lowest_z()), energy.push_back(s.solution.energy);
    const std::size_t k = lowest.size();
    std::printf("%5d  %15.10f", n, lowest.back());
    if (k < 3) {
      std::printf("        -  %15.6f        -\n", energy.back());
      continue;
    }
    std::printf(" %8.2f  %15.6f %8.2f\n", observed_order(lowest[k - 3], lowest[k - 2], lowest[k - 1]),
                energy.back(), observed_order(energy[k - 3], energy[k - 2], energy[k - 1]));
  }
  const double order = observed_order(lowest[2], lowest[3], lowest[4]);
  EXPECT_GT(order, 0.8);
  EXPECT_LT(order, 1.6);
}

/// The undamped Newton iteration of the paper. 200 iterations are ten times the number from a good start.
Solved solve_as_published(Scene scene) {
  Solving how;
  how.solver_parameters = {{"method", std::string("classic")}};
  how.limits.iterations = 200;
  return solve(std::move(scene), how);
}

TEST(ClassicNewton, IsReportedForWhatItFindsOnTheHangingPanel) {
  int not_converged = 0, wrong = 0;
  for (const int n : {4, 8, 16, 32})
    for (const double height : {34.0, kUnstretched, 54.0}) {
      const Solved s = solve_as_published(sample::hanging_panel(n, height));
      const Solution& found = s.solution;
      std::printf("%2d cells, %5.2f m: %s, %d iterations; %s\n", n, height, name_of(found.status),
                  found.cost.statistics.iterations, found.reason.c_str());
      if (found.status == SolveStatus::converged) {
        const Errors e = compare(s, read_level("hanging-panel.txt", n));
        EXPECT_EQ(found.stability, Stability::stable);
        EXPECT_LT(e.worst_node, kNodeTolerance);
        wrong += e.worst_node >= kNodeTolerance;
        continue;
      }
      ++not_converged;
      EXPECT_FALSE(found.reason.empty());
      EXPECT_NE(found.at_fault.find("net node"), std::string::npos) << found.at_fault;
    }
  EXPECT_GE(not_converged, 1);
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace netloft::test
