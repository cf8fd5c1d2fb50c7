// SPDX-License-Identifier: BSD-3-Clause
//
// Plugins that must not be loaded, and the messages to their authors. Sources: tests/support/refused.
#include "framework/registry/library.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = netloft::test::build_folder() + "/tests/refused";

fs::path plugin(const std::string& flaw) { return kFolder / (flaw + ".so"); }

std::string refusal(const fs::path& file) {
  try {
    netloft::open_library(file);
    return "";
  } catch (const netloft::PluginRefused& refused) {
    return refused.what();
  }
}

unsigned floating_point_mode() {
#if defined(__x86_64__)
  return _mm_getcsr() & ~0x3fu;
#else
  return 0;
#endif
}

struct Case {
  const char* flaw;
  const char* says;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.flaw; }

class Refused : public testing::TestWithParam<Case> {};

TEST_P(Refused, SaysWhyAndLeavesTheFloatingPointModeAlone) {
  const unsigned before = floating_point_mode();
  const std::string text = refusal(plugin(GetParam().flaw));
  EXPECT_NE(text.find(GetParam().says), std::string::npos) << text;
  EXPECT_NE(text.find(plugin(GetParam().flaw).string()), std::string::npos)
      << "does not name the file: " << text;
  EXPECT_EQ(floating_point_mode(), before);
}

TEST_P(Refused, AtEveryAttempt) {
  const std::string first = refusal(plugin(GetParam().flaw));
  EXPECT_NE(first, "");
  EXPECT_EQ(refusal(plugin(GetParam().flaw)), first);
}

INSTANTIATE_TEST_SUITE_P(
    For, Refused,
    testing::Values(
        Case{"missing_symbol", "is no Netloft plugin, or one for another major version"},
        Case{"other_major", "build the plugin again with this program's headers"},
        Case{"newer_minor", "built for the newer plugin interface"},
        Case{"crashes", "crashed while it was opened (Aborted)"},
        Case{"wild_table", "crashed while it was opened (Segmentation fault)"},
        Case{"exits", "ended the program while it was opened"},
        Case{"longer_and_newer", "built for the newer plugin interface"},
        Case{"fast_math_compiled", "compiled with -ffast-math"},
        Case{"two_elements", "two elements are called \"bar\"; names must be unique"},
        Case{"two_parameters", "two parameters are called \"stiffness\"; names must be unique"},
        Case{"offset_outside", "parameter \"rate\" lies at bytes 16 to 24, outside its struct of 16 bytes"},
        Case{"misaligned", "parameter \"rate\" is not aligned in its struct"},
        Case{"wrong_name",
             "calls itself \"other\"; the file wrong_name.so must hold the plugin \"wrong_name\""},
        Case{"null", "the plugin could not describe itself"},
        Case{"throws", "the plugin could not describe itself"}, Case{"no_terms", "no_terms/bar has no term"},
        Case{"needs_unknown", "needs the parameter \"strength\", which the element does not have"},
        Case{"no_members", "no_members/bar has a term of members but declares none"},
        Case{"drag_at_rest",
             "is drag that reads the current but not the velocity of the nodes, so it would be wrong in a "
             "motion: "
             "declare reads_velocity"},
        Case{"nameless_parameter", "a parameter has no name"},
        Case{"no_unit", "has no unit (\"1\" is the unit of a pure number)"},
        Case{"bad_choice", "parameter \"rate\" has a default that is none of its words"},
        Case{"bad_integer", "\"rate\" has the default 1e+30; it must be a whole number in [0, 10] N/m"},
        Case{"endless_integer", "both ends of its range must be whole numbers from -2^53 to 2^53"},
        Case{"column_without_unit", "parameter \"rate\" has no unit for its column \"no\""},
        Case{"empty_validity",
             "empty_validity/law has a range of a quantity this program does not know (99)"},
        Case{"two_strategies", "two strategies are called \"two_strategies\"; names must be unique"},
        Case{"no_run", "no_run/no_run has no run"},
        Case{"needs_extension", "needs the extension \"netloft.ice/1\" of the plugin interface"},
        Case{
            "unlisted_input",
            "term \"one\" reads data of the extension \"netloft.ground/1\", which the element does not list"},
        Case{"strategy_outside",
             "strategy_outside/second: parameter \"rate\" lies at bytes 8 to 16, outside its struct of 8 "
             "bytes"},
        Case{"many", "many/rod has no term"}),
    [](const testing::TestParamInfo<Case>& c) { return std::string(c.param.flaw); });

