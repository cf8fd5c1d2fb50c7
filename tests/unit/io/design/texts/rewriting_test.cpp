// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/rewriting.hpp"

#include <gtest/gtest.h>

#include "io/design/texts/scene_texts.hpp"
#include "io/design/texts/statements.hpp"
#include "io/formats/toml/parse.hpp"

namespace netloft::design {
namespace {

formats::Value tables(const std::string& text) {
  formats::Diagnostics said;
  return *formats::parse_toml(text, -1, said);
}

/// The text of a scene after it was rewritten to have these tables.
std::string become(const std::string& text, const std::string& wanted) {
  return rewritten("own.toml", {{"own.toml", text}}, tables(wanted)).at("own.toml");
}

TEST(Statements, AreHeadersAndKeysWithTheirWholeValues) {
  const std::string text =
      "a.b = 1\n# above\n[x.\"y z\"]\nlist = [\n  [1],   # [no header]\n]\n[[hold]]\non = 'a = "
      "b'\n[[hold]]\n[hold.inner]\nk = 1";
  std::vector<std::string> paths;
  for (const Statement& one : statements_of(text)) {
    std::string path;
    for (const auto& step : one.path) path += step.item ? std::to_string(*step.item) + "/" : step.key + "/";
    paths.push_back(path + text.substr(one.begin, one.end - one.begin));
  }
  EXPECT_EQ(paths,
            (std::vector<std::string>{"a/b/a.b = 1\n", "x/y z/[x.\"y z\"]\n",
                                      "x/y z/list/list = [\n  [1],   # [no header]\n]\n", "hold/0/[[hold]]\n",
                                      "hold/0/on/on = 'a = b'\n", "hold/1/[[hold]]\n",
                                      "hold/1/inner/[hold.inner]\n", "hold/1/inner/k/k = 1"}));
}

TEST(Rewriting, TakesATableWithItsCommentOut) {
  EXPECT_EQ(become("# of the file\n\n[a.x]\nk = 1   # one\n\n# about y\n[a.y]\nk = 2\n[a.y.inner]\nm = 3\n# "
                   "about b\n[b]\nn = 1\n",
                   "[a.x]\nk = 1\n[b]\nn = 1\n"),
            "# of the file\n\n[a.x]\nk = 1   # one\n\n# about b\n[b]\nn = 1\n");
}

TEST(Rewriting, KeepsTheCommentAtTheHeadOfAFile) {
  EXPECT_EQ(become("# of the file\nk = 1\nm = 2\n", "m = 2\n"), "# of the file\nm = 2\n");
}

TEST(Rewriting, AddsTablesAtTheEndAndItemsToTheirArray) {
  EXPECT_EQ(become("[a.x]\nk = 1\n[[join]]\nedges = [\"a\"]",
                   "[a.x]\nk = 1\n[[join]]\nedges = [\"a\"]\n[[join]]\nedges = [\"b\"]\n[c.z]\nm = 2\n"),
            "[a.x]\nk = 1\n[[join]]\nedges = [\"a\"]\n\n[[join]]\nedges = [\"b\"]\n\n[c.z]\nm = 2\n");
  EXPECT_EQ(become("join = [\n  { e = 1 },   # first\n]\n", "join = [{ e = 1 }, { e = 2 }]\n"),
            "join = [\n  { e = 1 },\n  {e = 2},   # first\n]\n");
}

TEST(Rewriting, TakesOneItemOfAnArrayOut) {
  EXPECT_EQ(become("[[join]]\ne = 1\n[[join]]   # second\ne = 2\n[[join]]\ne = 3\n",
                   "[[join]]\ne = 1\n[[join]]\ne = 3\n"),
            "[[join]]\ne = 1\n[[join]]\ne = 3\n");
}

TEST(Rewriting, ReplacesAValueWhereItIsWritten) {
  EXPECT_EQ(become("[[join]]\nedges = [\"a.aft\", \"b.fore\"]   # seam\n",
                   "[[join]]\nedges = [\"c.aft\", \"b.fore\"]\n"),
            "[[join]]\nedges = [\"c.aft\", \"b.fore\"]   # seam\n");
}

TEST(Rewriting, GivesEqualTablesEveryTime) {
  const char* texts[] = {"[a.x]\nk = 1\n[[j]]\ne = [1, [2]]\n[[j]]\ne = [3]\n",
                         "a = { x = { k = 2 } }\nj = [{ e = [3] }]\n", "j = []\n[a]\nx.k = 1\ny.k = 2\n",
                         "[b.c]\nd = \"#\"\n", "[[j]]\ne = [3]\n[[j]]\ne = [1, [2]]\n[[j]]\nf = 1\n"};
  for (const char* from : texts)
    for (const char* to : texts) {
      try {  // a file that is left without a table keeps its comment
        const std::string once = become(std::string("# a scene\n") + from, to);
        EXPECT_EQ(become(once, to), once) << from << to;
      } catch (const Refused& e) {  // inside an inline table nothing is taken out
        EXPECT_NE(std::string(from).find("a = {"), std::string::npos) << from << to << e.what();
      }
    }
}

}  // namespace
}  // namespace netloft::design
