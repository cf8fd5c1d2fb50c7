// SPDX-License-Identifier: BSD-3-Clause
//
// The hanging panel of the paper's fig. 6a as a lumped-mass net. With one mesh per cell, it is the net
// modelled twine by twine, as solved by an independent program (every twine one bar, knots as nodes, in the
// plane of the panel, 6480 unknowns, converged to about 10 digits).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "tests/verification/reference.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

// Results of the independent program.
constexpr double kMidWidth = 15.0040926972;   // [m]
constexpr double kCentreZ = -18.62402966876;  // of the panel [m]
constexpr double kBottomZ = -42.65782882554;  // z of the middle of the lower edge [m]

/// The scene of the library with another element type.
SolvedFile hang(const std::string& type, int cells) {
  const std::string n = std::to_string(cells);
  return solve_file("dead-weight-panel.toml",
                    {"parts.net.type=" + type, "parts.net.cells=[" + n + "," + n + "]"});
}

/// Distance from the middle of the left edge to that of the right.
double mid_width(const SolvedFile& s) {
  const auto& net = s.part("net");
  const auto middle = [&](const char* edge) {
    const auto& nodes = net.sets.at(edge);
    return s.solved.position(net.nodes.at(nodes.at(nodes.size() / 2)));
  };
  return middle("right")[0] - middle("left")[0];
}

TEST(LumpedNet, HangsTwineByTwineAsTheIndependentProgramSays) {
  const SolvedFile s = hang("lumped/net", 40);
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_EQ(s.solved.solution.stability, Stability::stable);
  const auto top = s.solved.total_reaction()[2];
  const double centre = s.solved.position(s.part("net").nodes.at(20 * 41 + 20))[2],
               bottom = s.solved.position(s.part("net").nodes.at(40 * 41 + 20))[2];
  std::printf("lowest z %.1e m, mid width %.1e m, energy %.1e, reaction %.1e, centre %.1e m, bottom %.1e m\n",
              std::abs(s.solved.lowest_z() - kPanelLowestZ), std::abs(mid_width(s) - kMidWidth),
              relative(s.solved.solution.energy, kPanelEnergy), relative(top, kPanelTopReaction),
              std::abs(centre - kCentreZ), std::abs(bottom - kBottomZ));
  EXPECT_NEAR(s.solved.lowest_z(), kPanelLowestZ, 1e-8);
  EXPECT_NEAR(mid_width(s), kMidWidth, 1e-8);
  EXPECT_NEAR(centre, kCentreZ, 1e-8);
  EXPECT_NEAR(bottom, kBottomZ, 1e-8);
  EXPECT_LT(relative(s.solved.solution.energy, kPanelEnergy), 1e-10);
  EXPECT_LT(relative(top, kPanelTopReaction), 1e-9);
}

TEST(LumpedNet, TendsToTheNetTwineByTwineAsGroupsGetSmaller) {
  std::printf("cells  meshes grouped   lowest z [m]   error [m]   energy, error   mid width, error [m]\n");
  std::vector<double> lowest, energy;
  for (const int cells : {4, 8, 10, 20}) {  // groups of 10, 5, 4 and 2 meshes
    const SolvedFile s = hang("lumped/net", cells);
    ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
    lowest.push_back(std::abs(s.solved.lowest_z() - kPanelLowestZ));
    energy.push_back(relative(s.solved.solution.energy, kPanelEnergy));
    std::printf("%5d %15d %14.6f %11.1e %15.1e %18.1e\n", cells, 40 / cells, s.solved.lowest_z(),
                lowest.back(), energy.back(), std::abs(mid_width(s) - kMidWidth));
  }
  EXPECT_TRUE(std::is_sorted(lowest.rbegin(), lowest.rend()));
  EXPECT_TRUE(std::is_sorted(energy.rbegin(), energy.rend()));
  EXPECT_LT(lowest[3], lowest[2] / 2);  // from groups of four meshes to groups of two, the order is at least
                                        // one
  EXPECT_LT(energy[3], energy[2] / 2);
}

TEST(LumpedNet, WeighsAsMuchAsTheTrianglesItStandsFor) {
  const double lumped = hang("lumped/net", 16).solved.total_reaction()[2],
               triangles = hang("priour/triangle", 16).solved.total_reaction()[2];
  EXPECT_LT(relative(lumped, triangles), 1e-10);
  // 4 x 1600 bars of 0.6 m: 3840 m of twine of 10 mm, 975 kg/m³ heavier than the water
  EXPECT_LT(relative(lumped, 3840 * std::numbers::pi / 4 * 1e-4 * 975 * 9.81), 1e-10);
}

TEST(LumpedNet, AndTrianglesAreTwoSidesOfOnePanel) {  // the difference decreases with the size of cells
  double before = 1e9;
  for (const int cells : {8, 16, 32}) {
    const double difference = std::abs(hang("lumped/net", cells).solved.lowest_z() -
                                       hang("priour/triangle", cells).solved.lowest_z());
    std::printf("%2d cells: lowest z differs by %.1e m\n", cells, difference);
    EXPECT_LT(difference, before);
    before = difference;
  }
  EXPECT_LT(before, 0.023);  // the error of triangles with 32 cells, compared with the net twine by twine
}

}  // namespace
}  // namespace netloft::test