#if defined(__x86_64__)
INSTANTIATE_TEST_SUITE_P(ForFloatingPoint, Refused,
                         testing::Values(Case{"flushes_to_zero", "changed the floating-point mode"}),
                         [](const testing::TestParamInfo<Case>& c) { return std::string(c.param.flaw); });
#endif

TEST(Loader, KeepsItsFloatingPointModeWhenAPluginIsLinkedWithFastMath) {
  const unsigned before = floating_point_mode();
  const std::string text =
      refusal(plugin("fast_math_linked"));  // GCC 13 and later no longer link code that changes the mode
  EXPECT_TRUE(text.empty() || text.find("linked with -ffast-math") != std::string::npos) << text;
  EXPECT_EQ(floating_point_mode(), before);
}

TEST(Loader, TellsAllFaultsOfAPluginAtOnce) {
  const std::string text = refusal(plugin("many"));
  for (const char* fault :
       {"many/bar has no term", "many/rod has no term", "outside its struct", "has no unit"})
    EXPECT_NE(text.find(fault), std::string::npos) << fault << " is missing in:\n" << text;
}

TEST(Loader, TellsAllFaultsOfTheRangesOfALaw) {
  const std::string text = refusal(plugin("empty_validity"));
  for (const char* fault : {"law has an empty range", "law has a range without a source",
                            "law has a range that depends on \"speed\", which is no parameter of it"})
    EXPECT_NE(text.find(fault), std::string::npos) << fault << " is missing in:\n" << text;
}

TEST(Loader, RefusesAFileThatIsNoSharedObject) {
  const fs::path file = fs::path(testing::TempDir()) / "text.so";
  std::ofstream(file) << "this is a letter, not a program\n";
  EXPECT_NE(refusal(file).find("cannot open the plugin: "), std::string::npos) << refusal(file);
}

TEST(Loader, RefusesAnEmptyFile) {
  const fs::path file = fs::path(testing::TempDir()) / "empty.so";
  std::ofstream{file};
  EXPECT_NE(refusal(file).find("cannot open the plugin: "), std::string::npos) << refusal(file);
}

TEST(Loader, RefusesATruncatedPluginWhereverItWasCut) {
  std::ifstream in(plugin("none"), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  for (const std::size_t part : {1u, 8u, 32u, 63u, 99u}) {
    const fs::path file = fs::path(testing::TempDir()) / ("cut" + std::to_string(part) + ".so");
    std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() * part / 100);
    EXPECT_NE(refusal(file).find("is not complete"), std::string::npos) << part << " %: " << refusal(file);
  }
}

TEST(Loader, TakesAPluginThatIsWhole) {
  const auto content = netloft::open_library(plugin("none"));
  EXPECT_EQ(content.origin.name, "none");
  EXPECT_EQ(content.origin.file, plugin("none").string());
  EXPECT_EQ(content.origin.fingerprint.size(), 16u);
  ASSERT_EQ(content.elements.size(), 2u);
  EXPECT_EQ(content.elements[1].type, "none/rod");
}

void expect_same_description(const std::string& name) {
  const auto content = netloft::open_library(plugin(name));
  ASSERT_EQ(content.elements.size(), 2u);
  for (const auto& e : content.elements) {
    ASSERT_EQ(e.parameters.size(), 2u);
    EXPECT_STREQ(e.parameters[1].name, "rate");
    EXPECT_EQ(e.parameters[1].fallback_text, nullptr);
    ASSERT_EQ(e.terms.size(), 2u);
    EXPECT_STREQ(e.terms[1].needs, "stiffness");
    EXPECT_NE(e.element.create, nullptr);
    EXPECT_EQ(e.element.output, nullptr);
  }
  EXPECT_EQ(content.elements[1].type, name + "/rod");
}

TEST(Loader, ReadsTheStrategiesOfAPlugin) {
  const auto content = netloft::open_library(plugin("longer"));
  ASSERT_EQ(content.strategies.size(), 2u);
  EXPECT_EQ(content.strategies[1].type, "longer/second");
  EXPECT_NE(content.strategies[1].strategy.run, nullptr);
  EXPECT_EQ(content.strategies[1].strategy.explain, nullptr);
  ASSERT_EQ(content.strategies[1].parameters.size(), 2u);
  EXPECT_STREQ(content.strategies[1].parameters[1].name, "rate");
}

TEST(Loader, FindsNoExtensionsInAPluginWhoseTableEndsBeforeThem) {
  EXPECT_TRUE(netloft::open_library(plugin("older")).strategies.empty());
}

TEST(Loader, TakesLongerStructsOfANewerHeader) { expect_same_description("longer"); }

TEST(Loader, TakesShorterStructsOfAnOlderHeaderAndReadsZeroForTheRest) { expect_same_description("older"); }

}  // namespace
