// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>

#include "io/formats/hdf5/read.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"
#include "tests/unit/io/formats/hdf5/sheet.hpp"

namespace netloft::formats {
namespace {

using test::error_of;
using test::says;

class Reading : public test::InScratchFolder {
 protected:
  void SetUp() override {
    ResultFile file(in("a.hdf"));
    const test::Sheet sheet{3, 2};
    test::begin(file, sheet);
    test::write_state(file, sheet, 1.0);
    file.tree().write_real("/netloft/scalars/drag", 1, "N");
    file.tree().write_reals("/netloft/scalars/pair", std::vector<double>{1, 2}, "N");
    file.tree().write_text("/netloft/scene", "[water]");
    file.finish();
  }
  std::unique_ptr<ResultFile> write_and_keep_open(const std::string& name) const {
    auto file = std::make_unique<ResultFile>(in(name));
    const test::Sheet sheet{3, 2};
    test::begin(*file, sheet);
    test::write_state(*file, sheet, 1.0);
    return file;
  }
  std::string error_of_opening(const std::string& name) const {
    return error_of([&] { Reader reader(in(name)); });
  }
};

TEST_F(Reading, AMissingFileIsNamed) {
  EXPECT_EQ(error_of_opening("b.hdf"), "cannot read " + in("b.hdf").string() + ": there is no such file");
}

TEST_F(Reading, AFolderIsNoFile) { EXPECT_TRUE(says(error_of_opening(""), "it is a folder")); }

TEST_F(Reading, AFileThatIsNotHdf5IsSaidToBeNone) {
  put("b.hdf", "[water]\ndensity = 1025\n");
  EXPECT_TRUE(says(error_of_opening("b.hdf"), "it is not an HDF5 file, nor the journal of a motion"));
  put("empty.hdf", "");
  EXPECT_TRUE(says(error_of_opening("empty.hdf"), "it is not an HDF5 file, nor the journal of a motion"));
}

TEST_F(Reading, ATruncatedFileIsSaidToBeTruncated) {
  const std::string whole = bytes_of("a.hdf");
  put("b.hdf", whole.substr(0, whole.size() / 2));
  EXPECT_TRUE(says(error_of_opening("b.hdf"), "it is truncated")) << error_of_opening("b.hdf");
}

TEST_F(Reading, DamageInsideIsAnErrorAndNotACrash) {
  std::string bytes = bytes_of("a.hdf");
  std::fill(bytes.begin() + 200, bytes.end(), '\x5a');
  put("b.hdf", bytes);
  EXPECT_FALSE(error_of([&] { Reader(in("b.hdf")).points(0); }).empty());
}

TEST_F(Reading, AFileBeingWrittenIsSaidToBe) {
  const test::Companion writer([&] { return write_and_keep_open("b.hdf"); });
  EXPECT_TRUE(says(error_of_opening("b.hdf.part"), "another process is writing it"))
      << error_of_opening("b.hdf.part");
}

TEST_F(Reading, AFileThisProcessWritesIsSaidToBe) {
  const auto file = write_and_keep_open("b.hdf");
  EXPECT_TRUE(says(error_of_opening("b.hdf.part"), "this process is writing it"))
      << error_of_opening("b.hdf.part");
}

TEST_F(Reading, TellsWhatExists) {
  const Reader reader(in("a.hdf"));
  EXPECT_TRUE(reader.has("/netloft/scalars/drag"));
  EXPECT_TRUE(reader.has("/netloft/scalars"));
  EXPECT_TRUE(reader.has("/"));
  EXPECT_FALSE(reader.has("/netloft/scalars/lift"));
  EXPECT_FALSE(reader.has("/none/at/all"));
  EXPECT_EQ(reader.list("/netloft/scalars"), (std::vector<std::string>{"drag", "pair"}));
}

TEST_F(Reading, AMissingDatasetIsNamedWithItsNeighbours) {
  const Reader reader(in("a.hdf"));
  EXPECT_EQ(error_of([&] { reader.real("/netloft/scalars/lift"); }),
            in("a.hdf").string() + " has no /netloft/scalars/lift; /netloft/scalars holds drag, pair");
  EXPECT_TRUE(says(error_of([&] { reader.real("/none/at/all"); }), "; / holds VTKHDF, netloft"));
}

TEST_F(Reading, TheWrongKindIsAnError) {
  const Reader reader(in("a.hdf"));
  EXPECT_TRUE(says(error_of([&] { reader.reals("/netloft/scene"); }), "does not hold numbers"));
  EXPECT_TRUE(says(error_of([&] { reader.text("/netloft/scalars/drag"); }), "does not hold text"));
  EXPECT_TRUE(says(error_of([&] { reader.integers("/netloft/scalars/drag"); }), "holds reals, not integers"));
  EXPECT_TRUE(says(error_of([&] { reader.real("/netloft/scalars/pair"); }), "holds 2 numbers, not one"));
  EXPECT_TRUE(says(error_of([&] { reader.reals("/netloft/scalars"); }), "is a group, not a dataset"));
  EXPECT_TRUE(says(error_of([&] { reader.list("/netloft/scene"); }), "is a dataset, not a group"));
  EXPECT_TRUE(says(error_of([&] { reader.text_attribute("/netloft/scene", "unit"); }),
                   "cannot read the attribute unit"));
  EXPECT_TRUE(says(error_of([&] { reader.real_attribute("/VTKHDF", "Version"); }), "not one number"));
}

TEST_F(Reading, FixedLengthTextIsTextToo) {
  EXPECT_EQ(Reader(in("a.hdf")).text_attribute("/VTKHDF", "Type"), "UnstructuredGrid");
}

TEST_F(Reading, AStepThatDoesNotExistIsAnError) {
  EXPECT_TRUE(says(error_of([&] { Reader(in("a.hdf")).points(1); }), "has 1 states, and no state 1"));
}

}  // namespace
}  // namespace netloft::formats
