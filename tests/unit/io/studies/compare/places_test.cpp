// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/discretisation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::studies {
namespace {

/// A rope along x in n bars, with nodes at (s, f(s), 0).
template <class F>
scenes::LoadedScene rope(int n, const F& f) {
  scenes::LoadedScene loaded;
  scenes::PartGeometry part;
  part.name = "rope", part.cells = {n};
  for (int i = 0; i <= n; ++i) {
    part.nodes.push_back(static_cast<std::uint32_t>(i));
    const double s = double(i) / n;
    loaded.scene.positions.insert(loaded.scene.positions.end(), {s, f(s, 1.0 / n), 0});
  }
  loaded.parts.push_back(part);
  return loaded;
}

/// A panel of 3 x 2 meshes in n x n cells, flat.
scenes::LoadedScene panel(int n) {
  scenes::LoadedScene loaded;
  scenes::PartGeometry part;
  part.name = "net", part.cells = {n, n};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      part.nodes.push_back(static_cast<std::uint32_t>(part.nodes.size()));
      part.panel.push_back({3.0 * i / n, 2.0 * j / n});
      loaded.scene.positions.insert(loaded.scene.positions.end(), {3.0 * i / n, 2.0 * j / n, 0});
    }
  loaded.parts.push_back(part);
  return loaded;
}

Places places(const scenes::LoadedScene& loaded) { return places_of(loaded, loaded.scene.positions); }

std::size_t common(const Places& a, const Places& b) {
  std::size_t n = 0;
  for (const auto& [spot, place] : a) n += b.contains(spot);
  return n;
}

TEST(Places, OfTwoMeshesMeetWhereNodesCoincide) {
  EXPECT_EQ(common(places(panel(4)), places(panel(8))), 25u);
  EXPECT_EQ(common(places(panel(6)), places(panel(9))), 16u);  // they share the thirds, 4 x 4 nodes
  EXPECT_EQ(common(places(panel(1000)), places(panel(1000))), 1001u * 1001u);
  EXPECT_EQ(largest_distance(places(panel(6)), places(panel(9))), 0);
}

TEST(Places, OfMeshesWithoutACommonNodeHaveNoDistance) {
  scenes::LoadedScene other = panel(4);
  Places none;
  EXPECT_TRUE(std::isnan(largest_distance(places(other), none)));
}

TEST(Places, AreAsFarApartAsTheirFarthestNode) {
  const auto flat = [](double, double) { return 0.0; };
  const auto bump = [](double s, double) { return s == 0.5 ? 0.3 : 0.0; };
  EXPECT_DOUBLE_EQ(largest_distance(places(rope(4, flat)), places(rope(8, bump))), 0.3);
}

/// The position of a node at s on a mesh of width h: it differs by h² sin πs from its limit for h → 0.
double second_order(double s, double h) { return std::sin(3 * s) + h * h * std::sin(M_PI * s); }

Discretisation judged(const std::vector<int>& cells, double (*f)(double, double)) {
  Discretisation d;
  std::vector<Places> all;
  for (const int n : cells) {
    all.push_back(places(rope(n, f)));
    d.levels.emplace_back();
    d.levels.back().cells = n;
  }
  judge_meshes(all, d);
  return d;
}

TEST(Discretisation, FindsOrderAndErrorOfEveryMesh) {
  const Discretisation d = judged({4, 8, 16, 32}, second_order);
  EXPECT_TRUE(d.steady);
  EXPECT_NEAR(d.order, 2, 1e-9);
  for (const auto& level : d.levels) {
    const double n = static_cast<double>(level.cells);
    EXPECT_NEAR(level.error, 1 / (n * n), 1e-9) << n;  // largest in the middle, which is a node of all meshes
  }
  EXPECT_TRUE(std::isnan(d.levels[1].order));
  EXPECT_NEAR(d.levels[2].order, 2, 1e-9);
}

TEST(Discretisation, ComparesWithTheFinestWhereNothingIsSteady) {
  const auto jumpy = [](double s, double h) { return s == 0.5 ? std::cos(1 / h) : 0.0; };
  const Discretisation d = judged({4, 8, 16}, jumpy);
  EXPECT_FALSE(d.steady);
  EXPECT_NEAR(d.levels[0].error, std::abs(std::cos(4.0) - std::cos(16.0)), 1e-12);
  EXPECT_TRUE(std::isnan(d.levels[2].error));
}

TEST(Discretisation, OfTwoMeshesIsADifference) {
  const Discretisation d = judged({4, 8}, second_order);
  EXPECT_FALSE(d.steady);
  EXPECT_NEAR(d.levels[0].error, 1. / 16 - 1. / 64, 1e-12);
}

}  // namespace
}  // namespace netloft::studies
