// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/scene_texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "io/studies/sensitivity/scene_numbers.hpp"
#include "tests/folders.hpp"

namespace netloft::design {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A separate folder for each test, which becomes the working folder.
class SceneTextsTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / "scene_texts" / info->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    before_ = fs::current_path();
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }
  static void write(const fs::path& name, const std::string& text) {
    if (name.has_parent_path()) fs::create_directories(name.parent_path());
    std::ofstream(name) << text;
  }
  static const std::string& root_of(const SceneTexts& texts) { return texts.own().at(texts.file().string()); }

 private:
  fs::path folder_, before_;
};

using Opened = SceneTextsTest;

constexpr const char* kRope = R"(# A rope.
[tow]
speed   =  "3.0 kn"      # as measured

[points.end]
at = ["1 m", -2.5,  "3 m"]   # starboard
style = { colour = 'red', width = 3 }
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(Opened, ReplacesTheCharactersOfAValueAlone) {
  write("a.toml", kRope);
  const std::vector<std::array<std::string, 3>> edits{{"tow.speed=3.15 kn", "\"3.0 kn\"", "\"3.15 kn\""},
                                                      {"points.end.at[1]=-2", "-2.5", "-2"},
                                                      {"points.end.at[2]=4 m", "\"3 m\"", "\"4 m\""},
                                                      {"points.end.style.width=12", "3 }", "12 }"},
                                                      {"points.end.style.colour=blue", "'red'", "\"blue\""}};
  for (const auto& [change, from, to] : edits) {
    SceneTexts texts("a.toml", {});
    const Edit edit = texts.set(formats::read_change(change));
    EXPECT_EQ(root_of(texts), with(kRope, from, to)) << change;
    EXPECT_EQ(text_of("a.toml"), kRope) << "nothing is written before save()";
    EXPECT_TRUE(texts.undo());
    EXPECT_EQ(root_of(texts), kRope);
    EXPECT_TRUE(texts.redo());
    EXPECT_EQ(root_of(texts), with(kRope, from, to)) << edit.after;
    EXPECT_EQ(texts.save(), std::vector<std::string>{"a.toml"});
    EXPECT_EQ(text_of("a.toml"), with(kRope, from, to));
    write("a.toml", kRope);
  }
}

TEST_F(Opened, StatesANewKeyInTheTableThatOwnsIt) {
  write("a.toml", kRope);
  SceneTexts texts("a.toml", {});
  texts.set(formats::read_change("tow.leeway=1 deg"));
  EXPECT_EQ(root_of(texts), with(kRope, "[tow]\n", "[tow]\nleeway = \"1 deg\"\n"));
  texts.set(formats::read_change("points.end.style.dashed=true"));
  EXPECT_NE(root_of(texts).find("{ dashed = true, colour = 'red'"), std::string::npos);
  texts.set(formats::read_change("gear.nodes=500"));
  EXPECT_TRUE(root_of(texts).ends_with("\n[gear]\nnodes = 500\n"));
  texts.set(formats::read_change("title=x"));
  EXPECT_NE(root_of(texts).find("title = \"x\"\n[tow]"), std::string::npos) << root_of(texts);
  while (texts.undo()) {
  }
  EXPECT_EQ(root_of(texts), kRope);
}

TEST_F(Opened, CountsColumnsInCharactersAndKeepsEveryKindOfLine) {
  const std::string text =
      "[a]\r\n\"ä\" = { \"ü\" = [\"×\", 7] }  # é\r\nb = \"\"\"x\n\"#\" = 3\n\"\"\"\nc = 1\n";
  write("a.toml", text);
  SceneTexts texts("a.toml", {});
  texts.set(formats::read_change("a.\"ä\".\"ü\"[1]=8"));
  EXPECT_EQ(root_of(texts), with(text, "7", "8"));
  texts.set(formats::read_change("a.c=2"));
  EXPECT_EQ(root_of(texts), with(with(text, "7", "8"), "c = 1", "c = 2"));
}

