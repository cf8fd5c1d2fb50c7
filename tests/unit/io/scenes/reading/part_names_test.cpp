// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/part_names.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

using Nodes = std::vector<std::uint32_t>;

PartGeometry rope() {
  PartGeometry part;
  part.name = "rope";
  part.sets = {{"start", {0}}, {"end", {3}}};
  return part;
}

Nodes find(const std::string& name) {
  Nodes own;
  return find_own_nodes(rope(), 4, name, own) ? own : Nodes{};
}

TEST(PartNames, FindsSetsAndNodes) {
  EXPECT_EQ(find("end"), Nodes{3});
  EXPECT_EQ(find("node-0"), Nodes{0});
  EXPECT_EQ(find("node-3"), Nodes{3});
}

TEST(PartNames, FindsNothingBesideThem) {
  for (const char* name :
       {"", "fore", "node-", "node-4", "node--1", "node-1x", "node- 1", "node-99999999999", "Node-1"})
    EXPECT_EQ(find(name), Nodes{}) << name;
}

TEST(PartNames, HintsAtWhatThereIs) {
  EXPECT_EQ(set_hint(rope(), 4, "strat"), "did you mean \"rope.start\"?");
  EXPECT_EQ(set_hint(rope(), 4, "headline"), "there is: end, start, node-0 to node-3");
  EXPECT_EQ(set_hint(rope(), 4, "node-4"), "there is: node-0 to node-3");
  EXPECT_NE(set_hint(rope(), 4, "middle").find("even"), std::string::npos);
  EXPECT_EQ(name_hint("ropes", {"net", "rope"}), "did you mean \"rope\"?");
  EXPECT_EQ(name_hint("x", {}), "there are none");
}

TEST(PartNames, ShortensBetweenCharacters) {
  EXPECT_EQ(formats::in_quotes("net"), "\"net\"");
  const std::string fits(59, 'a');
  EXPECT_EQ(formats::in_quotes(fits + "ßb"), "\"" + fits + "...\"");
}

}  // namespace
}  // namespace netloft::scenes
