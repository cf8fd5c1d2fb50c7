// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/scene_faults.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::studies {
namespace {

using formats::test::Input;

TEST(SceneFaults, AreShownAtTheVariableThatIsToBlame) {
  Input scene("[tow]\nspeed = 1", {"tow.speed=3 kg", "tow.speeed=3 m/s"});
  scene.reader.table("tow").real("speed", {.unit = "m/s"});
  scene.reader.finish();
  ASSERT_EQ(scene.diagnostics.errors(), 2);

  formats::Diagnostics study;
  const int file = study.add_source("study.toml", "scene = \"s.toml\"\n[v]\n[w]\n");
  hand_on_faults(scene.diagnostics, {{"tow.speed", {file, 2, 1}}, {"tow.speeed", {file, 3, 1}}}, {file, 1, 9},
                 study);
  const auto all = study.sorted();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].place.line, 2);
  EXPECT_EQ(all[0].message, "tow.speed: \"3 kg\" is a mass (kg); a speed (m/s) is expected");
  EXPECT_EQ(all[1].place.line, 3);
  EXPECT_EQ(all[1].message, "unknown key \"speeed\" in tow");
  EXPECT_EQ(all[1].hint, "did you mean \"speed\"?");
}
TEST(SceneFaults, OfTheSceneItselfAreShownWithTheirPlaceThere) {
  Input scene("[tow]\nspeed = \"x\"");
  scene.reader.table("tow").real("speed", {.unit = "m/s"});
  formats::Diagnostics study;
  const int file = study.add_source("study.toml", "scene = \"s.toml\"\n");
  hand_on_faults(scene.diagnostics, {{"tow.speed", {file, 9, 9}}}, {file, 1, 9}, study);
  const auto all = study.sorted();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].place.line, 1);
  EXPECT_TRUE(all[0].message.starts_with("net.toml:2:9: tow.speed")) << all[0].message;
}

}  // namespace
}  // namespace netloft::studies
