// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/io/results/figures/hand_made.hpp"

namespace netloft::results {
namespace {

/// Three ropes from three blocks to one point, in a current.
std::string three_ropes() {
  std::string text = "[water]\ncurrent = [1, 0, 0]\n";
  for (const auto& [name, y] : {std::pair{"port", -2}, {"middle", 0}, {"starboard", 2}})
    text += std::string("[parts.") + name +
            "]\ntype = \"rope/bar\"\nlength = \"10 m\"\ncells = 5\nsketch = [[0, " + std::to_string(y) +
            ", 0], [8, 0, -5]]\n" +
            "rope = { diameter = \"20 mm\", EA = \"50 kN\", density = 1500 }\n[[hold]]\non = \"" + name +
            ".start\"\n";
  return text + "[[join]]\npoints = [\"port.end\", \"middle.end\", \"starboard.end\"]\n";
}

/// The warnings about uncounted pull if the named ropes are warps of a ship.
std::vector<std::string> told(const std::vector<std::string>& warps) {
  HandMade::Parts parts;
  parts.ropes = {"port", "middle", "starboard"}, parts.warps = warps, parts.ship_speed = 1;
  auto warnings = HandMade(written(three_ropes()), parts).solved().warnings;
  std::erase_if(warnings, [](const auto& w) { return w.find("towing/pull") == std::string::npos; });
  return warnings;
}

TEST(UncountedPull, IsToldOfAMiddleWarpWithoutARole) {
  const auto warnings = told({"port", "starboard"});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("middle.start pulls the gear forwards with ")) << warnings[0];
  EXPECT_NE(warnings[0].find("role = \"warp\""), std::string::npos) << warnings[0];
}

TEST(UncountedPull, IsNoneIfEachRopeThatTowsIsAWarp) {
  EXPECT_TRUE(told({"port", "middle", "starboard"}).empty());
}

}  // namespace
}  // namespace netloft::results
