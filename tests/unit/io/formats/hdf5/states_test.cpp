// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "io/formats/hdf5/read.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"
#include "tests/unit/io/formats/hdf5/sheet.hpp"

namespace netloft::formats {
namespace {

const test::Sheet kStatesSheet{5, 3};

class States : public test::InScratchFolder {
 protected:
  Reader written(const std::vector<double>& times) const {
    ResultFile file(in("a.hdf"));
    test::begin(file, kStatesSheet, times.size());
    for (const double time : times) test::write_state(file, kStatesSheet, time);
    file.finish();
    return Reader(in("a.hdf"));
  }
};

TEST_F(States, ComeBackInTheOrderOfTime) {
  const std::vector<double> times = {0.0, 0.25, 0.5, 1.0};
  const Reader reader = written(times);
  EXPECT_EQ(reader.times(), times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(reader.points(i), kStatesSheet.points(times[i]));
    EXPECT_EQ(reader.field(Location::kPoint, "height", i), kStatesSheet.heights(times[i]));
    EXPECT_EQ(reader.field(Location::kPoint, "velocity", i), kStatesSheet.points(times[i]));
    EXPECT_EQ(reader.field(Location::kCell, "strain", i), kStatesSheet.strains(times[i]));
    EXPECT_EQ(reader.field(Location::kPoint, "part", i), kStatesSheet.parts());
  }
}

TEST_F(States, TheNewestComesFirstInTheFileAndHistoryBehindIt) {
  const Reader reader = written({0.0, 0.5, 1.0});
  const auto n = static_cast<std::int64_t>(kStatesSheet.mesh().n_points);
  EXPECT_EQ(reader.integers("/VTKHDF/Steps/PointOffsets"), (std::vector<std::int64_t>{n, 2 * n, 0}));
  std::vector<double> first = reader.reals("/VTKHDF/Points");
  first.resize(static_cast<std::size_t>(3 * n));
  EXPECT_EQ(first, kStatesSheet.points(1.0));
}

TEST_F(States, OneStateNeedsNoHistory) {
  const Reader reader = written({2.0});
  EXPECT_EQ(reader.shape("/VTKHDF/Points"), (std::vector<std::size_t>{kStatesSheet.mesh().n_points, 3}));
  EXPECT_EQ(reader.integers("/VTKHDF/Steps/PointOffsets"), (std::vector<std::int64_t>{0}));
}

TEST_F(States, AreAsManyAsWereAnnouncedAndMoreThanOneBlock) {
  std::vector<double> times(2000);  // 2.3 MB of positions
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = 0.01 * static_cast<double>(i);
  const Reader reader = written(times);
  EXPECT_EQ(reader.times(), times);
  for (std::size_t i = 0; i < times.size(); i += 13)
    ASSERT_EQ(reader.points(i), kStatesSheet.points(times[i])) << i;
  EXPECT_EQ(reader.points(1999), kStatesSheet.points(times[1999]));
}

TEST_F(States, MoreOrFewerThanAnnouncedAreRefused) {
  ResultFile file(in("a.hdf"));
  test::begin(file, kStatesSheet, 2);
  test::write_state(file, kStatesSheet, 0);
  EXPECT_THROW(file.finish(), std::invalid_argument);
  ResultFile other(in("b.hdf"));
  test::begin(other, kStatesSheet, 1);
  test::write_state(other, kStatesSheet, 0);
  EXPECT_THROW(test::write_state(other, kStatesSheet, 1), std::invalid_argument);
}

TEST_F(States, ArraysCarryUnitAndDoc) {
  const Reader reader = written({0.0});
  EXPECT_EQ(reader.text_attribute("/VTKHDF/Points", "unit"), "m");
  EXPECT_EQ(reader.text_attribute("/VTKHDF/PointData/velocity", "unit"), "m/s");
  EXPECT_EQ(reader.text_attribute("/VTKHDF/CellData/strain", "doc"), "Grows along the cells");
}

TEST_F(States, AStaticFieldIsStoredOnceAndAsIntegersIfAsked) {
  const Reader reader = written({0.0, 1.0});
  EXPECT_EQ(reader.shape("/VTKHDF/PointData/part"), (std::vector<std::size_t>{kStatesSheet.mesh().n_points}));
  EXPECT_NO_THROW(reader.integers("/VTKHDF/PointData/part"));
}

TEST_F(States, AMeshWithoutCellsOrPointsIsAllowed) {
  ResultFile file(in("a.hdf"));
  file.begin(Mesh{}, {test::height_spec(), test::strain_spec()}, {}, 2);
  file.write_state(0, {}, {std::span<const double>(), std::span<const double>()});
  file.write_state(1, {}, {std::span<const double>(), std::span<const double>()});
  file.finish();
  EXPECT_EQ(Reader(in("a.hdf")).times().size(), 2u);
  EXPECT_TRUE(Reader(in("a.hdf")).points(1).empty());
}

TEST_F(States, AStateOfTheWrongSizeIsRefusedAndLeavesTheFileAsItWas) {
  ResultFile file(in("a.hdf"));
  EXPECT_THROW(test::write_state(file, kStatesSheet, 0), std::invalid_argument);  // begin() is missing
  test::begin(file, kStatesSheet, 2);
  test::write_state(file, kStatesSheet, 0);
  EXPECT_THROW(test::write_state(file, test::Sheet{6, 3}, 1), std::invalid_argument);
  EXPECT_THROW(file.write_state(1, kStatesSheet.points(1), {}), std::invalid_argument);
  EXPECT_THROW(test::begin(file, kStatesSheet), std::invalid_argument);
  test::write_state(file, kStatesSheet, 2);
  file.finish();
  EXPECT_EQ(Reader(in("a.hdf")).times(), (std::vector<double>{0, 2}));
}

TEST_F(States, AMeshThatContradictsItselfIsRefused) {
  const auto begin_with = [&](auto&& change) {
    Mesh mesh = kStatesSheet.mesh();
    change(mesh);
    ResultFile(in("a.hdf")).begin(mesh, {}, {});
  };
  EXPECT_NO_THROW(begin_with([](Mesh&) {}));
  EXPECT_THROW(begin_with([](Mesh& mesh) { mesh.offsets.pop_back(); }), std::invalid_argument);
  EXPECT_THROW(begin_with([](Mesh& mesh) { mesh.offsets.front() = 1; }), std::invalid_argument);
  EXPECT_THROW(begin_with([](Mesh& mesh) { std::swap(mesh.offsets[1], mesh.offsets[2]); }),
               std::invalid_argument);
  EXPECT_THROW(begin_with([](Mesh& mesh) { mesh.connectivity.push_back(0); }), std::invalid_argument);
  EXPECT_THROW(begin_with([](Mesh& mesh) { mesh.connectivity[0] = 1000; }), std::invalid_argument);
  EXPECT_THROW(begin_with([](Mesh& mesh) { mesh.connectivity[0] = -1; }), std::invalid_argument);
}

TEST_F(States, AFieldThatCannotBeNamedOrFilledIsRefused) {
  const auto begin_with = [&](std::vector<FieldSpec> changing, std::vector<StaticField> fixed) {
    ResultFile(in("a.hdf")).begin(kStatesSheet.mesh(), std::move(changing), fixed);
  };
  EXPECT_THROW(begin_with({{"a/b", "1", ""}}, {}), std::invalid_argument);
  EXPECT_THROW(begin_with({{"", "1", ""}}, {}), std::invalid_argument);
  EXPECT_THROW(begin_with({{"x", "1", ""}, {"x", "1", ""}}, {}), std::invalid_argument);
  EXPECT_THROW(begin_with({}, {{{"part", "1", ""}, {1, 2, 3}}}), std::invalid_argument);
  EXPECT_NO_THROW(begin_with({{"x", "1", "", Location::kPoint}, {"x", "1", "", Location::kCell}}, {}));
}

}  // namespace
}  // namespace netloft::formats
