// SPDX-License-Identifier: BSD-3-Clause
//
// Random sheets that cross each other, and random tubes within tubes that do not.
#include "io/results/figures/passages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace netloft::results {
namespace {

/// Layers of netting with one part per surface.
struct Surfaces {
  Layers layers;
  std::vector<double> positions;
  std::uint32_t parts = 0;

  /// Adds a surface of `rows` by `columns` cells; place(u, v) is the position of a node, for u and v from 0
  /// to 1.
  template <class Place>
  void add(std::size_t rows, std::size_t columns, bool is_closed, Place&& place) {
    const auto first = static_cast<std::uint32_t>(positions.size() / 3);
    const std::size_t across = is_closed ? columns : columns + 1;
    for (std::size_t i = 0; i <= rows; ++i)
      for (std::size_t j = 0; j < across; ++j)
        for (const double x : place(double(i) / double(rows), double(j) / double(columns)))
          positions.push_back(x);
    const auto node = [&](std::size_t i, std::size_t j) {
      return first + static_cast<std::uint32_t>(i * across + j % across);
    };
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        layers.triangles.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
        layers.triangles.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
        layers.part_of_triangle.insert(layers.part_of_triangle.end(), 2, parts);
      }
    ++parts;
  }
};

class RandomSurfaces : public testing::TestWithParam<unsigned> {
 protected:
  double real(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  std::size_t whole(std::size_t least, std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(least, most)(random_);
  }
  std::mt19937 random_{GetParam()};
};

// A level sheet of 4 m, and one that stands on end and passes through it along a known line.
TEST_P(RandomSurfaces, AreFoundWhereTheyCross) {
  Surfaces s;
  s.add(whole(4, 20), whole(4, 20), false, [](double u, double v) {
    return std::array{4 * u - 2, 4 * v - 2, 0.0};
  });
  const double x = real(-1, 1), turn = real(-0.5, 0.5), tilt = real(0.6, std::numbers::pi - 0.6);
  s.add(whole(4, 12), whole(4, 12), false, [&](double u, double v) {
    const double along = 2 * v - 1, up = 2.3 * (u - 0.5);
    return std::array{x + up * std::cos(tilt), along * std::cos(turn), up * std::sin(tilt) + along * 0.02};
  });
  const auto found = find_passages(s.layers, s.positions);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].part, found[0].through);
  EXPECT_NEAR(found[0].at[2], 0, 0.05) << "on the level sheet";
  EXPECT_NEAR(found[0].at[0], x, 0.1) << "on the line along which the other sheet crosses it";
}

// A line of two bars through a sheet pierces one triangle.
TEST_P(RandomSurfaces, ArePiercedByALine) {
  Surfaces s;
  s.add(whole(4, 20), whole(4, 20), false, [](double u, double v) {
    return std::array{4 * u - 2, 4 * v - 2, 0.0};
  });
  const auto first = static_cast<std::uint32_t>(s.positions.size() / 3);
  const double x = real(-1.5, 1.5), y = real(-1.5, 1.5);
  for (const double z : {-3.0, 2.0, 5.0}) s.positions.insert(s.positions.end(), {x + 0.1 * z, y, z});
  for (const std::uint32_t k : {0u, 1u}) s.layers.bars.push_back({{first + k, first + k + 1}, 7});
  const auto found = find_passages(s.layers, s.positions);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].part, 7u);
  EXPECT_EQ(found[0].through, 0u);
  EXPECT_EQ(found[0].places, 1u);
  EXPECT_NEAR(found[0].at[0], x, 1e-9);
  EXPECT_NEAR(found[0].at[1], y, 1e-9);
}

// Cones within cones, sewn to nothing, that leave a gap of a tenth of their radius.
TEST_P(RandomSurfaces, AreCleanWithinEachOther) {
  Surfaces s;
  double radius = real(0.3, 1.0);
  const double taper = real(0.3, 1), length = real(1, 6), bend = real(-0.3, 0.3);
  for (std::size_t layer = 0; layer < 4; ++layer, radius *= real(1.12, 1.4))
    s.add(whole(3, 30), whole(12, 30), true, [&](double u, double v) {
      const double r = radius * (1 - (1 - taper) * u), a = 2 * std::numbers::pi * v;
      return std::array{length * u, r * std::cos(a) + bend * u * u, r * std::sin(a)};
    });
  EXPECT_TRUE(find_passages(s.layers, s.positions).empty());
}

INSTANTIATE_TEST_SUITE_P(Drawn, RandomSurfaces, testing::Range(1u, 101u));

}  // namespace
}  // namespace netloft::results
