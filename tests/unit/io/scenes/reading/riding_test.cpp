// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/riding.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

/// Three nodes with a bar of 2 m between the first two and one of 4 m between the last two.
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
