// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/reference.hpp"

#include <gtest/gtest.h>

namespace netloft::studies {
namespace {

std::vector<std::string> asked(const std::string& method, const std::vector<std::string>& available,
                               const std::string& wanted = "") {
  std::vector<std::string> words;
  for (const auto& m : reference_methods({method}, available, wanted)) words.push_back(m.specification);
  return words;
}

const std::vector<std::string> kAll{"lbfgs", "newton", "ptc", "rope"};

TEST(Reference, ComesFromAnotherSolver) {
  EXPECT_EQ(asked("lbfgs", kAll).front(), "newton");
  EXPECT_EQ(asked("lbfgs:memory=20", kAll).front(), "newton");
  EXPECT_EQ(asked("newton", kAll).front(), "ptc");
  EXPECT_EQ(asked("newton/newton:method=classic", kAll).front(), "ptc");
  EXPECT_EQ(asked("strategy auto", kAll).front(), "ptc") << "its stages are solved by newton";
}

TEST(Reference, ComesFromTheOwnPluginOnlyWhenThereIsNoOther) {
  EXPECT_EQ(asked("newton", {"newton", "rope"}),
            (std::vector<std::string>{"newton:method=classic", "newton:method=globalised"}));
  const auto all = asked("newton", kAll);
  EXPECT_EQ(all[1], "lbfgs");
  EXPECT_EQ(all[2], "newton:method=classic");
}

TEST(Reference, IsNeverTheMethodItself) {
  for (const auto& word : {"newton", "ptc", "lbfgs", "newton:method=classic"})
    for (const auto& other : asked(word, kAll)) EXPECT_NE(other, word);
}

TEST(Method, IsASolverUnlessItBeginsWithAnotherWord) {
  EXPECT_EQ(Method{"newton:method=classic"}.kind(), "solver");
  EXPECT_EQ(Method{"a b"}.kind(), "solver");
  EXPECT_EQ(Method{"a b"}.name(), "a b");
  EXPECT_EQ(Method{"strategy auto:restarts=6"}.kind(), "strategy");
  EXPECT_EQ(Method{"strategy auto:restarts=6"}.name(), "auto:restarts=6");
  EXPECT_EQ(Method{"integrator newmark"}.kind(), "integrator");
  EXPECT_EQ(plugin_of({"integrator newmark:corrector=fixed-point"}), "newmark");
}

TEST(Reference, IsWhatIsAskedFor) {
  EXPECT_EQ(asked("newton", kAll, "lbfgs:memory=3"), (std::vector<std::string>{"lbfgs:memory=3"}));
}

}  // namespace
}  // namespace netloft::studies
