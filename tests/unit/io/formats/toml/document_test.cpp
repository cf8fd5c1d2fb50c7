// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/document.hpp"

#include "io/formats/toml/spelled_value.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::formats {
namespace {

using test::Input;

class DocumentTest : public test::Scratch {
 protected:
  std::int64_t integer(const Document& document, const std::string& key) {
    return TableReader(document.root(), diagnostics_).integer(key, {});
  }
};

TEST_F(DocumentTest, KeepsThePlaceOfEveryValue) {
  Input in("[parts.net]\ntwine = { EA = -5 }\n");
  TableReader twine = in.reader.table("parts").table("net").table("twine");
  EXPECT_EQ(in.diagnostics.where(twine.place("EA")), "net.toml:2:16");
}

TEST_F(DocumentTest, KeepsKeysInTheOrderTheyWereWritten) {
  Input in("zebra = 1\napple = 2\nmango = 3\n");
  EXPECT_EQ(in.reader.keys(), (std::vector<std::string>{"zebra", "apple", "mango"}));
}

TEST_F(DocumentTest, LocatesAMistakeInTheGrammar) {
  Input in("a = 1\na = 2\n");
  EXPECT_EQ(in.error(), "2:5: cannot read the key-value pair: cannot redefine existing integer 'a'");
}

TEST_F(DocumentTest, TellsHowToWriteAUnit) {
  EXPECT_EQ(Input("bar = 0.6 m\n").hint(), "a number with a unit is written in quotes: \"10 mm\"");
}

TEST_F(DocumentTest, ReadsAnIncludeBesideTheFileThatNamesIt) {
  write("water/still.toml", "density = 1025\n");
  write("scenes/a.toml", "include = [\"../water/still.toml\"]\n");
  EXPECT_EQ(integer(load("scenes/a.toml"), "density"), 1025);
  EXPECT_EQ(errors(), "");
}

TEST_F(DocumentTest, ReadsIncludesOfIncludes) {
  write("deep/c.toml", "x = 3\n");
  write("deep/b.toml", "include = [\"c.toml\"]\n");
  write("a.toml", "include = [\"deep/b.toml\"]\n");
  EXPECT_EQ(integer(load("a.toml"), "x"), 3);
}

TEST_F(DocumentTest, TakesItsOwnKeysBeforeIncludedOnes) {
  write("b.toml", "x = 1\n");
  write("a.toml", "include = [\"b.toml\"]\nx = 2\n");
  EXPECT_EQ(integer(load("a.toml"), "x"), 2);
}

TEST_F(DocumentTest, TakesTheLaterInclude) {
  write("b.toml", "x = 1\n");
  write("c.toml", "x = 2\n");
  write("a.toml", "include = [\"b.toml\", \"c.toml\"]\n");
  EXPECT_EQ(integer(load("a.toml"), "x"), 2);
}

TEST_F(DocumentTest, MergesTablesKeyByKey) {
  write("b.toml", "[water]\ndensity = 1000\ngravity = 9\n");
  write("a.toml", "include = [\"b.toml\"]\n[water]\ndensity = 1025\n");
  const Document document = load("a.toml");
  TableReader water = TableReader(document.root(), diagnostics_).table("water");
  EXPECT_EQ(water.integer("density", {}), 1025);
  EXPECT_EQ(water.integer("gravity", {}), 9);
}

TEST_F(DocumentTest, KeepsThePlaceOfAnIncludedValue) {
  write("b.toml", "[water]\ndensity = 1000\n");
  write("a.toml", "include = [\"b.toml\"]\n[water]\n");
  const Document document = load("a.toml");
  TableReader(document.root(), diagnostics_).table("water").text("density", {});
  EXPECT_TRUE(
      errors().starts_with("b.toml:2:11: error: water.density is the integer 1000; a text is expected"))
      << errors();
}

TEST_F(DocumentTest, ReplacesArrays) {
  write("b.toml", "cells = [1, 2, 3]\n");
  write("a.toml", "include = [\"b.toml\"]\ncells = [4]\n");
  const Document document = load("a.toml");
  EXPECT_EQ(TableReader(document.root(), diagnostics_).integers("cells", {}), (std::vector<std::int64_t>{4}));
}

TEST_F(DocumentTest, AppendsTablesUnderDoubleBracketsIncludedFirst) {
  write("b.toml", "[[hold]]\non = \"included\"\n");
  write("a.toml", "include = [\"b.toml\"]\n[[hold]]\non = \"own\"\n");
  const Document document = load("a.toml");
  std::vector<std::string> on;
  for (TableReader& hold : TableReader(document.root(), diagnostics_).tables("hold"))
    on.push_back(hold.text("on", {}));
  EXPECT_EQ(on, (std::vector<std::string>{"included", "own"}));
}

TEST_F(DocumentTest, LeavesOutWhatAFileDoesWithout) {
  write("b.toml",
        "[floats.headline]\nspread = 4\n[floats.wing]\nspread = 2\n[tow]\nspeed = 1\nheading = 2\n");
  write("a.toml",
        "include = [\"b.toml\"]\nwithout = [\"floats.wing\", \"tow.heading\"]\n[floats.headline]\nnumber = "
        "3\n");
  const Document document = load("a.toml");
  ASSERT_EQ(diagnostics_.errors(), 0u);
  TableReader root(document.root(), diagnostics_);
  EXPECT_EQ(root.table("floats").keys(), (std::vector<std::string>{"headline"}));
  EXPECT_EQ(root.table("tow").keys(), (std::vector<std::string>{"speed"}));
  EXPECT_EQ(root.table("floats").table("headline").keys(), (std::vector<std::string>{"spread", "number"}));
}

TEST_F(DocumentTest, SaysWhatCannotBeLeftOut) {
  write("b.toml", "[floats.wing]\nspread = 2\n[[hold]]\non = \"a\"\n");
  write("a.toml", "include = [\"b.toml\"]\nwithout = [\"floats.wings\", \"hold[0]\", 3]\n");
  load("a.toml");
  ASSERT_EQ(diagnostics_.errors(), 3u);
  const auto said = diagnostics_.sorted();
  EXPECT_EQ(said[0].message, "without: the included files have no floats.wings");
  EXPECT_EQ(said[0].hint, "did you mean \"wing\"?");
  EXPECT_NE(said[1].hint.find("state the array again"), std::string::npos);
  EXPECT_NE(said[2].hint.find("without = [\"floats.headline\"]"), std::string::npos);
}

TEST_F(DocumentTest, ReplacesTablesByAnInlineArray) {
  write("b.toml", "[[hold]]\non = \"included\"\n");
  write("a.toml", "include = [\"b.toml\"]\nhold = [{ on = \"own\" }]\n");
  const Document document = load("a.toml");
  EXPECT_EQ(TableReader(document.root(), diagnostics_).tables("hold").size(), 1u);
}

TEST_F(DocumentTest, ReplacesAnInlineTableByAName) {
  write("b.toml", "twine = { EA = 1 }\n");
  write("a.toml", "include = [\"b.toml\"]\ntwine = \"PE 4 mm\"\n");
  const Document document = load("a.toml");
  EXPECT_EQ(TableReader(document.root(), diagnostics_).text("twine", {}), "PE 4 mm");
}

TEST_F(DocumentTest, ReadsAFileOnceThatIsIncludedTwice) {
  write("d.toml", "[[hold]]\non = \"d\"\n");
  write("b.toml", "include = [\"d.toml\"]\n");
  write("c.toml", "include = [\"./d.toml\"]\n");
  write("a.toml", "include = [\"b.toml\", \"c.toml\"]\n");
  const Document document = load("a.toml");
  EXPECT_EQ(TableReader(document.root(), diagnostics_).tables("hold").size(), 1u);
}

TEST_F(DocumentTest, ShowsTheChainOfAnIncludeCycle) {
  write("a.toml", "include = [\"b.toml\"]\n");
  write("b.toml", "include = [\"a.toml\"]\n");
  load("a.toml");
  EXPECT_EQ(errors(),
            "b.toml:1:12: error: include cycle: a.toml -> b.toml -> a.toml\n"
            "  1 | include = [\"a.toml\"]\n"
            "    |            ^~~~~~~~\n");
}

TEST_F(DocumentTest, FindsThatAFileIncludesItself) {
  write("a.toml", "include = [\"a.toml\"]\n");
  load("a.toml");
  EXPECT_NE(errors().find("include cycle: a.toml -> a.toml"), std::string::npos);
}

TEST_F(DocumentTest, EndsAnEndlessChainOfIncludes) {
  for (int i = 0; i < 100; ++i)
    write("f" + std::to_string(i) + ".toml", "include = [\"f" + std::to_string(i + 1) + ".toml\"]\n");
  load("f0.toml");
  EXPECT_NE(errors().find("includes are nested deeper than 32 files"), std::string::npos);
}

TEST_F(DocumentTest, LocatesAMissingIncludeAtItsEntry) {
  write("a.toml", "include = [\"nowhere.toml\"]\n");
  load("a.toml");
  EXPECT_TRUE(errors().starts_with("a.toml:1:12: error: nowhere.toml cannot be opened: No such file"))
      << errors();
}

TEST_F(DocumentTest, GoesOnAfterAMissingInclude) {
  write("a.toml", "include = [\"nowhere.toml\", \"neither.toml\"]\n");
  load("a.toml");
  EXPECT_EQ(diagnostics_.errors(), 2);
}

TEST_F(DocumentTest, WantsAnArrayOfIncludes) {
  write("a.toml", "include = \"b.toml\"\n");
  load("a.toml");
  EXPECT_NE(errors().find("a.toml:1:11: error: include is not an array"), std::string::npos);
}

TEST_F(DocumentTest, WantsNamesToInclude) {
  write("a.toml", "include = [3]\n");
  load("a.toml");
  EXPECT_NE(errors().find("a.toml:1:12: error: an include is the name of a file"), std::string::npos);
}

TEST_F(DocumentTest, DoesNotPassIncludeOnAsAKey) {
  write("a.toml", "include = []\n");
  const Document document = load("a.toml");
  TableReader(document.root(), diagnostics_).finish();
  EXPECT_EQ(errors(), "");
}

TEST_F(DocumentTest, SaysThatTheRootIsMissing) {
  load("nowhere.toml");
  EXPECT_EQ(errors(), "error: nowhere.toml cannot be opened: No such file or directory\n");
}

TEST_F(DocumentTest, RefusesAFolder) {
  std::filesystem::create_directories(folder_ / "a.toml");
  load("a.toml");
  EXPECT_EQ(errors(), "error: a.toml is a directory; a TOML file is expected\n");
}

TEST_F(DocumentTest, RefusesABinaryFile) {
  write("a.toml", std::string("a = 1\n\0\1", 8));
  load("a.toml");
  EXPECT_EQ(errors(), "error: a.toml is a binary file; a TOML file is expected\n");
}

TEST_F(DocumentTest, RefusesTextThatIsNotUtf8) {
  write("a.toml", "a = 1\nb = \"caf\xe9\"\n");
  load("a.toml");
  EXPECT_EQ(errors(), "error: a.toml is not UTF-8 text: line 2 has an invalid byte\n");
}

TEST_F(DocumentTest, RefusesAnEmptyFile) {
  write("a.toml", "\n \n");
  load("a.toml");
  EXPECT_EQ(errors(), "error: a.toml is empty\n");
}

TEST_F(DocumentTest, RefusesAFileThatIsTooLarge) {
  write("a.toml", std::string((16u << 20) + 1, '#'));
  load("a.toml");
  EXPECT_EQ(errors(), "error: a.toml is larger than 16 MiB, too large for a scene\n");
}

TEST_F(DocumentTest, ReadsWindowsLineEndsAndByteOrderMark) {
  write("a.toml", "\xef\xbb\xbfx = 1\r\ny = 2\r\n");
  EXPECT_EQ(integer(load("a.toml"), "y"), 2);
  EXPECT_EQ(errors(), "");
}

TEST_F(DocumentTest, ListsTheFilesItReadWithTheirText) {
  write("b.toml", "x = 1\n");
  const auto path = write("a.toml", "include = [\"b.toml\"]\n");
  const Document document = load("a.toml");
  ASSERT_EQ(document.files().size(), 2u);
  EXPECT_EQ(document.files()[0].path, path.lexically_normal());
  EXPECT_EQ(document.files()[1].text, "x = 1\n");
}

// Test vectors of draft-eastlake-fnv, appendix C.
TEST(Fnv1a64, OfNothingIsItsOffset) { EXPECT_EQ(fnv1a64(""), "fnv1a64:cbf29ce484222325"); }
TEST(Fnv1a64, OfFoobarIsThePublishedOne) { EXPECT_EQ(fnv1a64("foobar"), "fnv1a64:85944171f73967e8"); }

TEST_F(DocumentTest, RecallsStoredTextsWithoutOpeningFiles) {
  const std::string common = write("common.toml", "a = 1\n").string(),
                    scene = (folder_ / "scene.toml").string();
  const std::string text = "include = [\"common.toml\"]\nb = 2\n";
  const auto known = Document::recall({{scene, text, ""}, {common, "a = 3\nb = 4\n", ""}}, diagnostics_);
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(spell_value(known.root()), "{a = 3, b = 2}");
  Document::recall({{scene, text, ""}}, diagnostics_);
  EXPECT_NE(errors().find("common.toml was not stored"), std::string::npos);
}

}  // namespace
}  // namespace netloft::formats
