// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/rope_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::studies {
namespace {

/// A headrope of 4 m in `bars` bars, whose tension grows towards one end like 1/√(distance from this end).
NumbersOnMesh mesh_of(int bars) {
  NumbersOnMesh mesh;
  mesh.mesh = {bars, 1.0 / bars, "bars"};
  results::RopeTensions rope{"headrope", {}, std::vector<double>(static_cast<std::size_t>(bars), 4.0 / bars)};
  for (int bar = 0; bar < bars; ++bar) rope.tension.push_back(100 / std::sqrt(4 - (bar + 0.5) * 4 / bars));
  mesh.ropes.push_back(rope);
  return mesh;
}

TEST(RopeEnds, AreFiguresOfTensions) {
  EXPECT_TRUE(is_of_rope_end("ropes/headrope/tension_starboard"));
  EXPECT_TRUE(is_of_rope_end("rigging/bridle/tension_start"));
  EXPECT_FALSE(is_of_rope_end("ropes/headrope/mass"));
  EXPECT_FALSE(is_of_rope_end("mouth/headline_height"));
}

TEST(RopeEnds, GiveTheTensionInsideAtOnePlaceOfAllMeshes) {
  const std::vector<NumbersOnMesh> meshes{mesh_of(8), mesh_of(16), mesh_of(32)};
  const std::string text = divergence_text("ropes/headrope/tension_starboard", meshes, 2);
  // At 1 m from the end the tension is 100/√1. Straight lines between the middles of bars approach it from
  // above.
  EXPECT_NE(
      text.find(
          "does not converge with the mesh; 1 m from that end, two bars of the coarsest mesh, it is 100"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find(" N ± "), std::string::npos) << text;
}

TEST(RopeEnds, SayNoMoreOfSumsAndOfRopesThatAreNotThere) {
  const std::vector<NumbersOnMesh> meshes{mesh_of(8), mesh_of(16)};
  for (const char* figure :
       {"rigging/bridle/tension_start", "ropes/headrope/tension_largest", "ropes/none/tension_end"})
    EXPECT_EQ(divergence_text(figure, meshes, 1), std::string(figure) + " does not converge with the mesh");
}

}  // namespace
}  // namespace netloft::studies
