// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/parts/gear_parts.hpp"

#include <gtest/gtest.h>

#include "io/design/texts/scene_texts.hpp"
#include "io/formats/toml/parse.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/proposals.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "tests/folders.hpp"

#include <fstream>
#include <sstream>

namespace netloft::design {
namespace {

PartedGear gear_of(const std::string& text) {
  formats::Diagnostics said;
  PartedGear gear{*formats::parse_toml(text, 0, said), {}, {}, {}};
  gear.catalogue = gears::Catalogue::load({test::source_folder() + "/gear-library/catalogue"}, said);
  gear.plan = gears::read_plan(gears::tables_of_plan(gear.root), gear.catalogue, said);
  EXPECT_EQ(said.errors(), 0u);
  return gear;
}

PartedGear two_panel() {
  std::stringstream text;
  text << std::ifstream(test::source_folder() + "/gear-library/gears/two-panel.toml").rdbuf();
  return gear_of(text.str());
}

const PartTemplate& kind_called(const std::string& kind) {
  return *std::ranges::find(part_templates(), kind, &PartTemplate::kind);
}

/// The messages of the check about a document.
std::vector<std::string> messages_about(const formats::Value& root, const gears::Catalogue& catalogue) {
  formats::Diagnostics said;
  gears::NetPlan plan = gears::read_plan(gears::tables_of_plan(root), catalogue, said);
  if (said.errors() == 0) gears::check_plan(plan, said);
  std::vector<std::string> messages;
  for (const formats::Diagnostic& one : said.messages()) messages.push_back(one.message);
  return messages;
}

TEST(PartsOfGears, CanBeSewnWhereverAPanelIsAdded) {
  const PartedGear gear = two_panel();
  ASSERT_TRUE(messages_about(gear.root, gear.catalogue).empty());
  // Tubes and the edges hung on ropes need no neighbour; a flat panel in the seams of others leaves their
  // sides open.
  for (const char* edge : {"bag.fore", "bag.aft", "upper.fore", "lower.fore"}) {
    const auto ways = with_part(gear, kind_called("panel"), {{"edge", edge}, {"depth", "12"}});
    EXPECT_EQ(messages_about(ways.front(), gear.catalogue), std::vector<std::string>{}) << edge;
  }
}

TEST(PartsOfGears, HaveCuttingsThatCloseAPanel) {
  const PartedGear gear = gear_of(
      "[panels.bag]\nmesh = \"50 mm\"\ntwine = \"pe-braided-3mm\"\nfore = 100\ndepth = 40\naft = 60\nsides = "
      "\"1N2B in\"\nopen = [\"sides\", \"fore\", \"aft\"]\n");
  for (const int far : {20, 30, 44, 59, 60, 61, 75, 90}) {
    const auto ways = with_part(gear, kind_called("panel"),
                                {{"edge", "bag.aft"}, {"depth", "33"}, {"far", std::to_string(far)}});
    std::vector<std::string> least(9);
    for (const formats::Value& way : ways)
      if (auto said = messages_about(way, gear.catalogue); said.size() < least.size())
        least = std::move(said);
    std::string all;
    for (const auto& m : least) all += m + "\n";
    EXPECT_EQ(all, messages_about(gear.root, gear.catalogue).empty()
                       ? ""
                       : messages_about(gear.root, gear.catalogue).front() + "\n")
        << far;
  }
}

TEST(PartsOfGears, HaveTheRatesThatNetMakersCut) {
  EXPECT_EQ(gears::rates_near(40, 80).front(), "2B1P");  // two-panel.toml: 1N2B
  EXPECT_EQ(gears::rates_near(30, 30).front(), "AB");
  EXPECT_LE(std::abs(gears::parse_rate(gears::rates_near(19.3, 77).front())->across(77) - 19.3), 0.5);
  EXPECT_GT(gears::parse_rate(gears::rates_near(50, 20).front())->across(20), 45);  // bars and meshes
}

TEST(PartsOfGears, LeadRopesOfAPointToABoard) {
  PartedGear gear = two_panel();
  gear.points["door"] = {1, 2, -3};
  const auto ways = with_part(gear, kind_called("board"),
                              {{"at", "door"}, {"board", "flat-1.0x2.0"}, {"rope", "6x19-fc-13mm"}});
  const auto& ropes = *ways.front().as<formats::Table>()->find("ropes")->value.as<formats::Table>();
  const auto end = [&](const char* rope, std::size_t i) {
    return *ropes.find(rope)
                ->value.as<formats::Table>()
                ->find("between")
                ->value.as<formats::Array>()
                ->items[i]
                .as<std::string>();
  };
  EXPECT_EQ(end("upper-bridle", 0), "board-1.sweep");
  EXPECT_EQ(end("lower-bridle", 0), "board-1.sweep");
  EXPECT_EQ(end("board-1-rope", 0), "door");
  EXPECT_EQ(end("board-1-rope", 1), "board-1.warp");
}

TEST(PartsOfGears, GoWithTheirSeamsAndHangings) {
  const formats::Value left = without_part(two_panel().root, "panels.bag");
  const auto& joins = left.as<formats::Table>()->find("join")->value.as<formats::Array>()->items;
  EXPECT_EQ(joins.size(), 1u);
  EXPECT_EQ(left.as<formats::Table>()->find("hang")->value.as<formats::Array>()->items.size(), 2u);
  const formats::Value row = without_part(two_panel().root, "panels.lower");
  const auto& seams = row.as<formats::Table>()->find("join")->value.as<formats::Array>()->items;
  ASSERT_EQ(seams.size(), 2u);  // the row round the mouth of the bag keeps the other panel
  EXPECT_THROW(without_part(two_panel().root, "panels.bags"), Refused);
}

TEST(PartsOfGears, RefuseWhatCannotBeChosen) {
  const PartedGear gear = two_panel();
  const auto add = [&](const char* kind, const PartChoices& choices) {
    return with_part(gear, kind_called(kind), choices);
  };
  EXPECT_THROW(add("floats", {{"float", "no-such-float"}}), Refused);
  EXPECT_THROW(add("floats", {{"count", "5\"\n[x"}}), Refused);
  EXPECT_THROW(add("rope", {{"from", "door"}, {"to", "headline.end"}}), Refused);  // no distance is known
  EXPECT_THROW(add("panel", {{"edge", "upper.sides"}}), Refused);
  EXPECT_THROW(add("panel", {{"depth", "none"}}), Refused);
  EXPECT_THROW(with_part(PartedGear{}, kind_called("floats"), {}), Refused);
}

}  // namespace
}  // namespace netloft::design
