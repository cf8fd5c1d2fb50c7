// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/holder.hpp"

#include "io/scenes/reading/dynamics.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::scenes {
namespace {

using formats::test::Input;

/// A rope with five nodes at x = 0 … 4.
class Holding : public ::testing::Test {
 protected:
  Holding() {
    scene.parts.emplace_back();
    scene.parts[0].name = "rope";
    for (std::uint32_t i = 0; i < 5; ++i) {
      scene.positions.insert(scene.positions.end(), {double(i), 0, 0});
      scene.labels.push_back({0, i});
      scene.held.push_back(0);
    }
    holder.emplace(scene);
  }
  Hold hold(const std::string& text, const std::vector<std::uint32_t>& nodes) {
    inputs.push_back(std::make_unique<Input>(text));
    formats::TableReader& table = inputs.back()->reader;
    HoldEntry entry = read_hold(table);
    entry.course = read_course(table);
    return holder->hold(entry, nodes, table);
  }
  std::array<double, 3> at(std::size_t node) const {
    return {scene.positions[3 * node], scene.positions[3 * node + 1], scene.positions[3 * node + 2]};
  }
  std::string last_error() const { return inputs.back()->diagnostics.errors() ? inputs.back()->error() : ""; }

  Scene scene;
  std::optional<Holder> holder;
  std::vector<std::unique_ptr<Input>> inputs;
};

TEST_F(Holding, LeavesNodesWhereTheyAreUnlessAPlaceIsGiven) {
  hold("on = \"rope\"", {1, 2});
  EXPECT_EQ(scene.held, (std::vector<std::uint8_t>{0, 7, 7, 0, 0}));
  EXPECT_EQ(at(2), (std::array<double, 3>{2, 0, 0}));
}

TEST_F(Holding, SpreadsNodesAlongALine) {
  hold("on = \"rope\"\nat = [[0, 0, 0], [0, 8, \"-4 m\"]]", {0, 1, 2, 3, 4});
  EXPECT_EQ(at(0), (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(at(1), (std::array<double, 3>{0, 2, -1}));
  EXPECT_EQ(at(4), (std::array<double, 3>{0, 8, -4}));
}

TEST_F(Holding, SpreadsThemByLengthRoundACorner) {
  hold("on = \"rope\"\nat = [[0, 0, 0], [3, 0, 0], [3, 1, 0]]", {0, 1, 2, 3, 4});
  EXPECT_EQ(at(2), (std::array<double, 3>{2, 0, 0}));
  EXPECT_EQ(at(3), (std::array<double, 3>{3, 0, 0}));
}

TEST_F(Holding, FollowsTheOrderOfTheSet) {
  hold("on = \"rope\"\nat = [[0, 0, 0], [0, 2, 0]]", {4, 0});
  EXPECT_EQ(at(4), (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(at(0), (std::array<double, 3>{0, 2, 0}));
}

TEST_F(Holding, MovesHeldAxesOnly) {
  hold("on = \"rope\"\naxes = \"z\"\nat = [9, 9, 9]", {1, 2});
  EXPECT_EQ(at(1), (std::array<double, 3>{1, 0, 9}));
  EXPECT_EQ(scene.held[1], kAxisZ);
}

TEST_F(Holding, RefusesManyNodesInOnePoint) {
  hold("on = \"rope\"\nat = [9, 9, 9]", {1, 2});
  EXPECT_EQ(last_error(), "2:6: at: 2 nodes cannot be held in one point");
}

TEST_F(Holding, CountsWhatTwoHoldWithTheFirst) {
  const Hold first = hold("on = \"a\"\naxes = \"xz\"", {0, 1}), second = hold("on = \"b\"", {1, 2});
  EXPECT_EQ(first.axes, (std::vector<std::uint8_t>{kAxisX | kAxisZ, kAxisX | kAxisZ}));
  EXPECT_EQ(second.axes, (std::vector<std::uint8_t>{kAxisY, kAllAxes}));
}

TEST_F(Holding, CountsANodeOnceThatASetNamesTwice) {
  EXPECT_EQ(hold("on = \"ring\"", {0, 1, 0}).axes, (std::vector<std::uint8_t>{7, 7, 0}));
}

TEST_F(Holding, RefusesTwoPlacesForOneNode) {
  hold("on = \"a\"\nat = [1, 2, 3]", {0});
  hold("on = \"b\"\nat = [1, 2, 4]", {0});
  EXPECT_NE(last_error().find("rope node 0 is held at (1, 2, 4) m here and at (1, 2, 3) m"),
            std::string::npos)
      << last_error();
}

TEST_F(Holding, LetsTwoAgreeAlongTheAxesTheyShare) {
  hold("on = \"a\"\naxes = \"xy\"\nat = [1, 2, 3]", {0});
  hold("on = \"b\"\naxes = \"yz\"\nat = [9, 2, 4]", {0});
  EXPECT_EQ(last_error(), "");
  EXPECT_EQ(at(0), (std::array<double, 3>{1, 2, 4}));
}

TEST_F(Holding, TakesTheSketchAtItsWord) {
  hold("on = \"a\"\nat = [1, 2, 3]", {0});
  hold("on = \"b\"\nat = \"sketch\"", {0});
  EXPECT_NE(last_error().find("rope node 0 is held at (0, 0, 0) m here"), std::string::npos) << last_error();
}

TEST_F(Holding, IsWhereItIsSketchedWithoutAPlace) {
  hold("on = \"a\"\nat = [1, 2, 3]", {0});
  hold("on = \"b\"", {0});
  EXPECT_NE(last_error().find("rope node 0 is held at (0, 0, 0) m here and at (1, 2, 3) m"),
            std::string::npos)
      << last_error();
}

TEST_F(Holding, IsNotMovedByALaterHold) {
  hold("on = \"a\"", {4});
  hold("on = \"b\"\nat = [4, 1, 0]", {4});
  EXPECT_NE(last_error().find("rope node 4 is held at (4, 1, 0) m here and at (4, 0, 0) m"),
            std::string::npos)
      << last_error();
  EXPECT_EQ(at(4), (std::array<double, 3>{4, 0, 0}));
}

TEST_F(Holding, MayBeHeldElsewhereAlongOtherAxes) {
  hold("on = \"a\"\naxes = \"y\"", {4});
  hold("on = \"b\"\naxes = \"xz\"\nat = [5, 9, 1]", {4});
  EXPECT_EQ(last_error(), "");
  EXPECT_EQ(at(4), (std::array<double, 3>{5, 0, 1}));
}

TEST_F(Holding, RefusesAPlaneBesideAPlace) {
  hold("on = \"a\"\nat = [3, 1, 0]", {3});
  hold("on = \"b\"\nplane = [0, 2, 0]", {3});
  EXPECT_NE(last_error().find("rope node 3 is held through (3, 0, 0) m here and at (3, 1, 0) m by"),
            std::string::npos)
      << last_error();
}

TEST_F(Holding, RefusesAPlaceBesideALine) {
  hold("on = \"a\"\nalong = [1, 1, 0]", {3});
  hold("on = \"b\"\nat = [4, 0, 0]", {3});
  EXPECT_NE(last_error().find("rope node 3 is held at (4, 0, 0) m here and at (3, 0, 0) m by"),
            std::string::npos)
      << last_error();
}

TEST_F(Holding, AllowsAPlaceInAnObliquePlane) {
  hold("on = \"a\"\nat = [4, -1, 7]", {3});
  hold("on = \"b\"\nplane = [1, 1, 0]", {3});
  EXPECT_EQ(last_error(), "");
  EXPECT_EQ(at(3), (std::array<double, 3>{4, -1, 7}));
}

TEST_F(Holding, ComparesAPlaneWithTwoHoldsTogether) {
  hold("on = \"a\"\naxes = \"x\"\nat = [4, 0, 0]", {3});
  hold("on = \"b\"\naxes = \"yz\"\nat = [0, -1, 7]", {3});
  hold("on = \"c\"\nplane = [1, 1, 0]", {3});
  EXPECT_EQ(last_error(), "");
  hold("on = \"d\"\nplane = [1, -1, 0]", {3});
  EXPECT_NE(last_error().find("rope node 3 is held through (3, 0, 0) m here and at (4, -1, 7) m"),
            std::string::npos)
      << last_error();
}

const std::string kForward = "velocity = { t = [0, 1], x = [0, 2] }";

TEST_F(Holding, RefusesToLetANodeMoveThatStandsStill) {
  hold("on = \"a\"", {3});
  hold("on = \"b\"\n" + kForward, {3});
  EXPECT_NE(last_error().find("rope node 3 is moved here, but not moved by"), std::string::npos)
      << last_error();
}

TEST_F(Holding, RefusesToLetANodeStandStillThatMoves) {
  hold("on = \"a\"\n" + kForward, {3});
  hold("on = \"b\"", {3});
  EXPECT_NE(last_error().find("rope node 3 is not moved here, but is moved by"), std::string::npos)
      << last_error();
}

TEST_F(Holding, RefusesTwoMotionsOfANode) {
  hold("on = \"a\"\n" + kForward, {3});
  hold("on = \"b\"\nvelocity = { t = [0, 2], x = [0, 2] }", {3});
  EXPECT_NE(last_error().find("rope node 3 is moved here, but moved differently by"), std::string::npos)
      << last_error();
}

TEST_F(Holding, MayMoveANodeTwiceInTheSameWay) {
  hold("on = \"a\"\n" + kForward, {3});
  hold("on = \"b\"\nvelocity = { t = [0, 0.5, 1], x = [0, 1, 2] }", {3});
  EXPECT_EQ(last_error(), "");
}

TEST_F(Holding, MayMoveANodeAlongAxesThatAnotherLeavesFree) {
  hold("on = \"a\"\naxes = \"yz\"", {3});
  hold("on = \"b\"\n" + kForward, {3});
  EXPECT_EQ(last_error(), "");
}

TEST_F(Holding, MayMoveANodeWithinAPlane) {
  hold("on = \"a\"\nvelocity = { t = [0, 1], x = [0, 2], y = [0, -2] }", {3});
  hold("on = \"b\"\nplane = [1, 1, 0]", {3});
  EXPECT_EQ(last_error(), "");
  hold("on = \"c\"\nplane = [1, 0, 0]", {3});
  EXPECT_NE(last_error().find("rope node 3 is not moved here, but is moved by"), std::string::npos)
      << last_error();
}

TEST_F(Holding, DoesNotStopABlockThatFollowsItsShip) {
  scene.held[3] = kAllAxes;
  scene.guides.push_back({{3}, {kAllAxes}, {{{0, {0, 0, 0}, {1, 0, 0}}, {1, {1, 0, 0}, {1, 0, 0}}}}});
  holder.emplace(scene);
  hold("on = \"a\"\naxes = \"x\"", {3});
  EXPECT_NE(last_error().find("rope node 3 is not moved here, but is moved by the net plan"),
            std::string::npos)
      << last_error();
}

TEST(HoldEntry, IsNamedAfterWhatItHolds) {
  Input in("on = \"net.fore\"");
  EXPECT_EQ(read_hold(in.reader).name, "net.fore");
}

}  // namespace
}  // namespace netloft::scenes
