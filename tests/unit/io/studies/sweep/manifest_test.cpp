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
  changed.replace(changed.rfind("key.speed=2 kn"), 14, "key.speed=3 kn");
  EXPECT_NE(
      refusal(changed).find(":5: the manifest is damaged (the values of an item are not those that it sets)"),
      std::string::npos);
  changed = text;
  changed.replace(changed.find("gear.nodes=500"), 14, "gear.nodes=501");
  EXPECT_NE(refusal(changed).find(":2: the manifest is damaged (an item does not match its hash)"),
            std::string::npos);
  changed = text;
  changed.replace(changed.find("latin"), 5, "latim");
  EXPECT_NE(refusal(changed).find("(it does not match its checksum)"), std::string::npos);
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("{}"), "");
  EXPECT_NE(refusal("{\"netloft_study\": 1}\n").find("it has format 1"), std::string::npos);
}
TEST_F(ManifestTest, IsRefusedWhereverABitIsFlipped) {
  const std::string text = manifest_text(sample());
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string changed = text;
    changed[at] = static_cast<char>(changed[at] ^ 1 << at % 8);
    EXPECT_NE(refusal(changed), "") << "byte " << at << ", " << text[at];
  }
}
// All of these manifests have correct checksums and hashes.
TEST_F(ManifestTest, IsRefusedIfItsTableWouldSayWhatWasNotSet) {
  Study text = sample(), number = sample(), both = sample(), none = sample();
  text.items[0].points[0].values[0].text = "3 kn";
  EXPECT_NE(refusal(manifest_text(text)).find("the value \"3 kn\" of speed is another number"),
            std::string::npos);
  number.items[0].values[1].number = number.items[0].values[1].number.value_or(0) + 1;
  EXPECT_NE(refusal(manifest_text(number)).find("is another number"), std::string::npos);
  both.items[0].points[0].values[0] = {"3 kn", 3};
  EXPECT_NE(refusal(manifest_text(both)).find("the values of an item are not those that it sets"),
            std::string::npos);
  none.items[0].points[0].values[0].number.reset();
  EXPECT_NE(refusal(manifest_text(none)).find("has no number"), std::string::npos);
}
TEST_F(ManifestTest, IsRefusedIfItsNamesLeadElsewhere) {
  for (const char* name : {"../../pwned", "/pwned", "x\ntouch EXECUTED; #", "..", "x\x1b[31m"}) {
    Study study = sample();
    study.name = name;
    EXPECT_NE(refusal(manifest_text(study)).find("the name of the study"), std::string::npos) << name;
    study = sample();
    study.columns[0].variable.name = name;
    EXPECT_NE(refusal(manifest_text(study)).find("the name of a variable"), std::string::npos) << name;
  }
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
