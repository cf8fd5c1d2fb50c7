// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/calibration_file.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

#include <cmath>

namespace netloft::studies {
namespace {

constexpr const char* kGood = R"(confidence = 0.95
set = ["gear.nodes=500"]
[scenes.slow]
scene = "a.toml"
[scenes.fast]
scene = "a.toml"
set = ["tow.speed=4 kn"]
[variables.drag]
key = "drag.normal"
range = [0.8, 1.6]
[variables.height]
key = "points.end.at[2]"
range = ["-2 m", "0 m"]
distribution = "normal"
mean = "-100 cm"
deviation = "0.2 m"
scenes = ["fast"]
[[measured]]
scene = "slow"
figure = "results/pull"
value = "2 kN"
deviation = 20
[[measured]]
scene = "fast"
figure = "results/pull"
value = "4 kN"
deviation = "40 N"
held_back = true
)";

class CalibrationFileTest : public formats::test::Scratch {
 protected:
  CalibrationFile read(const std::string& text) {
    return read_calibration_file(write("c.toml", text), diagnostics_);
  }
  /// The first error as "line:column: message".
  std::string error() const {
    const auto all = diagnostics_.sorted();
    if (all.empty()) return {};
    return std::to_string(all[0].place.line) + ":" + std::to_string(all[0].place.column) + ": " +
           all[0].message;
  }
  static std::string replaced(const std::string& what, const std::string& by) {
    std::string text = kGood;
    return text.replace(text.find(what), what.size(), by);
  }
};

TEST_F(CalibrationFileTest, SaysWhatIsLookedForAndWhatWasMeasured) {
  const CalibrationFile file = read(kGood);
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(file.confidence, 0.95);
  ASSERT_EQ(file.scenes.size(), 2u);
  EXPECT_EQ(file.scenes[1].set, (std::vector<std::string>{"gear.nodes=500", "tow.speed=4 kn"}));
  ASSERT_EQ(file.variables.size(), 2u);
  EXPECT_TRUE(file.variables[0].is_shared);
  EXPECT_EQ(file.variables[0].scenes, (std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(file.variables[1].is_shared);
  EXPECT_EQ(file.variables[1].scenes, (std::vector<std::size_t>{1}));
  ASSERT_EQ(file.measured.size(), 2u);
  EXPECT_EQ(file.measured[0].value, "2 kN");
  EXPECT_EQ(file.measured[0].deviation, "20");
  EXPECT_FALSE(file.measured[0].is_held_back);
  EXPECT_TRUE(file.measured[1].is_held_back);
}

TEST_F(CalibrationFileTest, TakesAUniformPriorForTheNormalOneOfItsDeviation) {
  const CalibrationFile file = read(kGood);
  EXPECT_DOUBLE_EQ(file.variables[0].prior_mean(), 1.2);
  EXPECT_DOUBLE_EQ(file.variables[0].prior_deviation(), 0.8 / std::sqrt(12));
  EXPECT_DOUBLE_EQ(file.variables[1].prior_mean(), -1);
  EXPECT_DOUBLE_EQ(file.variables[1].prior_deviation(), 0.2);
}

TEST_F(CalibrationFileTest, WantsOnlyInputsThatAreThere) {
  struct Wrong {
    std::string text, error;
  };
  const Wrong all[] = {
      {replaced("confidence = 0.95", "confidence = 1"),
       "1:14: confidence = 1 is outside (0, 1) (probability with which intervals and bands contain the true "
       "value)"},
      {replaced("confidence", "confidense"), "1:1: unknown key \"confidense\""},
      {replaced("scene = \"a.toml\"", "scen = \"a.toml\""),
       "3:1: missing key \"scene\" in scenes.slow: a text (the scene, relative to this file)"},
      {replaced("range = [0.8, 1.6]", "values = [0.8, 1.6]"), "8:1: variables.drag has no range"},
      {replaced("range = [0.8, 1.6]", "range = [1.6, 0.8]"), ""},
      {replaced("[0.8, 1.6]\n", "[0.8, 1.6]\ndistribution = \"logarithmic\"\n"), ""},
      {replaced("key = \"drag.normal\"\n", ""), ""},
      {replaced("key = \"drag.normal\"", "key = \"points.end.at[2]\""),
       "11:1: points.end.at[2] is varied by drag already"},
      {replaced("mean = \"-100 cm\"", "mean = \"1 m\""),
       "15:8: variables.height.mean: lies outside the range, at which the distribution is cut off"},
      {replaced("mean = \"-100 cm\"", "mean = \"1 kg\""), ""},
      {replaced("deviation = \"0.2 m\"", "deviation = \"0 m\""),
       "16:13: variables.height.deviation: must be above zero"},
      {replaced("scenes = [\"fast\"]", "scenes = [\"fest\"]"),
       "17:10: variables.height.scenes: there is no scene \"fest\" in this file"},
      {replaced("scenes = [\"fast\"]", "scenes = []"), ""},
      {replaced("scene = \"slow\"", "scene = \"slo\""),
       "19:9: measured[0].scene: there is no scene \"slo\" in this file"},
      {replaced("figure = \"results/pull\"\n", ""), ""},
      {replaced("value = \"2 kN\"\n", ""), ""},
      {replaced("deviation = 20\n", ""), ""},
      {replaced("deviation = 20", "deviation = true"), ""},
      {replaced("held_back = true", "held_back = 1"), ""},
      {replaced("held_back = true", "held_bak = true"), ""},
      {replaced("deviation = 20\n", "deviation = 20\nheld_back = true\n"), "every value is held back"},
      {"[scenes]\n[variables.v]\nkey = \"k\"\nrange = [0, 1]\n[[measured]]\nscene = \"a\"\n",
       "1:1: scenes: is empty: a calibration needs at least one scene that was measured"},
      {"[scenes.a]\nscene = \"a.toml\"\n[variables]\n[[measured]]\nscene = \"a\"\nfigure = \"f\"\nvalue = "
       "1\ndeviation = 1\n",
       "3:1: variables: is empty: a calibration needs at least one unknown value"},
      {"[scenes.a]\nscene = \"a.toml\"\n[variables.v]\nkey = \"k\"\nrange = [0, 1]\n", ""},
  };
  for (const Wrong& wrong : all) {
    diagnostics_ = {};
    read(wrong.text);
    EXPECT_NE(error(), "") << wrong.text;
    EXPECT_NE(error().find(wrong.error), std::string::npos) << error() << "\nin\n" << wrong.text;
    EXPECT_TRUE(error().empty() || error()[0] != '0') << "has no place: " << error();
  }
}

}  // namespace
}  // namespace netloft::studies
