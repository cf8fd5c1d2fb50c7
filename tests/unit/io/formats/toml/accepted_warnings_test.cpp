// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/accepted_warnings.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::formats {
namespace {

using test::Input;

/// A document that accepts warnings, and warnings about it.
struct Warned : Input {
  Warned(const std::string& text, const std::vector<std::string>& warnings) : Input(text) {
    for (const auto& warning : warnings) diagnostics.warning({0, 1, 1}, warning);
    accept_warnings(document.root(), diagnostics);
  }
};

const char* const kHeadline = "[[accept]]\nwarning = \"headline is 25 m long\"\nreason = \"as printed\"\n";

TEST(AcceptedWarnings, AreNeitherCountedNorShown) {
  const Warned in(kHeadline, {"headline is 25 m long, and short", "footrope is 30 m long, and short"});
  EXPECT_EQ(in.diagnostics.warnings(), 1);
  EXPECT_EQ(in.diagnostics.render(false).find("headline"), std::string::npos);
  ASSERT_EQ(in.diagnostics.accepted().size(), 1u);
  EXPECT_EQ(in.diagnostics.accepted()[0].accepted, "as printed");
}

TEST(AcceptedWarnings, AreNamedByWholeWords) {
  for (const char* other : {"headline is 25 m longer", "headline is 25 m long-", "the headline is 25 m long"})
    EXPECT_EQ(Warned(kHeadline, {other}).diagnostics.accepted().size(), 0u) << other;
  for (const char* same :
       {"headline is 25 m long", "headline is 25 m long: it is", "headline is 25 m long, or"})
    EXPECT_EQ(Warned(kHeadline, {same}).diagnostics.accepted().size(), 1u) << same;
}

TEST(AcceptedWarnings, NumbersAreWholeWords) {
  const std::string text = "[[accept]]\nwarning = \"a is 2\"\nreason = \"x\"\n";
  EXPECT_EQ(Warned(text, {"a is 2.5 m"}).diagnostics.accepted().size(), 0u);
  EXPECT_EQ(Warned(text, {"a is 2 m"}).diagnostics.accepted().size(), 1u);
}

TEST(AcceptedWarnings, AnEntryThatMatchesNothingIsAWarning) {
  const Warned in(kHeadline, {});
  EXPECT_EQ(in.error(), "2:11: accept[0].warning: no warning begins with \"headline is 25 m long\"");
  EXPECT_EQ(in.diagnostics.errors(), 0);
}

TEST(AcceptedWarnings, AnEntryMeansOneWarning) {
  const Warned in("[[accept]]\nwarning = \"a\"\nreason = \"x\"\n", {"a is thin", "a is long"});
  EXPECT_EQ(in.diagnostics.accepted().size(), 0u);
  EXPECT_NE(in.diagnostics.render(false).find("accept[0].warning: 2 warnings begin with \"a\""),
            std::string::npos);
}

/// After an error, some warnings are missing, so that an entry without a warning may still be needed.
TEST(AcceptedWarnings, AnEntryIsNotUselessAfterAnError) {
  Input in(kHeadline);
  in.diagnostics.error({0, 1, 1}, "something else is wrong");
  accept_warnings(in.document.root(), in.diagnostics);
  EXPECT_EQ(in.diagnostics.warnings(), 0);
}

TEST(AcceptedWarnings, ErrorsAreNotAccepted) {
  Input in(kHeadline);
  in.diagnostics.error({0, 1, 1}, "headline is 25 m long");
  accept_warnings(in.document.root(), in.diagnostics);
  EXPECT_EQ(in.diagnostics.errors(), 1);
}

TEST(AcceptedWarnings, NeedAReason) {
  EXPECT_TRUE(Warned("[[accept]]\nwarning = \"a\"\n", {})
                  .error()
                  .starts_with("1:1: missing key \"reason\" in accept[0]"));
  EXPECT_EQ(Warned("[[accept]]\nwarning = \"a\"\nreason = \" \"\n", {"a is thin"}).diagnostics.errors(), 1);
  EXPECT_EQ(Warned("accept = [\"a\"]\n", {}).error(), "1:11: accept[0]: has no reason");
  EXPECT_EQ(Warned("accept = 3\n", {}).error(), "1:10: accept: is not an array of tables");
  EXPECT_EQ(Warned("[[accept]]\nwarning = \"a\"\nreason = \"x\"\nwhy = 1\n", {"a is"}).diagnostics.errors(),
            1);
}

TEST(AcceptedWarnings, MayBeWrittenInOneArray) {
  Warned in("accept = [{ warning = \"a\", reason = \"x\" }, { warning = \"b\", reason = \"y\" }]\n",
            {"a is", "b is"});
  EXPECT_EQ(in.diagnostics.accepted().size(), 2u);
}

}  // namespace
}  // namespace netloft::formats
