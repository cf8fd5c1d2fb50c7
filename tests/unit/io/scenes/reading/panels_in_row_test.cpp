// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/panels_in_row.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

using Meshes = std::vector<double>;

/// One triangle of each panel: its nodes, and the meshes from its corners to the aft edge of the panel.
Meshes counted(const std::vector<std::uint32_t>& nodes, const Meshes& to_aft) {
  Part rider;
  rider.nodes = nodes;
  rider.data["to_aft"] = to_aft;
  std::vector<PanelBelow> panels;
  for (std::size_t corner = 0; corner < nodes.size(); corner += 3) panels.push_back({corner});
  count_meshes_through_seams(panels, rider);
  return rider.data.at("to_aft");
}

TEST(PanelsInRow, CountTheMeshesOfThoseThatFollowWhateverTheOrderOfTheirNames) {
  EXPECT_EQ(counted({0, 1, 2, 1, 2, 3, 3, 4, 5}, {5, 0, 0, 7, 7, 0, 2, 0, 0}),
            (Meshes{14, 9, 9, 9, 9, 2, 2, 0, 0}));
  EXPECT_EQ(counted({3, 4, 5, 1, 2, 3, 0, 1, 2}, {2, 0, 0, 7, 7, 0, 5, 0, 0}),
            (Meshes{2, 0, 0, 9, 9, 2, 14, 9, 9}));
}

TEST(PanelsInRow, LeaveThoseAloneThatEndTogetherOrLieSideBySide) {
  EXPECT_EQ(counted({0, 1, 2, 0, 1, 3}, {5, 0, 0, 6, 0, 0}), (Meshes{5, 0, 0, 6, 0, 0}));
  EXPECT_EQ(counted({0, 1, 2, 3, 4, 5}, {5, 0, 0, 7, 7, 0}), (Meshes{5, 0, 0, 7, 7, 0}));
}

TEST(PanelsInRow, TakeTheMeanOfPanelsOfSeveralDepthsThatFollowAtOneEdge) {
  EXPECT_EQ(counted({0, 1, 2, 1, 3, 4, 2, 5, 6}, {5, 0, 0, 4, 0, 0, 6, 0, 0}),
            (Meshes{10, 5, 5, 4, 0, 0, 6, 0, 0}));
}

TEST(PanelsInRow, ThatFollowOneAnotherInARingAreCountedOnceRound) {
  EXPECT_EQ(counted({0, 1, 2, 1, 0, 3}, {5, 0, 0, 7, 0, 0}), (Meshes{17, 12, 12, 12, 5, 5}));
}

// A recursive call for each panel would use up the stack.
TEST(PanelsInRow, MayBeAHundredThousand) {
  constexpr std::uint32_t kPanels = 100000;
  std::vector<std::uint32_t> nodes;
  Meshes to_aft;
  for (std::uint32_t i = 0; i < kPanels; ++i) {
    nodes.insert(nodes.end(), {i, i + 1, i + 1});
    to_aft.insert(to_aft.end(), {2, 0, 0});
  }
  const Meshes all = counted(nodes, to_aft);
  EXPECT_EQ(all.front(), 2.0 * kPanels);
  EXPECT_EQ(all[3], 2.0 * (kPanels - 1));
  EXPECT_EQ(all.back(), 0);
}

}  // namespace
}  // namespace netloft::scenes
