// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/change.hpp"

#include "io/formats/toml/spelled_value.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::formats {
namespace {

using test::Input;

const char* const kScene =
    "[parts.net]\ncells = [32, 32]\ntwine = { EA = 1, density = 2 }\n[[hold]]\non = \"net.fore\"\n";

TEST(Change, ReplacesAValue) {
  Input in(kScene, {"parts.net.cells=[64,64]"});
  EXPECT_EQ(in.reader.table("parts").table("net").integers("cells", {}), (std::vector<std::int64_t>{64, 64}));
}
TEST(Change, AddsAKey) {
  Input in(kScene, {"parts.net.twine.diameter=3"});
  EXPECT_EQ(in.reader.table("parts").table("net").table("twine").integer("diameter", {}), 3);
}
TEST(Change, MakesTheTablesOnItsWay) {
  Input in(kScene, {"water.current.speed=3"});
  EXPECT_EQ(in.reader.table("water").table("current").integer("speed", {}), 3);
}
TEST(Change, ReplacesAWholeTable) {
  Input in(kScene, {"parts.net.twine={ EA = 7 }"});
  EXPECT_EQ(in.reader.table("parts").table("net").table("twine").keys(), std::vector<std::string>{"EA"});
}
TEST(Change, ReplacesAnItemOfAnArray) {
  Input in(kScene, {"parts.net.cells[1]=64"});
  EXPECT_EQ(in.reader.table("parts").table("net").integers("cells", {}), (std::vector<std::int64_t>{32, 64}));
}
TEST(Change, ReachesIntoTheTablesOfAnArray) {
  Input in(kScene, {"hold[0].at=[[1, 2, 3]]", "hold[0].at[0][2]=7 m"});
  EXPECT_EQ(in.reader.tables("hold")[0].rows("at", {.unit = "m"}),
            (std::vector<std::vector<double>>{{1, 2, 7}}));
}
/// A document with `twine = "pe"`, to which a change such as net.twine.EA=… was applied.
Value with_overridden_part(const std::string& change, Diagnostics& diagnostics) {
  Value root = Document::parse("[net]\ntwine = \"pe\"\ntitle = \"pe\"\n", "net.toml", {}, diagnostics).root();
  apply(root, read_change(change), diagnostics, {{"rope", "twine"}, "part"});
  return root;
}

TEST(Change, WritesOutATextThatIsShortForATable) {
  Diagnostics diagnostics;
  const Value root = with_overridden_part("net.twine.EA=3 kN", diagnostics);
  EXPECT_EQ(spell_value(root), "{net = {twine = {part = \"pe\", EA = \"3 kN\"}, title = \"pe\"}}");
  EXPECT_EQ(diagnostics.errors(), 0);
  const Table* twine = root.as<Table>()->find("net")->value.as<Table>()->find("twine")->value.as<Table>();
  EXPECT_EQ(twine->find("part")->value.place.line, 2) << "the name keeps its place in the file";
}
TEST(Change, LeavesOtherTextsAsTheyAre) {
  Diagnostics diagnostics;
  with_overridden_part("net.title.EA=3", diagnostics);
  EXPECT_EQ(diagnostics.sorted().at(0).message, "net.title is not a table, so net.title.EA cannot be set");
}
TEST(Change, RefusesItemsThatAreNotThere) {
  EXPECT_EQ(Input(kScene, {"parts.net.cells[2]=1"}).error(),
            "1:1: parts.net.cells has 2 items, so there is no parts.net.cells[2]");
  EXPECT_EQ(Input(kScene, {"parts.net[0]=1"}).error(),
            "1:1: parts.net is not an array in the scene, so parts.net[0] cannot be set");
  for (const char* path : {"[0]", "hold[", "hold[]", "hold[x]", "hold[-1]", "hold[0]x", "hold[0].",
                           "hold[99999999999999999999]"})
    EXPECT_TRUE(Input(kScene, {std::string(path) + "=1"}).error().ends_with("is not a path of dotted keys"))
        << path;
}
TEST(Change, LeavesBracketsInQuotesAlone) {
  Input in(kScene, {"\"a[0]\".b=3"});
  EXPECT_EQ(in.reader.table("a[0]").integer("b", {}), 3);
}
TEST(Change, TakesABareWordAsAText) {
  Input in(kScene, {"solver=newton"});
  EXPECT_EQ(in.reader.text("solver", {}), "newton");
}
TEST(Change, TakesANumberWithAUnitAsAText) {
  Input in(kScene, {"bar = 0.6 m"});
  EXPECT_EQ(in.reader.real("bar", {.unit = "m"}), 0.6);
}
TEST(Change, TakesNothingAsAnEmptyText) {
  Input in(kScene, {"solver="});
  EXPECT_EQ(in.reader.text("solver", {.fallback = "x"}), "");
}
TEST(Change, TakesAValueThatBringsASecondKeyAsAText) {
  Input in(kScene, {"a=1\nb=2"});
  EXPECT_EQ(in.reader.text("a", {}), "1\nb=2");
  EXPECT_FALSE(in.reader.has("b"));
}
TEST(Change, AcceptsQuotedKeys) {
  Input in(kScene, {"\"a=b\".c=3"});
  EXPECT_EQ(in.reader.table("a=b").integer("c", {}), 3);
}
TEST(Change, LetsTheLastOneWin) {
  Input in(kScene, {"a=1", "a=2"});
  EXPECT_EQ(in.reader.integer("a", {}), 2);
}
TEST(Change, ShowsItselfAsThePlaceOfItsValue) {
  Input in(kScene, {"parts.net.cells=[64,x4]", "parts.net.cells=[64,-4]"});
  in.reader.table("parts").table("net").integers("cells", {.lo = 1});
  EXPECT_EQ(in.diagnostics.render(false),
            "--set parts.net.cells: error: parts.net.cells[1] = -4 is outside [1, inf)\n"
            "  1 | parts.net.cells=[64,-4]\n"
            "    |                     ^~\n");
}
TEST(Change, DoesNotWalkThroughAValue) {
  EXPECT_EQ(Input(kScene, {"parts.net.cells.x=1"}).error(),
            "1:1: parts.net.cells is not a table, so parts.net.cells.x cannot be set");
}
TEST(Change, DoesNotWalkThroughAnArrayOfTables) {
  EXPECT_EQ(Input(kScene, {"hold.on=1"}).hint(),
            "set the whole array: hold=[...], or one of its items: hold[0]=...");
}
TEST(Change, DoesNotWalkThroughWhatAnotherOneSet) {
  EXPECT_EQ(Input(kScene, {"a=1", "a.b=2"}).error(), "1:1: a is not a table, so a.b cannot be set");
}
TEST(Change, WantsAnEqualsSign) {
  EXPECT_EQ(Input(kScene, {"parts.net"}).error(), "1:1: there is no '=' in parts.net");
}
TEST(Change, CannotSetInclude) {
  EXPECT_EQ(Input(kScene, {"include=[]"}).error(),
            "1:1: include cannot be set: files are read before values are set");
}

TEST(Change, FindsNoEqualsSignInAKeyThatIsNeverClosed) {
  EXPECT_EQ(Input(kScene, {"\"a=1"}).error(), "1:1: there is no '=' in \"a=1");
}

TEST(Change, MadeOfKeysIsThatOfItsText) {
  for (const Change& made :
       {make_change({"parts", "a b", "cells"}, {{}, Array{{{{}, std::int64_t{4}}, {{}, std::int64_t{8}}}}}),
        make_change({"analysis", "tolerance"}, {{}, 1e-8}), make_change({"on"}, {{}, false}),
        make_change({"tow", "speed"}, {{}, std::string("3 kn")})}) {
    const Change read = read_change(made.text);
    EXPECT_EQ(made.path, read.path);
    EXPECT_EQ(made.steps, read.steps);
    EXPECT_EQ(made.value.kind(), read.value.kind()) << made.text;
    EXPECT_EQ(spell_value(made.value), spell_value(read.value));
  }
}

class BadPath : public ::testing::TestWithParam<const char*> {};
TEST_P(BadPath, IsRefused) {
  Input in(kScene, {std::string(GetParam()) + "=1"});
  EXPECT_NE(in.error().find("is not a path of dotted keys"), std::string::npos) << in.error();
}
INSTANTIATE_TEST_SUITE_P(Change, BadPath,
                         ::testing::Values("", ".", "a.", "a..b", "a b", "hold[0", "[a]", "#", "a\nb", "é"));

}  // namespace
}  // namespace netloft::formats
