// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tiling.hpp"

#include "framework/assembler/riders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// The first family of a scene, cut into tiles.
struct Tiled {
  explicit Tiled(Scene given)
      : scene(std::move(given)),
        plan(make_scene_plan(scene, plugins())),
        families(1),
        family(*(families[0] = std::make_unique<ElementFamily>(scene, plan.families[0]))),
        numbering(scene),
        blocks(make_blocks(families, scene, true)),
        tiling(make_tiling(family, scene, numbering, blocks, true, 0)) {}
  Scene scene;
  ScenePlan plan;
  std::vector<std::unique_ptr<ElementFamily>> families;
  ElementFamily& family;
  Numbering numbering;
  NodeBlocks blocks;
  Tiling tiling;

  std::set<std::uint32_t> nodes_of(std::uint32_t tile) const {
    std::set<std::uint32_t> nodes;
    for (std::size_t e = tile * std::size_t{NETLOFT_LANES};
         e < std::min(family.size(), (tile + 1) * std::size_t{NETLOFT_LANES}); ++e)
      for (int corner = 0; corner < family.nodes_per_element(); ++corner)
        nodes.insert(family.node(e, corner));
    return nodes;
  }
};

void expect_no_shared_nodes(const Tiled& t) {
  for (std::size_t c = 0; c + 1 < t.tiling.colour_begin.size(); ++c) {
    std::set<std::uint32_t> seen;
    for (std::size_t i = t.tiling.colour_begin[c]; i < t.tiling.colour_begin[c + 1]; ++i)
      for (const auto node : t.nodes_of(t.tiling.order[i]))
        EXPECT_TRUE(seen.insert(node).second) << "node " << node << " twice in colour " << c;
  }
}

void expect_every_tile_once(const Tiled& t) {
  auto tiles = t.tiling.order;
  std::sort(tiles.begin(), tiles.end());
  ASSERT_EQ(tiles.size(), t.tiling.tiles);
  for (std::uint32_t i = 0; i < tiles.size(); ++i) EXPECT_EQ(tiles[i], i);
  EXPECT_EQ(t.tiling.colour_begin.front(), 0u);
  EXPECT_EQ(t.tiling.colour_begin.back(), t.tiling.tiles);
}

TEST(Tiling, SharesNoNodeBetweenTwoTilesOfOneColour) {
  const Tiled t(sample::hanging_panel(32, 34));
  EXPECT_EQ(t.tiling.tiles, 32u);
  EXPECT_GT(t.tiling.colour_begin.size(), 2u);
  expect_every_tile_once(t);
  expect_no_shared_nodes(t);
}

TEST(Tiling, LeavesTheLastTilePartlyEmpty) {
  const Tiled t(sample::hanging_rope(130));
  ASSERT_EQ(t.tiling.tiles, 3u);
  EXPECT_EQ(t.tiling.lanes(0), 64u);
  EXPECT_EQ(t.tiling.lanes(2), 2u);
  expect_every_tile_once(t);
  expect_no_shared_nodes(t);
}

TEST(FamilyGroups, AreFamiliesOnTheSameNodes) {
  const Tiled rope(sample::hanging_rope(130)), shorter(sample::hanging_rope(129));
  std::vector<std::unique_ptr<ElementFamily>> families;
  for (const Tiled* of : {&rope, &shorter, &rope})
    families.push_back(std::make_unique<ElementFamily>(of->scene, of->plan.families[0], 0));
  const std::vector<FamilyGroup> groups = find_family_groups(families);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].families, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(groups[1].families, std::vector<std::size_t>{1});
}

TEST(FamilyGroups, DoNotJoinFamiliesWhoseElementsHaveMoreNodes) {
  const Tiled rope(sample::hanging_rope(130));
  EXPECT_FALSE(have_same_nodes(rope.family, Tiled(sample::hanging_panel(4, 4)).family));
}

// 70 tiles have one common node. That is more than the 64 colours that a bit mask can hold.
TEST(Tiling, PutsTilesAloneWhenANodeIsInTooMany) {
  Sketch s;
  const auto hub = s.node(0, 0, 0, kAllAxes);
  std::vector<std::uint32_t> ends;
  for (int i = 0; i < 70 * NETLOFT_LANES; ++i) ends.insert(ends.end(), {hub, s.node(1, double(i), 0)});
  auto& wheel =
      s.part("wheel", "rope/bar", {{"rope.EA", 1.0}, {"rope.diameter", 0.01}, {"rope.density", 1.0}}, ends);
  wheel.data["rest_length"].assign(ends.size() / 2, 1);
  const Tiled t(s.scene);
  EXPECT_EQ(t.tiling.tiles, 70u);
  expect_every_tile_once(t);
  expect_no_shared_nodes(t);
}

TEST(Tiling, MapsEveryLaneToThePlacesOfItsNodes) {
  const Tiled t(sample::hanging_panel(8, 34));
  for (std::size_t e = 0; e < t.family.size(); ++e)
    for (std::size_t d = 0; d < 9; ++d)
      EXPECT_EQ(t.tiling.vector_map[(e / 64 * 9 + d) * 64 + e % 64],
                t.numbering.dof(t.family.node(e, static_cast<int>(d / 3)), static_cast<int>(d % 3)).place);
}

}  // namespace
}  // namespace netloft::test
