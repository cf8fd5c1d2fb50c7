// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::studies {
namespace {

constexpr const char* kGoodStudy = R"(scene = "a.toml"
set = ["gear.nodes=500"]
[design]
samples = 3
[variables.speed]
key = "tow.speed"
values = ["2 kn", "3 kn"]
[variables.twine]
key = "twine"
values = ["x", "y"]
[variables.mass]
key = "mass"
range = ["1 kg", "2 kg"]
)";

class StudyFileTest : public formats::test::Scratch {
 protected:
  StudyFile read(const std::string& text) { return read_study_file(write("s.toml", text), diagnostics_); }
  /// The first error as "line:column: message".
  std::string error() const {
    const auto all = diagnostics_.sorted();
    if (all.empty()) return {};
    return std::to_string(all[0].place.line) + ":" + std::to_string(all[0].place.column) + ": " +
           all[0].message;
  }
  static std::string with(const std::string& change) { return std::string(kGoodStudy) + change; }
  static std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  }
};

TEST_F(StudyFileTest, SaysWhatIsVaried) {
  const StudyFile study = read(kGoodStudy);
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(study.name, "s");
  EXPECT_EQ(study.scene, "a.toml");
  EXPECT_EQ(study.samples, 3u);
  ASSERT_EQ(study.variables.size(), 3u);
  EXPECT_TRUE(study.variables[2].is_sampled());
  EXPECT_EQ(count_points(study), 12);
}
TEST_F(StudyFileTest, TakesListedNumbersIntoThePathUnlessItIsSaid) {
  const StudyFile study = read(kGoodStudy);
  EXPECT_TRUE(study.variables[0].is_in_path);
  EXPECT_FALSE(study.variables[1].is_in_path);
  EXPECT_FALSE(study.variables[2].is_in_path);
}
TEST_F(StudyFileTest, LeavesEveryPointToItselfWithAnEmptyPath) {
  const StudyFile study = read("path = []\n" + with(""));
  EXPECT_EQ(errors(), "");
  for (const auto& v : study.variables) EXPECT_FALSE(v.is_in_path);
}
TEST_F(StudyFileTest, WantsOnlyInputsThatAreThere) {
  struct Wrong {
    std::string text, error;
  };
  const Wrong all[] = {
      {replaced(kGoodStudy, "scene", "scne"),
       "1:1: missing key \"scene\": a text (the scene that is varied, relative to this file)"},
      {"path = [\"sped\"]\n" + with(""), "1:8: path: there is no variable \"sped\""},
      {"path = [\"mass\"]\n" + with(""),
       "1:8: path: mass is sampled from a range; a path goes through listed values"},
      {"path = [\"speed\", \"speed\"]\n" + with(""), "1:8: path: speed is named twice"},
      {replaced(kGoodStudy, "samples = 3", "samples = 0"),
       "3:1: design.samples is missing or zero: variables with a range are sampled"},
      {replaced(kGoodStudy, "samples = 3", "sample = \"sobl\""),
       "3:1: design.samples is missing or zero: variables with a range are sampled"},
      {replaced(kGoodStudy, "\"twine\"\n", "\"tow.speed\"\n"), "8:1: tow.speed is varied by speed already"},
      {replaced(kGoodStudy, "[variables.mass]", "[variables.\"m s\"]"),
       "11:1: the name of a variable, \"m s\", must consist of letters, digits, - and _"},
      {replaced(with(""), "samples = 3",
                "samples = 3\ncombine = \"list\"\n[variables.one]\nkey = \"k\"\nvalues = [1]"),
       "9:1: speed has 2 values, one has 1; in a list, the first values go together, the second values, and "
       "so on"},
      {with("distribution = \"normal\""),
       "11:1: variables.mass.mean: is missing (the middle of the normal distribution)"},
      {with("distribution = \"normal\"\nmean = \"5 kg\"\ndeviation = \"1 kg\""),
       "15:8: variables.mass.mean: lies outside the range, at which the distribution is cut off"},
      {with("distribution = \"normal\"\nmean = \"1.5 kg\"\ndeviation = 0"),
       "16:13: variables.mass.deviation: a number is expected like those of the range, such as 1 kg "
       "(standard "
       "deviation of the normal distribution)"},
      {replaced(with("distribution = \"logarithmic\""), "[\"1 kg\"", "[\"0 kg\""),
       "13:9: variables.mass.range: must be above zero for a logarithmic distribution"},
      {"scene = \"a.toml\"\n[variables]\n", "2:1: variables: is empty: a study needs at least one variable"},
      {"scene = \"a.toml\"\n[variables.v]\nkey = \"k\"\nvalues = [1]\n[design]\nsamples = 2",
       "6:11: design.samples: there is no variable with a range to sample from"},
  };
  for (const Wrong& wrong : all) {
    diagnostics_ = {};
    read(wrong.text);
    EXPECT_EQ(error(), wrong.error) << wrong.text;
  }
}

}  // namespace
}  // namespace netloft::studies
