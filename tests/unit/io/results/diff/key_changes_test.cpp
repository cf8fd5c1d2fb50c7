// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/key_changes.hpp"

#include <gtest/gtest.h>

namespace netloft::results {
namespace {

/// The changes as a text such as "a.b: 1 -> 2; c: - -> 3".
std::string spelled(const std::optional<std::vector<KeyChange>>& changes) {
  if (!changes) return "not known";
  std::string text;
  for (const auto& change : *changes)
    text += (text.empty() ? "" : "; ") + change.path + ": " + (change.before.empty() ? "-" : change.before) +
            " -> " + (change.after.empty() ? "-" : change.after);
  return text;
}

std::string changes(const std::string& before, const std::string& after) {
  return spelled(find_key_changes(before, after));
}

TEST(KeyChanges, AreNoneWhereOnlyCommentsAndOrderDiffer) {
  EXPECT_EQ(changes("a = 1\nb = 2\n", "# first\nb = 2\na=1\n"), "");
  EXPECT_EQ(changes("[t]\na = 1\n", "t = { a = 1 }\n"), "");
}

TEST(KeyChanges, NameTheKeyAndBothValues) {
  EXPECT_EQ(changes("[t]\na = \"2.5 kn\"\nb = [1, 2]\n", "[t]\na = \"3 kn\"\nb = [1, 3]\n"),
            "t.a: 2.5 kn -> 3 kn; t.b: [1, 2] -> [1, 3]");
  EXPECT_EQ(changes("a = 1\n", "a = 1\n[t]\nc = 2\nd = \"x y\"\n"), "t: - -> {c = 2, d = \"x y\"}");
  EXPECT_EQ(changes("a = 1\nb = 2\n", "b = 2\n"), "a: 1 -> -");
  EXPECT_EQ(changes("a = \"x\"\n", "a = { part = \"x\" }\n"), "a: x -> {part = \"x\"}");
}

TEST(KeyChanges, SkipItemsThatAreTheSame) {
  const std::string a = "[[hold]]\non = \"a\"\n", b = "[[hold]]\non = \"b\"\n", c = "[[hold]]\non = \"c\"\n";
  EXPECT_EQ(changes(a + c, a + b + c), "hold[1]: - -> {on = \"b\"}");
  EXPECT_EQ(changes(b + c, a + b + c), "hold[0]: - -> {on = \"a\"}");
  EXPECT_EQ(changes(a + b + c, a + c), "hold[1]: {on = \"b\"} -> -");
  EXPECT_EQ(changes(a + b, a + c), "hold[1].on: b -> c");
}

TEST(KeyChanges, AreNotKnownOfOtherTexts) { EXPECT_EQ(changes("v 1 2 3", "a = 1"), "not known"); }

TEST(KeyChanges, ReadTheFilesAndOptionsOfAResult) {
  Origins before, after;
  before.files = {{"here/net.toml", "", "include = [\"../common.toml\"]\n[tow]\nspeed = \"2 kn\"\n"},
                  {"common.toml", "", "depth = 30\n[tow]\nspeed = 1\nfrom = 5\n"},
                  {"/catalogue/twines.toml", "", "a = 1\n"}};
  after.files = {{"there.toml", "", "include = [\"here/net.toml\"]\n"}, before.files[0], before.files[1]};
  std::set<std::string> files;
  EXPECT_EQ(spelled(find_key_changes(before, after, files)), "");
  EXPECT_EQ(files, (std::set<std::string>{"common.toml", "here/net.toml", "there.toml"}));
  after.command = {"run", "there.toml", "--set", "depth=40", "--set=tow.speed=2.5 kn"};
  EXPECT_EQ(spelled(find_key_changes(before, after, files)), "depth: 30 -> 40; tow.speed: 2 kn -> 2.5 kn");
}

TEST(KeyChanges, AreFoundBelowTheNameOfAPart) {
  Origins before, after;
  before.files = after.files = {{"net.toml", "", "[ropes.warp]\nrope = \"wire-16mm\"\n"}};
  after.command = {"netloft", "run", "net.toml", "--set", "ropes.warp.rope.diameter=14 mm"};
  std::set<std::string> files;
  EXPECT_EQ(spelled(find_key_changes(before, after, files)),
            "ropes.warp.rope: wire-16mm -> {part = \"wire-16mm\", diameter = \"14 mm\"}");
}

TEST(KeyChanges, AreNotKnownIfAFileIsMissing) {
  Origins before, after;
  std::set<std::string> files;
  EXPECT_EQ(spelled(find_key_changes(before, after, files)), "not known");
  before.files = after.files = {{"net.toml", "", "include = [\"common.toml\"]\n"}};
  EXPECT_EQ(spelled(find_key_changes(before, after, files)), "not known");
}

}  // namespace
}  // namespace netloft::results
