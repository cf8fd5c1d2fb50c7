// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/field_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::pictures {
namespace {

results::FieldSpread spread_of(const std::vector<double>& values) {
  results::FieldSpread spread;
  spread.take(values);
  return spread;
}

std::vector<double> one_to_hundred() {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i);
  return values;
}

TEST(Scale, GoesFromItsEndsToZeroAndOneAndBack) {
  for (const bool logarithmic : {false, true}) {
    const results::Scale scale{2, 200, logarithmic};
    EXPECT_NEAR(scale.place(2), 0, 1e-12);
    EXPECT_NEAR(scale.place(200), 1, 1e-12);
    EXPECT_EQ(scale.place(1e9), 1);
    EXPECT_NEAR(scale.value(scale.place(30)), 30, 1e-9);
  }
  EXPECT_NEAR((results::Scale{2, 200, true}.value(0.5)), 20, 1e-9);
}

TEST(Scale, HasRoundTicksWithinItsEnds) {
  EXPECT_EQ((results::Scale{0, 100, false}.ticks()), (std::vector<double>{0, 20, 40, 60, 80, 100}));
  EXPECT_EQ((results::Scale{13, 61, false}.ticks()), (std::vector<double>{20, 30, 40, 50, 60}));
  EXPECT_EQ((results::Scale{0.5, 5000, true}.ticks()), (std::vector<double>{1, 10, 100, 1000}));
  EXPECT_EQ((results::Scale{3, 60, true}.ticks()), (std::vector<double>{5, 10, 20, 50}));
}

TEST(FieldSpread, HasAScaleForAConstantFieldAndForOneWithoutValues) {
  for (const double value : {0.0, 3.0, -5.0}) {
    EXPECT_TRUE(std::isfinite(spread_of({value, value}).linear(false).place(value)));
    EXPECT_TRUE(std::isfinite(spread_of({value, value}).logarithmic(false).place(value)));
  }
  EXPECT_FALSE(spread_of({NAN}).is_known());
  EXPECT_TRUE(std::isfinite(spread_of({}).linear(true).place(1)));
}

TEST(FieldSpread, LeavesOutTheFiftiethAtEitherEndOfNettingAndSaysSo) {
  auto values = one_to_hundred();
  values.push_back(NAN), values.push_back(1e9);
  const results::Scale middle = spread_of(values).linear(true), all = spread_of(values).linear(false);
  EXPECT_EQ(middle.lo, 0);  // the scale begins at zero, because zero is near the least value
  EXPECT_EQ(middle.hi, 99);
  EXPECT_TRUE(middle.is_cut_above);
  EXPECT_FALSE(middle.is_cut_below);
  EXPECT_EQ(all.hi, 1e9);
  EXPECT_FALSE(all.is_cut_above);
}

TEST(FieldSpread, BeginsAtItsLeastValueWhereZeroIsFarAway) {
  EXPECT_EQ(spread_of({90, 95, 100}).linear(false).lo, 90);
  EXPECT_EQ(spread_of({-3, 4}).linear(false).lo, -3);
}

TEST(FieldSpread, SpansFourDecadesAtMostLogarithmically) {
  const results::Scale scale = spread_of({0, 1e-9, 1, 1000}).logarithmic(false);
  EXPECT_NEAR(scale.lo, 0.1, 1e-12);
  EXPECT_TRUE(scale.is_cut_below);
}

// Two triangles of one part share two nodes; a third triangle, of another part, has the same nodes.
TEST(ValuesAtCorners, AreMeansOverTheTrianglesOfThePartAlone) {
  results::StoredMesh mesh;
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 1, 2}};
  mesh.triangle_cells = {0, 1, 2};
  mesh.cell_part = {0, 0, 1};
  const auto corners = results::values_at_corners(mesh, {2, 4, 100});
  EXPECT_EQ(corners[0], (std::array<double, 3>{2, 3, 3}));
  EXPECT_EQ(corners[1], (std::array<double, 3>{3, 4, 3}));
  EXPECT_EQ(corners[2], (std::array<double, 3>{100, 100, 100}));
}

TEST(ValuesAtCorners, LeaveOutTrianglesWithoutAValue) {
  results::StoredMesh mesh;
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  mesh.triangle_cells = {0, 1};
  mesh.cell_part = {0, 0};
  const auto corners = results::values_at_corners(mesh, {2, NAN});
  EXPECT_EQ(corners[0], (std::array<double, 3>{2, 2, 2}));
  EXPECT_TRUE(std::isnan(corners[1][1]));
}

}  // namespace
}  // namespace netloft::pictures
