// SPDX-License-Identifier: BSD-3-Clause
//
// The names of the data that the host gives to elements: the page for authors must list them, and wrong
// declarations must be refused.
#include "framework/registry/element_data.hpp"
#include "framework/registry/element_outputs.hpp"
#include "tests/support/rows_of_page.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace netloft {
namespace {

constexpr std::pair<const char*, std::uint32_t> kStencils[] = {
    {"NETLOFT_NODE", NETLOFT_NODE},         {"NETLOFT_BAR", NETLOFT_BAR},
    {"NETLOFT_TRIANGLE", NETLOFT_TRIANGLE}, {"NETLOFT_BODY", NETLOFT_BODY},
    {"NETLOFT_BAR_PAIR", NETLOFT_BAR_PAIR}, {"NETLOFT_TRIANGLE_PAIR", NETLOFT_TRIANGLE_PAIR}};

std::vector<std::string> rows_of_table() {
  std::vector<std::string> rows;
  for (const auto& [word, stencil] : kStencils)
    for (const HostDatum& d : data_on(stencil))
      rows.push_back(std::string("| `") + word + "` | `" + d.name + "` | " + std::to_string(d.width) + " | " +
                     d.unit + " | " + d.doc + " |");
  return rows;
}

TEST(ElementData, IsTheTableOfTheGuide) {
  EXPECT_EQ(test::rows_below("framework/guides/element.md", "| stencil | datum | numbers | unit | |"),
            rows_of_table());
}

TEST(KnownOutputs, AreTheTableOfTheGuide) {
  std::vector<std::string> rows;
  for (const KnownOutput& o : output::kKnown)
    rows.push_back(std::string("| `") + o.name + "` | " + o.unit + " | " + o.use + " |");
  EXPECT_EQ(test::rows_below("framework/guides/element.md", "| output | unit | |"), rows);
}

/// The message about a plugin whose only element declares this datum.
std::string refusal(std::uint32_t stencil, const char* name, std::uint32_t width, const char* unit) {
  netloft_datum d{sizeof d, width, name, unit, "a datum"};
  netloft_term t{};
  t.size = sizeof t, t.name = "term", t.doc = "a term";
  t.evaluate = [](const void*, netloft_tile*) -> int { return NETLOFT_OK; };
  netloft_element e{};
  e.size = sizeof e, e.stencil = stencil, e.name = "one", e.doc = "an element";
  e.data = &d, e.datum_count = 1, e.terms = &t, e.term_count = 1;
  e.create = [](netloft_create*, void**) -> int { return NETLOFT_OK; };
  e.destroy = [](void*) {};
  netloft_plugin p{};
  p.size = sizeof p, p.abi_major = NETLOFT_ABI_MAJOR, p.abi_minor = NETLOFT_ABI_MINOR;
  p.name = "made", p.elements = &e, p.element_count = 1;
  try {
    read_plugin(&p, "made.so", "made");
    return "";
  } catch (const PluginRefused& refused) {
    return refused.what();
  }
}

TEST(ElementData, IsTakenAsTheHostGivesIt) {
  for (const auto& [word, stencil] : kStencils)
    for (const HostDatum& d : data_on(stencil))
      EXPECT_EQ(refusal(stencil, d.name, d.width, d.unit), "") << word;
}

TEST(ElementData, OfAnotherUnitIsRefused) {
  EXPECT_EQ(
      refusal(NETLOFT_BAR, "rest_length", 1, "mm"),
      "made.so: made/one: datum \"rest_length\" is 1 number in mm; under this name the host gives 1 number "
      "in m (unstretched length of the bar)");
}

TEST(ElementData, OfAnotherWidthIsRefused) {
  EXPECT_NE(
      refusal(NETLOFT_TRIANGLE, "u", 2, "1").find("is 2 pure numbers; under this name the host gives 3"),
      std::string::npos);
}

TEST(ElementData, OfAnotherStencilIsTheElementsOwn) {
  EXPECT_EQ(refusal(NETLOFT_NODE, "rest_length", 2, "mm"), "");
  EXPECT_EQ(find_datum_on(NETLOFT_NODE, "rest_length"), nullptr);
}

TEST(ElementData, IsFoundByANameWithASlip) {
  ASSERT_NE(find_datum_meant(NETLOFT_BAR, "rest_lenght"), nullptr);
  EXPECT_EQ(find_datum_meant(NETLOFT_BAR, "rest_lenght")->name, std::string("rest_length"));
  EXPECT_EQ(find_datum_meant(NETLOFT_BAR, "stiffness"), nullptr);
}

}  // namespace
}  // namespace netloft
