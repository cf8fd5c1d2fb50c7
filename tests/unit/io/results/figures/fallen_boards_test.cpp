// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/fallen_boards.hpp"

#include <gtest/gtest.h>

#include <map>

namespace netloft::results::test {
namespace {

/// A gear with two boards 20 m apart, or with only the starboard one.
class Pair {
 public:
  explicit Pair(bool is_whole) {
    loaded_.gear.emplace();
    add("starboard-door", 1, 10);
    if (is_whole) add("port-door", -1, -10);
  }
  void set(const std::string& name, double value) {
    for (auto& figure : figures_)
      if (figure.name == name) figure.value = value;
  }
  void tow_to_starboard() {
    for (const std::string door : {"starboard-door", "port-door"}) {
      set("bodies/" + door + "/x", door == "port-door" ? -10 : 10), set("bodies/" + door + "/y", 0);
      set("body_forces/" + door + "/water/x", door == "port-door" ? -3000 : 3000);
      set("body_forces/" + door + "/water/out", door == "port-door" ? 4000 : -4000);
    }
  }
  void forget(const std::string& name) {
    std::erase_if(figures_, [&](const NamedScalar& figure) { return figure.name.ends_with(name); });
  }
  std::vector<FallenBoard> fallen() const { return find_fallen_boards(loaded_, figures_); }

 private:
  void add(const std::string& name, double side, double y) {
    const auto part = static_cast<std::uint32_t>(loaded_.scene.parts.size());
    loaded_.scene.parts.emplace_back().name = name;
    loaded_.bodies.emplace_back().part = part, loaded_.bodies.back().side = side;
    loaded_.gear->pairs["door"].push_back(part);
    const std::string body = "bodies/" + name + "/", force = "body_forces/" + name + "/";
    for (const auto& [figure, value] : std::map<std::string, double>{{body + "heel", -0.3},
                                                                     {body + "x", 0},
                                                                     {body + "y", y},
                                                                     {body + "outward", 3000},
                                                                     {force + "water/x", 4000},
                                                                     {force + "water/out", 3000},
                                                                     {force + "ground/x", 500},
                                                                     {force + "ground/out", 100}})
      figures_.push_back({figure, "", "", value});
  }

  scenes::LoadedScene loaded_;
  std::vector<NamedScalar> figures_;
};

TEST(FallenBoards, AreNoneOfThoseThatStandAndSpread) {
  EXPECT_TRUE(Pair(true).fallen().empty());
  EXPECT_TRUE(Pair(false).fallen().empty());
}

TEST(FallenBoards, LieOverBeyondARightAngle) {
  Pair pair(true);
  pair.set("bodies/port-door/heel", -1.5);
  EXPECT_TRUE(pair.fallen().empty());
  pair.set("bodies/port-door/heel", -1.9);
  pair.set("bodies/starboard-door/heel", 2.7);
  ASSERT_EQ(pair.fallen().size(), 2u);
  EXPECT_EQ(pair.fallen()[0].sentence, "starboard-door has fallen over: its top is turned outward by 155°");
  EXPECT_EQ(pair.fallen()[1].sentence, "port-door has fallen over: its top is turned inward by 109°");
}

TEST(FallenBoards, PushInwardWithWaterAndGround) {
  for (const bool is_whole : {true, false}) {
    Pair pair(is_whole);
    pair.set("body_forces/starboard-door/water/out", -90);
    EXPECT_TRUE(pair.fallen().empty());
    pair.set("body_forces/starboard-door/water/out", -1531);
    ASSERT_EQ(pair.fallen().size(), 1u);
    EXPECT_EQ(pair.fallen()[0].sentence,
              "starboard-door does not spread the gear: water and ground push it inward with 1431 N");
  }
}

TEST(FallenBoards, SpreadAGearThatGoesAcrossTheScene) {
  Pair pair(true);
  pair.tow_to_starboard();
  EXPECT_TRUE(pair.fallen().empty());
}

TEST(FallenBoards, AreNoWeightsOrFloats) {
  Pair pair(true);
  pair.set("bodies/port-door/heel", 3);
  pair.forget("/outward");
  EXPECT_TRUE(pair.fallen().empty());
}

}  // namespace
}  // namespace netloft::results::test
