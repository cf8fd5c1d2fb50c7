// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/result_request.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::scenes {
namespace {

using formats::test::Input;
using Source = ResultRequest::Source;

/// Interpretations of `take` for a part or an edge.
class Take : public ::testing::Test {
 protected:
  Take() {
    netloft_output tension{};
    tension.name = "tension", tension.unit = "N", tension.doc = "tension of the twines";
    type.outputs.push_back(tension);
  }
  bool understands(const std::string& of, const std::string& take, std::vector<std::uint32_t> nodes) {
    input = std::make_unique<Input>("take = \"" + take + "\"");
    request = {};
    request.of = of, request.take = take, request.nodes = std::move(nodes);
    return understand(request, type, input->reader);
  }
  std::string hint() const { return input->diagnostics.sorted().at(0).hint; }

  ElementType type;
  ResultRequest request;
  std::unique_ptr<Input> input;
};

TEST_F(Take, KnowsPositions) {
  ASSERT_TRUE(understands("net", "min z", {0, 1}));
  EXPECT_EQ(request.how, "min");
  EXPECT_EQ(request.source, Source::position);
  EXPECT_EQ(request.axis, 2);
  EXPECT_EQ(request.unit, "m");
}

TEST_F(Take, KnowsReactionsAsAWholeAndByAxis) {
  ASSERT_TRUE(understands("net.fore", "sum reaction x", {0, 1}));
  EXPECT_EQ(request.source, Source::reaction);
  EXPECT_EQ(request.axis, 0);
  ASSERT_TRUE(understands("net.fore", "max reaction", {0, 1}));
  EXPECT_EQ(request.axis, 3);
  EXPECT_EQ(request.unit, "N");
}

TEST_F(Take, NeedsNoWordForASingleNode) {
  ASSERT_TRUE(understands("net.node-3", "z", {3}));
  EXPECT_EQ(request.quantity, "z");
}

TEST_F(Take, NeedsAWordForMany) {
  EXPECT_FALSE(understands("net.fore", "z", {0, 1}));
  EXPECT_EQ(hint(), "write \"min z\", or max, mean, sum, range");
}

TEST_F(Take, KnowsOutputsOfAWholePart) {
  ASSERT_TRUE(understands("net", "max tension", {0, 1}));
  EXPECT_EQ(request.source, Source::output);
  EXPECT_EQ(request.unit, "N");
  EXPECT_FALSE(understands("net", "tension", {0}));
}

TEST_F(Take, SaysWhereOutputsAreToBeHad) {
  EXPECT_FALSE(understands("net.fore", "max tension", {0, 1}));
  EXPECT_EQ(hint(),
            "\"tension\" is a quantity of elements, not of nodes: take it of the whole part, of = \"net\"");
}

TEST_F(Take, GuessesWhatWasMeant) {
  EXPECT_FALSE(understands("net", "maximum tension", {0, 1}));
  EXPECT_EQ(hint(), "did you mean \"max tension\"?");
  EXPECT_FALSE(understands("net", "max tensoin", {0, 1}));
  EXPECT_EQ(hint(), "did you mean \"max tension\"?");
  EXPECT_FALSE(understands("net", "min", {0, 1}));
  EXPECT_NE(hint().find("tension"), std::string::npos);
}

}  // namespace
}  // namespace netloft::scenes
