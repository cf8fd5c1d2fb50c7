// SPDX-License-Identifier: BSD-3-Clause
// Nonsensical plans get a message and do not crash. Findings of tests/fuzz are added here.
#include "io/gears/drawing/drawing.hpp"
#include "io/gears/plan/gear.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

#include <random>

namespace netloft::gears {
namespace {

const char* const kGears[] = {"83-112-eastern.toml", "four-panel.toml", "codend-100-round.toml"};

/// Checks a plan. Each message must have a place; a plan without errors must become a picture and a gear.
void try_plan(const std::string& text) {
  const auto checked = check_text(text);
  for (const auto& finding : checked.diagnostics.sorted())
    ASSERT_GE(finding.place.line, 1) << finding.message;
  if (checked.diagnostics.errors()) return;
  formats::SvgPicture picture;
  EXPECT_GT(draw_plan(checked.plan, picture).height, 0);
  for (const Extent extent : {Extent::whole, Extent::half})
    EXPECT_GE(make_gear(checked.plan, extent).panels.size(), checked.plan.panels.size());
}

std::string seed_text() {
  std::ifstream file(test::source_folder() + "/tests/fuzz/seeds/plan/everything.toml");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// If the plan from which the fuzzer starts were wrong, the fuzzer would test little more than the reader.
TEST(HostilePlans, TheSeedOfTheFuzzerCanBeSewn) {
  const auto checked = check_text(seed_text());
  EXPECT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  EXPECT_GE(make_gear(checked.plan, Extent::whole).panels.size(), 6u);
  try_plan(seed_text());
}

TEST(HostilePlans, CutOffAnywhereAreAnswered) {
  for (const char* gear : kGears) {
    const std::string text = library_text(gear);
    ASSERT_GT(text.size(), 500u);
    for (std::size_t end = 1; end < text.size(); end += 61) try_plan(text.substr(0, end));
  }
}

/// Puts pieces of plans into places where they do not belong.
TEST(HostilePlans, PutTogetherAtRandomAreAnswered) {
  std::mt19937 dice(20130612);
  const auto below = [&](std::size_t n) { return dice() % n; };
  for (int k = 0; k < 300; ++k) {
    std::string text = k % 2 ? seed_text() : library_text(kGears[below(3)]);
    for (int i = 0; i < 3; ++i) {
      const std::string piece = text.substr(below(text.size()), below(40));
      text.replace(below(text.size()), below(20), piece);
    }
    try_plan(text);
  }
}

TEST(HostilePlans, NumbersBeyondAllMeasureAreRefused) {
  const char* const keys[] = {"depth = 50", "fore = 20\ndepth", "aft = 20", "ratio = 0.5",
                              "length = \"6 m\""};
  for (const std::string number : {"nan", "inf", "-inf", "1e308", "-1e308", "9223372036854775807"})
    for (const std::string key : keys) {
      const std::string name = key.substr(0, key.find(' '));
      const auto checked =
          check_text(changed_plan(key, name + " = " + number + (key.ends_with("depth") ? "\ndepth" : "")));
      EXPECT_GT(checked.diagnostics.errors(), 0) << name << " = " << number;
    }
}

TEST(HostilePlans, AsManyPiecesAsNobodyHasAreRefused) {
  for (const std::string number : {"nan", "inf", "1e300", "0", "-3"}) {
    const auto checked = check_text(changed_plan("11 along headline", number + " along headline"));
    EXPECT_EQ(checked.diagnostics.errors(), 1) << number << checked.said();
  }
}

TEST(HostilePlans, AFloodOfSeamsIsAnswered) {
  std::string text = kGoodPlan;
  for (int i = 0; i < 1000; ++i) text += "[[join]]\nedges = [\"bag.sides\", \"bag.sides\"]\nselvedge = 1\n";
  EXPECT_GT(check_text(text).diagnostics.errors(), 0);
}

}  // namespace
}  // namespace netloft::gears
