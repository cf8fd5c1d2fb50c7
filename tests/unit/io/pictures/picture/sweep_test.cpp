// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::pictures {
namespace {

TEST(VariedSetting, IsTheOptionOfTheCommandLinesThatDiffers) {
  const Varied varied = varied_setting(
      {{{"netloft", "run", "a.toml", "--set", "gear.nodes=500", "--set", "tow.speed=2 kn"}, ""},
       {{"netloft", "run", "a.toml", "--set=tow.speed=3 kn", "--set", "gear.nodes=500"}, ""}});
  EXPECT_EQ(varied.name, "tow.speed");
  EXPECT_EQ(varied.values, (std::vector<std::string>{"2 kn", "3 kn"}));
  EXPECT_EQ(varied.numbers, (std::vector<double>{2, 3}));
  EXPECT_EQ(varied.unit, "kn");
}

TEST(VariedSetting, IsTheLineOfTheScenesThatDiffersInANumber) {
  const std::string scene = "title = \"one\"  # speed = 9\n[[hold]]\nat = [1, 2]\n[tow]\nspeed = ";
  const Varied varied = varied_setting({{{}, scene + "\"2.5 kn\"\n"}, {{}, scene + "\"4 kn\" # fast\n"}});
  EXPECT_EQ(varied.name, "tow.speed");
  EXPECT_EQ(varied.values, (std::vector<std::string>{"2.5 kn", "4 kn"}));
}

TEST(VariedSetting, IsNothingWhereTwoResultsHaveTheSameOrNoNumber) {
  EXPECT_EQ(varied_setting({{{}, "[a]\nb = 1\n"}, {{}, "[a]\nb = 2\n"}, {{}, "[a]\nb = 2\n"}}).name, "");
  EXPECT_EQ(varied_setting({{{}, "[a]\nb = \"x\"\n"}, {{}, "[a]\nb = \"y\"\n"}}).name, "");
  EXPECT_EQ(varied_setting({}).name, "");
}

TEST(VariedSetting, SurvivesWhatIsNoScene) {
  EXPECT_EQ(varied_setting({{{"--set"}, "=\n[\n]=[\n = 1\n\"\n"}, {{"--set="}, "\r\n[]\n"}}).name, "");
}

}  // namespace
}  // namespace netloft::pictures
