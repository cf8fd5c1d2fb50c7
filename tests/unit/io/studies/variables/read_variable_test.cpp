// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/read_variable.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::studies {
namespace {

using formats::test::Input;
using Words = std::vector<std::string>;

struct Read {
  explicit Read(const std::string& text, VariedBy by = VariedBy::values_or_interval)
      : in("[variables.v]\n" + text),
        variable(read_variable("v", in.reader.table("variables").table("v"), by)) {
    in.reader.finish();
  }
  Input in;
  Variable variable;
};

TEST(Variable, ListsQuantitiesAsTheyAreWritten) {
  const Read r("key = \"tow.speed\"\nvalues = [\"2.5 kn\", \"3 kn\"]");
  EXPECT_EQ(r.in.error(), "");
  EXPECT_EQ(r.variable.unit, "kn");
  EXPECT_TRUE(r.variable.is_number());
  EXPECT_EQ(r.variable.values[0].number, 2.5);
  EXPECT_EQ(r.variable.overrides(r.variable.values[1]), Words{"tow.speed=3 kn"});
}
TEST(Variable, ConvertsIntoTheUnitOfTheFirst) {
  const Read r("key = \"a\"\nvalues = [\"1 km\", \"250 m\"]");
  EXPECT_EQ(r.variable.values[1].number, 0.25);
  EXPECT_EQ(r.variable.values[1].text, "250 m");
}
TEST(Variable, ListsNumbersWithoutUnits) {
  const Read r("key = \"gear.nodes\"\nvalues = [500, 2000]");
  EXPECT_EQ(r.variable.unit, "");
  EXPECT_EQ(r.variable.overrides(r.variable.values[0]), Words{"gear.nodes=500"});
}
TEST(Variable, ListsNamesOfParts) {
  const Read r("key = \"twine\"\nvalues = [\"pe-braided-4mm\", \"83-112-fore\"]");
  EXPECT_EQ(r.in.error(), "");
  EXPECT_FALSE(r.variable.is_number());
  EXPECT_EQ(r.variable.overrides(r.variable.values[0]), Words{"twine=pe-braided-4mm"});
  EXPECT_EQ(r.variable.overrides(r.variable.values[1]), Words{"twine=\"83-112-fore\""});
}
TEST(Variable, HasAnInterval) {
  const Read r("key = \"EA\"\nrange = [\"40 kN\", \"0.06 MN\"]");
  EXPECT_EQ(r.variable.unit, "kN");
  EXPECT_EQ(r.variable.interval->low, 40);
  EXPECT_DOUBLE_EQ(r.variable.interval->high, 60);
  EXPECT_EQ(r.variable.overrides(r.variable.value_of(52.5)), Words{"EA=52.5 kN"});
}
TEST(Variable, LetsSeveralKeysGoTogether) {
  const Read r(
      "key = [\"bed.depth\", { key = \"end.at[2]\", factor = -1, offset = \"50 cm\" }]\nvalues = [\"20 m\"]");
  EXPECT_EQ(r.in.error(), "");
  EXPECT_EQ(r.variable.overrides(r.variable.values[0]), (Words{"bed.depth=20 m", "end.at[2]=-19.5 m"}));
}
TEST(Variable, ReadsNumbersInItsUnit) {
  Read r("key = \"a\"\nrange = [\"1 m\", \"2 m\"]");
  Input in("mean = \"150 cm\"\nother = 3");
  EXPECT_EQ(read_number_of(r.variable, in.reader, "mean", "the middle"), 1.5);
  EXPECT_FALSE(read_number_of(r.variable, in.reader, "other", "the middle"));
  EXPECT_FALSE(read_number_of(r.variable, in.reader, "none", "the middle"));
  EXPECT_EQ(in.diagnostics.errors(), 2);
}

struct Wrong {
  const char *text, *error;
};

class WrongVariable : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongVariable, IsRefusedAtItsPlace) { EXPECT_EQ(Read(GetParam().text).in.error(), GetParam().error); }

INSTANTIATE_TEST_SUITE_P(
    All, WrongVariable,
    ::testing::Values(
        Wrong{"key = \"a\"", "1:1: variables.v has no values and no range"},
        Wrong{"values = [1]",
              "1:1: variables.v.key is missing (key of the scene that is varied, as --set takes it)"},
        Wrong{"key = \"a\"\nvalues = []", "3:10: variables.v.values is empty (values of the variable)"},
        Wrong{"key = \"a\"\nvalues = 3", "3:10: variables.v.values is not an array (values of the variable)"},
        Wrong{"key = \"a\"\nvalues = [1]\nrange = [0, 1]",
              "4:9: variables.v.range: a variable has either values or a range, not both"},
        Wrong{"key = \"a\"\nvalues = [1, 2, 1]", "3:17: variables.v.values: 1 is given twice"},
        Wrong{"key = \"a\"\nvalues = [\"1 m\", \"100 cm\"]",
              "3:18: variables.v.values: 100 cm is given twice"},
        Wrong{"key = \"a\"\nvalues = [\"1 m\", 2]",
              "3:18: variables.v: either all numbers have a unit, or none has"},
        Wrong{"key = \"a\"\nvalues = [\"1 m\", \"1 kg\"]",
              "3:18: variables.v: \"1 kg\" is a mass (kg); a length (m) is expected"},
        Wrong{"key = \"a\"\nrange = [\"2 m\", \"1 m\"]",
              "3:9: variables.v.range: 2 m is not less than 1 m (least and largest value of the variable)"},
        Wrong{"key = \"a\"\nrange = [\"2 m\"]",
              "3:9: variables.v.range is not an array of two (least and largest value of the variable)"},
        Wrong{"key = \"a\"\nrange = [\"x\", \"y\"]", "3:10: variables.v: a number is expected, such as 1"},
        Wrong{"key = []\nvalues = [1]",
              "2:7: variables.v.key is empty (key of the scene that is varied, as --set takes it)"},
        Wrong{"key = [{ key = \"a\", factr = 2 }]\nvalues = [1]",
              "2:21: unknown key \"factr\" in variables.v.key"},
        Wrong{"key = { key = \"a\", factor = 2 }\nvalues = [\"x\"]",
              "2:7: variables.v: only numbers have a factor and an offset"},
        Wrong{"key = \"a\"\nvalues = [1]\nvalue = 2", "4:1: unknown key \"value\" in variables.v"}));

TEST(Variable, OfACalibrationHasARangeOnly) {
  EXPECT_EQ(Read("key = \"a\"\nvalues = [1]", VariedBy::interval).in.error(),
            "1:1: variables.v has no range");
}

}  // namespace
}  // namespace netloft::studies
