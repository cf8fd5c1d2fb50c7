// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/table_reader.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::formats {
namespace {

using test::Input;

const RealSpec kStiffness{.unit = "N", .doc = "axial stiffness of one twine", .range = between(0, 1e9)};

TEST(TableReader, ReadsAnSiNumber) { EXPECT_EQ(Input("EA = 2.5").reader.real("EA", kStiffness), 2.5); }
TEST(TableReader, ReadsAnIntegerAsANumber) { EXPECT_EQ(Input("EA = 2").reader.real("EA", kStiffness), 2); }
TEST(TableReader, ReadsATextWithAUnit) {
  EXPECT_EQ(Input("EA = \"10 kN\"").reader.real("EA", kStiffness), 1e4);
}

TEST(TableReader, SaysWhichRangeAValueIsOutside) {
  Input in("[twine]\nEA = -5\n");
  in.reader.table("twine").real("EA", kStiffness);
  EXPECT_EQ(in.diagnostics.render(false),
            "net.toml:2:6: error: twine.EA = -5 N is outside [0, 1e9] N (axial stiffness of one twine)\n"
            "  2 | EA = -5\n"
            "    |      ^~\n");
}
TEST(TableReader, ShowsAnOpenEndAsAParenthesis) {
  Input in("d = 0");
  in.reader.real("d", {.unit = "m", .range = above(0)});
  EXPECT_EQ(in.error(), "1:5: d = 0 m is outside (0, inf) m");
}
TEST(TableReader, AcceptsTheEndsOfARange) {
  Input in("EA = 1e9");
  EXPECT_EQ(in.reader.real("EA", kStiffness), 1e9);
}
TEST(TableReader, NamesAWrongDimension) {
  Input in("d = \"10 kg\"");
  in.reader.real("d", {.unit = "m", .doc = "diameter"});
  EXPECT_EQ(in.error(), "1:5: d: \"10 kg\" is a mass (kg); a length (m) is expected (diameter)");
}
TEST(TableReader, PassesOnWhichUnitWasMeant) {
  Input in("d = \"10 metr\"");
  in.reader.real("d", {.unit = "m"});
  EXPECT_EQ(in.hint(), "did you mean \"metre\"?");
}
TEST(TableReader, SaysWhatItGotInsteadOfAQuantity) {
  Input in("d = true");
  in.reader.real("d", {.unit = "m", .doc = "diameter"});
  EXPECT_EQ(in.error(), "1:5: d is the boolean true; a length in m is expected (diameter)");
  EXPECT_EQ(in.hint(), "write an SI number or a text such as \"1 m\"");
}

class NotFinite : public ::testing::TestWithParam<const char*> {};
TEST_P(NotFinite, IsRefused) {
  Input in(std::string("d = ") + GetParam());
  in.reader.real("d", {.unit = "m"});
  EXPECT_NE(in.error().find("is not a finite number"), std::string::npos) << in.error();
}
INSTANTIATE_TEST_SUITE_P(TableReader, NotFinite, ::testing::Values("nan", "inf", "-inf", "\"inf m\""));

TEST(TableReader, ReturnsTheFallbackOfAMissingKey) {
  Input in("");
  EXPECT_EQ(in.reader.real("d", {.fallback = 7}), 7);
  EXPECT_EQ(in.error(), "");
}
TEST(TableReader, ReturnsTheFallbackAfterAnError) {
  EXPECT_EQ(Input("d = []").reader.real("d", {.fallback = 7}), 7);
}
TEST(TableReader, ReturnsAValueWithinTheRangeAfterAnError) {
  EXPECT_EQ(Input("d = []").reader.real("d", {.range = between(2, 4)}), 3);
  EXPECT_GT(Input("d = []").reader.real("d", {.range = above(0)}), 0);
  EXPECT_EQ(Input("n = []").reader.integer("n", {.lo = 2}), 2);
}
TEST(TableReader, LocatesAMissingKeyAtTheHeaderOfItsTable) {
  Input in("x = 1\n[twine]\n");
  in.reader.table("twine").real("EA", kStiffness);
  EXPECT_EQ(in.error(), "2:1: missing key \"EA\" in twine: a force in N (axial stiffness of one twine)");
}
TEST(TableReader, LocatesAMissingKeyAtItsInlineTable) {
  Input in("twine = { d = 1 }\n");
  in.reader.table("twine").real("EA", kStiffness);
  EXPECT_EQ(in.error(), "1:9: missing key \"EA\" in twine: a force in N (axial stiffness of one twine)");
}
TEST(TableReader, ShowsAllErrorsOfAFileByLine) {
  Input in("c = 1\nb = true\na = 3\n");
  in.reader.text("a", {});
  in.reader.integer("b", {});
  in.reader.boolean("c", {});
  std::vector<int> lines;
  for (const Diagnostic& entry : in.diagnostics.sorted()) lines.push_back(entry.place.line);
  EXPECT_EQ(lines, (std::vector<int>{1, 2, 3}));
}
TEST(TableReader, TellsAnErrorOnceThoughAskedTwice) {
  Input in("a = 3");
  in.reader.text("a", {});
  in.reader.text("a", {});
  EXPECT_EQ(in.diagnostics.errors(), 1);
}

TEST(TableReader, ReadsAnInteger) { EXPECT_EQ(Input("n = 32").reader.integer("n", {}), 32); }
TEST(TableReader, DoesNotRoundToAnInteger) {
  Input in("n = 32.5");
  in.reader.integer("n", {.doc = "meshes"});
  EXPECT_EQ(in.error(), "1:5: n is the number 32.5; an integer is expected (meshes)");
}
TEST(TableReader, ChecksTheRangeOfAnInteger) {
  Input in("n = 0");
  in.reader.integer("n", {.lo = 1, .hi = 99});
  EXPECT_EQ(in.error(), "1:5: n = 0 is outside [1, 99]");
}
TEST(TableReader, ReadsABoolean) { EXPECT_TRUE(Input("b = true").reader.boolean("b", {})); }
TEST(TableReader, DoesNotTakeANumberForABoolean) {
  Input in("b = 1");
  in.reader.boolean("b", {});
  EXPECT_EQ(in.error(), "1:5: b is the integer 1; true or false is expected");
}
TEST(TableReader, ReadsAText) { EXPECT_EQ(Input("t = \"x\"").reader.text("t", {}), "x"); }
TEST(TableReader, NamesADate) {
  Input in("t = 2020-01-02");
  in.reader.text("t", {});
  EXPECT_EQ(in.error(), "1:5: t is the date 2020-01-02; a text is expected");
}

const ChoiceSpec kKinds{.allowed = {"static", "dynamic"}, .doc = "kind of analysis"};
TEST(TableReader, ReadsAChoice) { EXPECT_EQ(Input("k = \"dynamic\"").reader.choice("k", kKinds), "dynamic"); }
TEST(TableReader, ListsTheChoices) {
  Input in("k = \"statik\"");
  EXPECT_EQ(in.reader.choice("k", kKinds), "static");
  EXPECT_EQ(in.error(), "1:5: k = \"statik\" is not one of \"static\", \"dynamic\" (kind of analysis)");
  EXPECT_EQ(in.hint(), "did you mean \"static\"?");
}

TEST(TableReader, ReadsAnArrayOfQuantities) {
  EXPECT_EQ(Input("z = [0, \"-50 m\"]").reader.reals("z", {.unit = "m"}), (std::vector<double>{0, -50}));
}
TEST(TableReader, ChecksTheLengthOfAnArray) {
  Input in("z = [0]");
  EXPECT_EQ(in.reader.reals("z", {.doc = "depths", .count = exactly(2)}).size(), 2u);
  EXPECT_EQ(in.error(), "1:5: z has 1 value; 2 are expected (depths)");
}
TEST(TableReader, NamesABadItemByItsIndex) {
  Input in("z = [0, \"3 s\"]");
  in.reader.reals("z", {.unit = "m"});
  EXPECT_EQ(in.error(), "1:9: z[1]: \"3 s\" is a time (s); a length (m) is expected");
}
TEST(TableReader, WantsAnArrayWhereOneIsDue) {
  Input in("z = 3");
  in.reader.reals("z", {.unit = "m"});
  EXPECT_EQ(in.error(), "1:5: z is the integer 3; an array of values in m is expected");
}
const RealsSpec kSpeeds{.unit = "m/s", .doc = "speeds", .range = between(-50, 50)};
TEST(TableReader, ReadsAnArrayWithOneUnit) {
  const auto read = Input("v = { unit = \"cm/s\", values = [35, 80.5] }").reader.reals("v", kSpeeds);
  EXPECT_EQ(read, (std::vector<double>{0.35, 0.805}));
}
TEST(TableReader, RefusesAnArrayWithoutItsUnit) {
  Input empty("v = { unit = \"\", values = [0, 3] }"), missing("v = { values = [0, 3] }");
  empty.reader.reals("v", kSpeeds);
  EXPECT_EQ(empty.error(), "1:14: v.unit: is empty");
  EXPECT_EQ(empty.hint(), "such as unit = \"m/s\"; SI numbers need no table: v = [0, 1]");
  EXPECT_EQ(empty.diagnostics.errors(), 1);
  missing.reader.reals("v", kSpeeds);
  EXPECT_EQ(missing.error(), "1:5: missing key \"unit\" in v: a text (unit of the values, such as m/s)");
}
TEST(TableReader, RefusesAnEmptyUnitOfPureNumbers) {
  Input in("f = { unit = \"\", values = [0, 1] }");
  in.reader.reals("f", {});
  EXPECT_EQ(in.hint(), "numbers without a unit need no table: f = [0, 1]");
}
TEST(TableReader, RefusesAWrongUnitOfAnArrayOnceAndNotItsValues) {
  Input in("v = { unit = \"kg\", values = [0, 300] }");
  in.reader.reals("v", kSpeeds);
  in.reader.finish();
  EXPECT_EQ(in.error(), "1:14: v.unit: \"1 kg\" is a mass (kg); a speed (m/s) is expected");
  EXPECT_EQ(in.diagnostics.errors(), 1);
}
TEST(TableReader, SaysTheUnitOfALimit) {
  Input in("v = { unit = \"kn\", values = [0, 180] }");
  in.reader.reals("v", kSpeeds);
  EXPECT_EQ(in.error(), "1:33: v.values[1] = 180 kn = 92.6 m/s is outside [-50, 50] m/s (speeds)");
}
TEST(TableReader, RefusesASecondUnitBesideThatOfTheArray) {
  Input in("v = { unit = \"kn\", values = [0, \"3 m/s\"] }");
  in.reader.reals("v", kSpeeds);
  EXPECT_EQ(in.error(), "1:33: v.values[1] is the text \"3 m/s\"; a number in kn is expected (speeds)");
}

const RealSpec kAngle{.unit = "rad", .range = between(-10, 10)};
TEST(TableReader, QuestionsWholeRadians) {
  Input in("a = 3");
  EXPECT_EQ(in.reader.real("a", kAngle), 3);
  EXPECT_EQ(in.error(), "1:5: a = 3 is in radians, which makes 171.9 degrees");
  EXPECT_EQ(in.hint(), "an angle in degrees is written \"30 deg\"");
  EXPECT_EQ(in.diagnostics.errors(), 0);
}
TEST(TableReader, QuestionsWholeRadiansOfAnArrayOnce) {
  Input in("a = [0, 5.0, 10, 15]");
  in.reader.reals("a", {.unit = "rad"});
  EXPECT_EQ(in.error(), "1:9: a[1] = 5 is in radians, which makes 286.5 degrees");
  EXPECT_EQ(in.diagnostics.warnings(), 1);
}
TEST(TableReader, TakesRadiansThatAreMeant) {
  Input in("a = 0\nb = 0.5\nc = \"3 rad\"\nd = { unit = \"rad\", values = [1, 2] }");
  for (const char* key : {"a", "b", "c"}) in.reader.real(key, kAngle);
  EXPECT_EQ(in.reader.reals("d", {.unit = "rad"}), (std::vector<double>{1, 2}));
  EXPECT_EQ(in.diagnostics.warnings() + in.diagnostics.errors(), 0);
}
TEST(TableReader, SuggestsDegreesForManyRadians) {
  Input in("a = 30");
  in.reader.real("a", kAngle);
  EXPECT_EQ(in.error(), "1:5: a = 30 rad is outside [-10, 10] rad");
  EXPECT_EQ(in.hint(), "an angle in degrees is written \"30 deg\"");
}
TEST(TableReader, ReadsRows) {
  Input in("sketch = [[-16, 0, 0], [\"16 m\", 0, -34]]");
  EXPECT_EQ(in.reader.rows("sketch", {.unit = "m", .columns = exactly(3)}),
            (std::vector<std::vector<double>>{{-16, 0, 0}, {16, 0, -34}}));
}
TEST(TableReader, ChecksTheLengthOfARow) {
  Input in("sketch = [[-16, 0, 0], [16, 0]]");
  in.reader.rows("sketch", {.unit = "m", .columns = exactly(3)});
  EXPECT_EQ(in.error(), "1:24: sketch[1] has 2 values; 3 are expected");
}
TEST(TableReader, ReadsIntegers) {
  EXPECT_EQ(Input("cells = [32, 16]").reader.integers("cells", {}), (std::vector<std::int64_t>{32, 16}));
}
TEST(TableReader, ReadsTexts) {
  EXPECT_EQ(Input("o = [\"a\", \"b\"]").reader.texts("o", {}), (std::vector<std::string>{"a", "b"}));
}

TEST(TableReader, ReportsAMissingTableOnceAndNotItsKeys) {
  Input in("");
  in.reader.table("water", Presence::required, "what the gear is towed through").real("density", {});
  EXPECT_EQ(in.error(), "1:1: missing key \"water\": a table (what the gear is towed through)");
  EXPECT_EQ(in.diagnostics.errors(), 1);
}
TEST(TableReader, ReadsDefaultsFromAnAbsentOptionalTable) {
  Input in("");
  EXPECT_EQ(in.reader.table("water", Presence::optional).real("density", {.fallback = 1025}), 1025);
  EXPECT_EQ(in.error(), "");
}
TEST(TableReader, MissesARequiredKeyOfAnAbsentOptionalTable) {
  Input in("[parts]\n");
  in.reader.table("parts").table("net", Presence::optional).text("type", {});
  EXPECT_EQ(in.error(), "1:1: missing key \"type\" in parts.net: a text");
}
TEST(TableReader, WantsATableWhereOneIsDue) {
  Input in("water = 3");
  in.reader.table("water").real("density", {});
  EXPECT_EQ(in.error(), "1:9: water is the integer 3; a table is expected");
  EXPECT_EQ(in.diagnostics.errors(), 1);
}
TEST(TableReader, NamesTablesOfAnArrayByTheirIndex) {
  Input in("[[hold]]\non = 'a'\n[[hold]]\n");
  for (TableReader& hold : in.reader.tables("hold")) hold.text("on", {});
  EXPECT_EQ(in.error(), "3:1: missing key \"on\" in hold[1]: a text");
}
TEST(TableReader, TellsHowToWriteAnArrayOfTables) {
  Input in("[hold]\non = 'a'\n");
  in.reader.tables("hold");
  EXPECT_EQ(in.hint(), "write each under a header [[hold]]");
}
TEST(TableReader, QuotesAKeyThatNeedsIt) {
  Input in("\"a b\".c = 1");
  EXPECT_EQ(in.reader.table("a b").path("c"), "\"a b\".c");
}

TEST(TableReader, TellsANameFromATable) {
  EXPECT_EQ(Input("twine = \"PE 4 mm\"").reader.kind("twine"), Kind::text);
  EXPECT_EQ(Input("twine = { d = 1 }").reader.kind("twine"), Kind::table);
  EXPECT_EQ(Input("").reader.kind("twine"), std::nullopt);
}
TEST(TableReader, PutsAnErrorOfItsCallerAtTheValue) {
  Input in("twine = \"PE 4 mm\"");
  in.reader.error("twine", "there is no \"PE 4 mm\" in the catalogue");
  EXPECT_EQ(in.error(), "1:9: twine: there is no \"PE 4 mm\" in the catalogue");
}

TEST(TableReader, SuggestsTheKeyThatWasMeant) {
  Input in("[twine]\ndiametre = 1\n");
  in.reader.table("twine").real("diameter", {.fallback = 1});
  in.reader.finish();
  EXPECT_EQ(in.error(), "2:1: unknown key \"diametre\" in twine");
  EXPECT_EQ(in.hint(), "did you mean \"diameter\"?");
}
TEST(TableReader, ListsTheAllowedKeysWhenNothingIsNear) {
  Input in("colour = 1\n");
  in.reader.real("diameter", {.fallback = 1});
  in.reader.real("EA", {.fallback = 1});
  in.reader.finish();
  EXPECT_EQ(in.hint(), "allowed here: \"diameter\", \"EA\"");
}
TEST(TableReader, FindsUnknownKeysInTablesOfAnArray) {
  Input in("[[hold]]\non = 'a'\nta = 'b'\n");
  for (TableReader& hold : in.reader.tables("hold")) hold.text("on", {});
  in.reader.finish();
  EXPECT_EQ(in.error(), "3:1: unknown key \"ta\" in hold[0]");
}
TEST(TableReader, ReportsAnUnknownTableByItsNameOnly) {
  Input in("[wind]\na = 1\nb = 2\n");
  in.reader.finish();
  EXPECT_EQ(in.diagnostics.errors(), 1);
  EXPECT_EQ(in.error(), "1:2: unknown key \"wind\"");
}
TEST(TableReader, KnowsKeysAskedForThroughEitherOfTwoReaders) {
  Input in("[twine]\na = 1\nb = 2\n");
  in.reader.table("twine").integer("a", {});
  in.reader.table("twine").integer("b", {});
  in.reader.finish();
  EXPECT_EQ(in.error(), "");
}
TEST(TableReader, LeavesToTheCallerWhatWasTakenRaw) {
  Input in("newton = { a = 1 }\n");
  EXPECT_EQ(in.reader.raw("newton")->kind(), Kind::table);
  in.reader.finish();
  EXPECT_EQ(in.error(), "");
}

}  // namespace
}  // namespace netloft::formats