TEST_F(Opened, OverridesInTheSceneWhatAFileOfOthersSays) {
  write("library/gear.toml",
        "# theirs\n[rope]\nlength = \"5 m\"\nat = [1, 2, 3]\n[[hold]]\nat = [0, 0, 0]\n");
  write("own/a.toml", "include = [\"../library/gear.toml\"]  # the gear\n");
  SceneTexts texts("own/a.toml", "library");
  texts.set(formats::read_change("rope.length=6 m"));
  EXPECT_EQ(root_of(texts), "include = [\"../library/gear.toml\"]  # the gear\n\n[rope]\nlength = \"6 m\"\n");
  texts.set(formats::read_change("rope.at[1]=7"));
  EXPECT_NE(root_of(texts).find("[rope]\nat = [1, 7, 3]\nlength"), std::string::npos) << root_of(texts);
  texts.set(formats::read_change("hold[0].at[0]=1"));  // an assigned array replaces the old one, whereas a
                                                       // [[hold]] would append to it
  EXPECT_TRUE(root_of(texts).find("hold = [\n  {at = [1, 0, 0]},\n]\n") != std::string::npos)
      << root_of(texts);
  texts.save();
  EXPECT_EQ(text_of("library/gear.toml").substr(0, 8), "# theirs");
}

TEST_F(Opened, EditsAnIncludeOfOnesOwnWhereItStands) {
  write("parts/rope.toml", "[rope]\nlength = \"5 m\"  # new\n");
  write("a.toml", "include = [\"parts/rope.toml\"]\n");
  SceneTexts texts("a.toml", {});
  EXPECT_EQ(texts.set(formats::read_change("rope.length=6 m")).file, "parts/rope.toml");
  EXPECT_EQ(texts.own().at("parts/rope.toml"), "[rope]\nlength = \"6 m\"  # new\n");
}

TEST_F(Opened, MakesAVariantOfASceneOfTheLibrary) {
  write("library/a.toml", "[tow]\nspeed = 1\n");
  write("a-variant.toml", "mine");
  SceneTexts texts("library/a.toml", "library");
  EXPECT_EQ(texts.file(), "a-variant-2.toml");
  texts.set(formats::read_change("tow.speed=2"));
  EXPECT_FALSE(texts.is_saved());
  texts.save();
  EXPECT_EQ(text_of("a-variant-2.toml"),
            "# A variant of a.\ninclude = [\"library/a.toml\"]\n\n[tow]\nspeed = 2\n");
  EXPECT_EQ(text_of("library/a.toml"), "[tow]\nspeed = 1\n");
}

TEST_F(Opened, WritesOutATableThatATextIsShortFor) {
  write("a.toml", "[parts.net]\ntwine = \"pe-4mm\"  # braided\n");
  SceneTexts texts("a.toml", {});
  texts.set(formats::read_change("parts.net.twine.EA=4000"));
  EXPECT_EQ(root_of(texts), "[parts.net]\ntwine = {part = \"pe-4mm\", EA = 4000}  # braided\n");
}

TEST_F(Opened, UndoesTheStepsOfOneGestureTogether) {
  write("a.toml", kRope);
  SceneTexts texts("a.toml", {});
  texts.set(formats::read_change("tow.speed=3.1 kn"));
  for (const char* value : {"3.25", "3.5", "3", "10.125"})
    texts.set(formats::read_change(std::string("tow.speed=") + value + " kn"), true);
  texts.undo();
  EXPECT_EQ(root_of(texts), kRope);
  EXPECT_FALSE(texts.undo());
}

TEST_F(Opened, RefusesWhatCannotBeSetAndChangesNothing) {
  write("a.toml", kRope);
  SceneTexts texts("a.toml", {});
  for (const char* change : {"points.end=3", "points.end.at[7]=1", "tow.speed.fast=1", "no path=1", "tow",
                             "points.end.at.x=1", "include=x"})
    EXPECT_THROW(texts.set(formats::read_change(change)), Refused) << change;
  texts.replace("a.toml", "[tow\n");
  EXPECT_THROW(texts.set(formats::read_change("tow.speed=1")), Refused);
  texts.undo();
  EXPECT_EQ(root_of(texts), kRope);
  EXPECT_THROW(texts.replace("b.toml", ""), Refused);
}

