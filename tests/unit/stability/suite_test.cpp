// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/suite.hpp"

#include "tests/folders.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

#include <algorithm>
#include <set>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;
using namespace runs;

namespace {

class SuiteFolder : public formats::test::Scratch {
 protected:
  Suite read(std::uint64_t number = 1) {
    write("solvers.toml", "[[solver]]\nuse = \"newton\"\n");
    return read_suite(folder_, number, diagnostics_);
  }
  static constexpr const char* kHead = "scene = \"rope.toml\"\nset = [\"a=1\"]\n[sizes]\nsmall = [\"n=2\"]\n";
};

TEST_F(SuiteFolder, ACaseTakesWhatItsFileSaysAndAddsItsOwn) {
  write("rope.toml",
        std::string(kHead) +
            "[[case]]\nname = \"slack\"\nset = [\"b=2\"]\nexpected = \"unique\"\nneutral = true\n");
  const auto suite = read();
  ASSERT_EQ(errors(), "");
  ASSERT_EQ(suite.cases.size(), 1u);
  const HardCase& c = suite.cases[0];
  EXPECT_EQ(c.name, "rope/slack");
  EXPECT_EQ(c.reference, "rope/slack");
  EXPECT_EQ(c.overrides, (std::vector<std::string>{"a=1", "b=2"}));
  EXPECT_EQ(c.sizes.at("small"), std::vector<std::string>{"n=2"});
  EXPECT_EQ(c.scene, folder_ / "rope.toml");
  EXPECT_TRUE(c.expected == Expected::unique && c.neutral && !c.is_random);
  EXPECT_EQ(suite.columns[0].solver, "newton");
}

TEST_F(SuiteFolder, AColumnHasATitleAndSizesOfItsOwnOrThoseOfAll) {
  write("rope.toml", std::string(kHead) + "[[case]]\nname = \"slack\"\nexpected = \"unique\"\n");
  write("solvers.toml",
        "[[solver]]\nuse = \"auto\"\n[[solver]]\nuse = \"auto\"\ntitle = \"auto, 4 looks\"\n"
        "sizes = [\"small\"]\nset = [\"analysis.auto.restarts=4\"]\n");
  const auto columns = read_suite(folder_, 1, diagnostics_).columns;
  ASSERT_EQ(errors(), "");
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(columns[0].head(), "auto");
  EXPECT_TRUE(columns[0].sizes.empty());
  EXPECT_EQ(columns[1].head(), "auto, 4 looks");
  EXPECT_EQ(columns[1].sizes, std::vector<std::string>{"small"});
}

TEST_F(SuiteFolder, AColumnIsAStrategyOrASolverOrBoth) {
  write("rope.toml", std::string(kHead) + "[[case]]\nname = \"slack\"\nexpected = \"unique\"\n");
  write("solvers.toml",
        "[[solver]]\nstrategy = \"auto\"\n[[solver]]\nuse = \"newton\"\n"
        "[[solver]]\nstrategy = \"load-steps\"\nuse = \"ptc\"\n[[solver]]\ntitle = \"neither\"\n");
  const auto columns = read_suite(folder_, 1, diagnostics_).columns;
  EXPECT_NE(errors().find("use: is missing"), std::string::npos) << errors();
  ASSERT_EQ(columns.size(), 4u);
  EXPECT_EQ(columns[0].strategy, "auto");
  EXPECT_EQ(columns[0].solver, "");
  EXPECT_EQ(columns[1].strategy, "");
  EXPECT_EQ(columns[2].strategy, "load-steps");
  EXPECT_EQ(columns[2].solver, "ptc");
}

TEST_F(SuiteFolder, ARandomCaseIsManyAndAnotherNumberChangesAllOfThem) {
  write("rope.toml",
        std::string(kHead) +
            "[[case]]\nname = \"random\"\ncount = 3\nset = [\"length=$L\"]\nexpected = \"stable\"\n"
            "start = [{ noise = \"$L m\" }]\n[case.vary]\nL = { from = 1, to = 2 }\n");
  const auto one = read(1), two = read(2);
  ASSERT_EQ(errors(), "");
  ASSERT_EQ(one.cases.size(), 3u);
  EXPECT_EQ(one.cases[2].name, "rope/random-3");
  std::set<std::string> lengths;
  std::set<std::uint64_t> seeds;
  for (const auto* suite : {&one, &two})
    for (const auto& c : suite->cases) {
      EXPECT_TRUE(c.is_random);
      lengths.insert(c.overrides.at(1)), seeds.insert(c.start.at(0).seed);
    }
  EXPECT_EQ(lengths.size(), 6u);
  EXPECT_EQ(seeds.size(), 6u);
}

TEST_F(SuiteFolder, WhatIsWrongIsSaidWhereItStands) {
  write("rope.toml", std::string(kHead) +
                         "[[case]]\nname = \"a\"\nexpected = \"perhaps\"\n"
                         "[[case]]\nname = \"a\"\nexpected = \"none\"\nstat = 1\n");
  read();
  EXPECT_NE(errors().find("rope.toml:7:12: error: case.expected = \"perhaps\""), std::string::npos)
      << errors();
  EXPECT_NE(errors().find("there is a case rope/a already"), std::string::npos) << errors();
  EXPECT_NE(errors().find("rope.toml:11:1: error: unknown key \"stat\""), std::string::npos) << errors();
}

TEST_F(SuiteFolder, AFolderWithoutCasesIsNoSuite) {
  read_suite(folder_ / "nothing", 1, diagnostics_);
  EXPECT_NE(errors().find("holds no suite"), std::string::npos) << errors();
}

TEST(TheSuite, HasItsHardCasesAndAThirdOfThemRandomWhateverTheNumber) {
  for (std::uint64_t number = 1; number <= 10; ++number) {
    formats::Diagnostics diagnostics;
    const auto suite = read_suite(netloft::test::source_folder() + "/tests/stability", number, diagnostics);
    ASSERT_EQ(diagnostics.errors(), 0) << diagnostics.render(false);
    const auto count = [&](auto&& is) { return std::count_if(suite.cases.begin(), suite.cases.end(), is); };
    const auto random = count([](const auto& c) { return c.is_random; });
    EXPECT_GE(static_cast<std::size_t>(random) * 3, suite.cases.size());
    EXPECT_GE(static_cast<std::size_t>(suite.cases.size()) - static_cast<std::size_t>(random), 33u);
    EXPECT_GE(count([](const auto& c) { return c.expected == Expected::none; }), 5);
    for (const auto& c : suite.cases) {
      EXPECT_TRUE(std::filesystem::exists(c.scene)) << c.name;
      EXPECT_EQ(c.sizes.size(), 3u) << c.name;
    }
  }
}

}  // namespace
}  // namespace netloft::hard_cases
