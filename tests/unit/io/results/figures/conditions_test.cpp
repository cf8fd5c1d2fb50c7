// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/merged_scene.hpp"

#include <gtest/gtest.h>

namespace netloft::results {
namespace {

Result result_with(const std::string& scene, const std::vector<std::string>& command = {}) {
  Result result;
  result.gear = GearNames{};
  result.origins.files = {{"tow.toml", "", scene}};
  result.origins.command = command;
  return result;
}

const std::string kScene =
    "gear = { title = \"My trawl\" }\nship = { speed = \"3 kn\", warp = { length = 160 } }\nbed.depth = "
    "40.5\n";

TEST(Conditions, AreWhatTheSceneStates) {
  const auto conditions = conditions_of(result_with(kScene));
  ASSERT_FALSE(conditions.empty());
  EXPECT_EQ(conditions.front().value, "My trawl");
  EXPECT_EQ(conditions_line(conditions), "speed of the ship 3 kn, depth 40.5 m, warp 160 m");
}

TEST(Conditions, FollowTheOptionsOfTheCommand) {
  const std::vector<std::string> command = {"run", "tow.toml", "--set", "ship.speed=1.5",
                                            "--set=bed.depth=66 m"};
  EXPECT_EQ(conditions_line(conditions_of(result_with(kScene, command))),
            "speed of the ship 1.5 m/s, depth 66 m, warp 160 m");
}

TEST(Conditions, AreNoneWithoutAPlanOrItsTexts) {
  Result without_gear = result_with(kScene);
  without_gear.gear.reset();
  EXPECT_TRUE(conditions_of(without_gear).empty());
  EXPECT_TRUE(conditions_of(result_with("include = [\"common.toml\"]\n")).empty());
  EXPECT_TRUE(conditions_of(result_with("ship = 3\n[bed.depth]\nof = 2\n")).empty());
}

}  // namespace
}  // namespace netloft::results
