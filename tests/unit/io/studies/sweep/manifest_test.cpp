// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/manifest.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::studies {
namespace {

class ManifestTest : public formats::test::Scratch {
 protected:
  static Study sample() {
    StudyFile file;
    file.name = "s", file.samples = 2, file.set = {"gear.nodes=500"}, file.figures = {"gear/mouth/area"};
    DesignVariable mass, twine, speed;
    mass.variable.name = "mass", mass.variable.unit = "kg", mass.variable.interval = Interval{1, 2};
    twine.variable.name = "twine", twine.variable.values = {{"pe \"4\"", {}}, {"é", {}}};
    speed.variable.name = "speed", speed.variable.unit = "kn", speed.is_in_path = true;
    speed.variable.values = {{"2 kn", 2}, {"0.1 kn", 0.1}};
    for (auto* v : {&mass, &twine, &speed}) v->variable.keys = {{"key." + v->variable.name, 1, 0}};
    file.variables = {mass, twine, speed};
    return make_study(file, "../scene.toml", {{"../scene.toml", "fnv1a64:0123"}});
  }
  /// The message of the error when this text is read as a manifest.
  std::string refusal(const std::string& text) {
    try {
      read_manifest(write("m.jsonl", text));
      return "";
    } catch (const StudyError& e) {
      return e.what();
    }
  }
};

TEST_F(ManifestTest, IsReadBackAsItWas) {
  const std::string text = manifest_text(sample());
  EXPECT_EQ(manifest_text(read_manifest(write("m.jsonl", text))), text);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 4);
}
TEST_F(ManifestTest, IsRefusedWhereItIsDamaged) {
  const std::string text = manifest_text(sample());
  EXPECT_NE(refusal(text.substr(0, text.size() / 2)), "");
  const std::size_t last_line = text.rfind('\n', text.size() - 2);
  EXPECT_NE(refusal(text.substr(0, last_line + 1)).find("not complete"), std::string::npos);
  std::string changed = text;
  changed.replace(changed.rfind("0.1 kn"), 6, "0.2 kn");
  EXPECT_EQ(refusal(changed), "");  // the text of a value is for display only
  changed = text;
  changed.replace(changed.rfind("key.speed=2 kn"), 14, "key.speed=3 kn");
  EXPECT_NE(refusal(changed).find(":5: the manifest is damaged (an item does not match its hash)"),
            std::string::npos);
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("{}"), "");
  EXPECT_NE(refusal("{\"netloft_study\": 1}\n").find("it has format 1"), std::string::npos);
}
TEST_F(ManifestTest, SurvivesNonsense) {
  const std::string text = manifest_text(sample());
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string changed = text;
    changed[at] = static_cast<char>(changed[at] ^ 0x15);
    refusal(changed);  // it may fail, but it must return
  }
}

}  // namespace
}  // namespace netloft::studies