TEST_F(Opened, SavesNothingOutsideItsFolderAndNothingOverOthers) {
  write("own/a.toml", kRope);
  write("own/b.toml", "mine");
  SceneTexts texts("own/a.toml", {});
  for (const char* name : {"../x.toml", "/tmp/x.toml", "x", ".toml", "..", "b.toml", "x/y.toml", "x\n.toml",
                           ".x.toml", "x\\y.toml", ""})
    EXPECT_THROW(texts.save_as(name), Refused) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator("own"), {}), 2);
  texts.save_as("c.toml");
  EXPECT_EQ(texts.file(), "own/c.toml");
  EXPECT_EQ(text_of("own/c.toml"), kRope);
  write("own/c.toml", "theirs");
  texts.set(formats::read_change("tow.speed=1"));
  EXPECT_THROW(texts.save(), Refused);
  EXPECT_EQ(text_of("own/c.toml"), "theirs");
}

TEST_F(Opened, TakesOverWhatAnotherProgramWrites) {
  write("a.toml", kRope);
  SceneTexts texts("a.toml", {});
  EXPECT_TRUE(texts.reread().empty());
  write("a.toml", with(kRope, "3.0", "4.0"));
  EXPECT_EQ(texts.reread(), std::vector<std::string>{"a.toml"});
  EXPECT_EQ(root_of(texts), with(kRope, "3.0", "4.0"));
  texts.set(formats::read_change("tow.speed=5 kn"));
  write("a.toml", kRope);
  EXPECT_TRUE(texts.reread().empty()) << "an edit that is not saved is not lost";
}

/// Lines of a text that another text does not have at the same place.
std::size_t changed_lines(const std::string& a, const std::string& b) {
  std::istringstream x(a), y(b);
  std::size_t count = 0;
  for (std::string p, q; std::getline(x, p) && std::getline(y, q);) count += p != q;
  return count;
}

// Random edits of the numbers of whole gears: each changes one line and keeps its comment, and all of them
// can be undone.
TEST_F(Opened, KeepsEverythingElseInTwoHundredRandomEditsOfGears) {
  std::mt19937 dice(5);
  fs::copy(test::source_folder() + "/gear-library", "gears", fs::copy_options::recursive);
  for (const char* scene : {"gears/scenes/83-112-flume-3.0kn.toml", "gears/scenes/two-panel.toml",
                            "gears/scenes/gov-like-67m.toml", "gears/scenes/pelagic-with-doors.toml",
                            "gears/gears/four-panel.toml"}) {
    SceneTexts texts(scene, {});
    const auto first = texts.own();
    for (int i = 0; i < 40; ++i) {
      formats::Diagnostics said;
      const auto numbers = studies::numbers_of(texts.document(said).root());
      const auto& number = numbers.at(dice() % numbers.size());
      const double factor = 0.5 + static_cast<double>(dice() % 1000) / 1000;
      const auto before = texts.own();
      try {
        const Edit edit = texts.set(number.to(number.value * factor).front());
        if (!before.contains(edit.file)) continue;
        EXPECT_EQ(std::ranges::count(edit.after, '#'), std::ranges::count(edit.before, '#'));
        if (std::ranges::count(edit.after, '\n') == 0)
          EXPECT_LE(changed_lines(before.at(edit.file), texts.own().at(edit.file)), 1u) << number.path;
      } catch (const Refused& refused) {
        ADD_FAILURE() << scene << ": " << number.path << ": " << refused.what();
      }
    }
    while (texts.undo()) {
    }
    EXPECT_EQ(texts.own(), first) << scene;
  }
}

}  // namespace
}  // namespace netloft::design
