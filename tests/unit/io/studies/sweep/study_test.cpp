// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study.hpp"

#include <gtest/gtest.h>

#include <set>

namespace netloft::studies {
namespace {

DesignVariable listed(const std::string& name, const std::vector<double>& numbers, bool in_path) {
  DesignVariable v;
  v.variable.name = name, v.variable.keys = {{"key." + name, 1, 0}}, v.is_in_path = in_path;
  for (const double number : numbers) v.variable.values.push_back(v.variable.value_of(number));
  return v;
}

DesignVariable sampled(const std::string& name) {
  DesignVariable v;
  v.variable.name = name, v.variable.keys = {{"key." + name, 1, 0}}, v.variable.interval = Interval{0, 1};
  return v;
}

StudyFile with(std::vector<DesignVariable> variables) {
  StudyFile file;
  file.name = "s", file.variables = std::move(variables);
  return file;
}

Study made(const StudyFile& file) { return make_study(file, "scene.toml", {{"scene.toml", "fnv1a64:1"}}); }

/// The values of a point as numbers.
std::vector<double> numbers(const std::vector<VariableValue>& values) {
  std::vector<double> all;
  for (const auto& v : values) all.push_back(*v.number);
  return all;
}

std::vector<std::vector<double>> path_of(const StudyItem& item) {
  std::vector<std::vector<double>> path;
  for (const auto& point : item.points) path.push_back(numbers(point.values));
  return path;
}

using Path = std::vector<std::vector<double>>;

TEST(StudyDesign, GoesToAndFroAlongAPath) {
  const Study study = made(with({listed("a", {1, 2}, true), listed("b", {1, 2, 3}, true)}));
  ASSERT_EQ(study.items.size(), 1u);
  EXPECT_EQ(path_of(study.items[0]), (Path{{1, 1}, {1, 2}, {1, 3}, {2, 3}, {2, 2}, {2, 1}}));
  EXPECT_EQ(study.items[0].points[3].set, (std::vector<std::string>{"key.a=2", "key.b=3"}));
}
TEST(StudyDesign, ChangesOneVariableByOneValueFromPointToPoint) {
  const std::vector<double> three{0, 1, 2}, four{0, 1, 2, 3};
  const Study study =
      made(with({listed("a", three, true), listed("b", four, true), listed("c", three, true)}));
  const Path path = path_of(study.items[0]);
  ASSERT_EQ(path.size(), 36u);
  EXPECT_EQ(std::set(path.begin(), path.end()).size(), 36u);
  for (std::size_t p = 1; p < path.size(); ++p) {
    double change = 0;
    for (std::size_t v = 0; v < 3; ++v) change += std::abs(path[p][v] - path[p - 1][v]);
    EXPECT_EQ(change, 1) << p;
  }
}
TEST(StudyDesign, HasAnItemForEveryDrawAndEveryValueOutsideThePath) {
  StudyFile file = with({listed("gear", {1, 2}, false), sampled("mass"), listed("speed", {1, 2, 3}, true)});
  file.samples = 5;
  const Study study = made(file);
  EXPECT_EQ(study.items.size(), 10u);
  EXPECT_EQ(study.point_count(), 30u);
  EXPECT_EQ(study.point_count(), count_points(file));
  EXPECT_EQ(study.items[6].sample, 2u);
  EXPECT_EQ(study.items[6].id, 7u);
  // The gears in a study get the same samples, so that they can be compared sample by sample.
  EXPECT_EQ(study.items[1].values[1].text, study.items[6].values[1].text);
  EXPECT_EQ(study.values_of(study.items[6], study.items[6].points[2]).size(), 3u);
}
TEST(StudyDesign, TakesListsRowByRow) {
  StudyFile file = with({listed("gear", {1, 2, 1}, false), listed("speed", {5, 6, 7}, true)});
  file.combination = Combination::list;
  const Study study = made(file);
  ASSERT_EQ(study.items.size(), 2u);
  EXPECT_EQ(path_of(study.items[0]), (Path{{5}, {7}}));
  EXPECT_EQ(path_of(study.items[1]), (Path{{6}}));
}
TEST(StudyDesign, MakesAnItemOfEveryPointWithoutAPath) {
  const Study study = made(with({listed("a", {1, 2}, false), listed("b", {1, 2, 3}, false)}));
  EXPECT_EQ(study.items.size(), 6u);
  EXPECT_EQ(study.point_count(), 6u);
}
TEST(StudyDesign, HasHashesOfAllThatResultsFollowFrom) {
  const StudyFile file = with({listed("a", {1, 2}, false)});
  const Study study = made(file);
  EXPECT_NE(study.items[0].hash, study.items[1].hash);
  EXPECT_EQ(made(file).items[0].hash, study.items[0].hash);
  StudyFile more = with({listed("a", {7, 1, 2}, false)});
  EXPECT_EQ(made(more).items[1].hash, study.items[0].hash) << "what was computed counts in a larger study";
  StudyFile other = file;
  other.set = {"x=1"};
  EXPECT_NE(made(other).items[0].hash, study.items[0].hash);
  other = file, other.figures = {"gear/drag"};
  EXPECT_NE(made(other).items[0].hash, study.items[0].hash);
  EXPECT_NE(make_study(file, "scene.toml", {{"scene.toml", "fnv1a64:2"}}).items[0].hash, study.items[0].hash);
}

}  // namespace
}  // namespace netloft::studies
