// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/riding.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

/// A rope with three nodes: the first bar is 2 m long, the second 4 m.
std::vector<double> carried_by_two_bars(const std::vector<double>& parallel) {
  Scene scene;
  scene.positions.assign(9, 0.0);
  Part part;
  part.nodes = {0, 1, 1, 2};
  part.data["rest_length"] = {2, 4};
  if (!parallel.empty()) part.data["parallel"] = parallel;
  ElementType type;
  type.element.stencil = NETLOFT_BAR;
  return carried_length(scene, part, type);
}

TEST(Riding, CarriesHalfOfEveryBarOfARope) {
  EXPECT_EQ(carried_by_two_bars({}), (std::vector<double>{1, 3, 2}));
}

TEST(Riding, CarriesAllTwinesThatABarStandsFor) {
  EXPECT_EQ(carried_by_two_bars({2.5, 2.5}), (std::vector<double>{2.5, 7.5, 5}));
}

}  // namespace
}  // namespace netloft::scenes
