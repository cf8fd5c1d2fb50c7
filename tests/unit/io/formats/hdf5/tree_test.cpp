// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/formats/hdf5/read.hpp"
#include "io/formats/hdf5/result_file.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"

namespace netloft::formats {
namespace {

class TreeOfData : public test::InScratchFolder {
 protected:
  template <class Write>
  Reader written(Write&& write) const {
    ResultFile file(in("a.hdf"));
    write(file.tree());
    file.finish();
    return Reader(in("a.hdf"));
  }
};

TEST_F(TreeOfData, NumbersComeBackBitByBit) {
  const std::vector<double> reals = {0.1, -0.0, 1e-310, std::numeric_limits<double>::infinity()};
  const std::vector<std::int64_t> ints = {std::numeric_limits<std::int64_t>::min(), 0,
                                          std::numeric_limits<std::int64_t>::max()};
  const Reader reader = written([&](Tree& tree) {
    tree.write_reals("/netloft/reals", reals, "N", "forces");
    tree.write_ints("/netloft/ints", ints, "1");
    tree.write_real("/netloft/scalars/drag", 4.25e4, "N", "drag of the gear");
    tree.write_int("/netloft/count", -7, "1");
  });
  EXPECT_EQ(reader.reals("/netloft/reals"), reals);
  EXPECT_TRUE(std::signbit(reader.reals("/netloft/reals")[1]));
  EXPECT_EQ(reader.integers("/netloft/ints"), ints);
  EXPECT_EQ(reader.real("/netloft/scalars/drag"), 4.25e4);
  EXPECT_EQ(reader.integer("/netloft/count"), -7);
  EXPECT_TRUE(reader.shape("/netloft/count").empty());
}

TEST_F(TreeOfData, AMatrixKeepsRowsAndColumns) {
  const std::vector<double> values = {1, 2, 3, 4, 5, 6};
  const Reader reader = written([&](Tree& tree) { tree.write_matrix("/netloft/m", values, 3, "N"); });
  EXPECT_EQ(reader.shape("/netloft/m"), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(reader.reals("/netloft/m"), values);
}

TEST_F(TreeOfData, AMatrixThatDoesNotFillItsRowsIsRefused) {
  ResultFile file(in("a.hdf"));
  EXPECT_THROW(file.tree().write_matrix("/netloft/m", std::vector<double>(5), 3, "N"), std::invalid_argument);
  EXPECT_THROW(file.tree().write_matrix("/netloft/m", std::vector<double>(), 0, "N"), std::invalid_argument);
}

TEST_F(TreeOfData, LengthZeroIsALength) {
  const Reader reader = written([](Tree& tree) {
    tree.write_reals("/netloft/reals", {}, "N");
    tree.write_ints("/netloft/ints", {}, "1");
    tree.write_strings("/netloft/strings", {});
    tree.write_matrix("/netloft/matrix", {}, 3, "N");
    tree.write_text("/netloft/text", "");
  });
  EXPECT_TRUE(reader.reals("/netloft/reals").empty());
  EXPECT_TRUE(reader.integers("/netloft/ints").empty());
  EXPECT_TRUE(reader.strings("/netloft/strings").empty());
  EXPECT_EQ(reader.shape("/netloft/matrix"), (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(reader.text("/netloft/text"), "");
}

TEST_F(TreeOfData, TextOfAnyBytesComesBack) {
  std::string every_byte;
  for (int i = 0; i < 256; ++i) every_byte.push_back(static_cast<char>(i));
  const std::vector<std::string> texts = {"plain",
                                          "Grundtau, Flügel 42°, 网, 🐟",
                                          "line\r\nline\t",
                                          "\xff\xfe",
                                          "é\xe9",
                                          std::string("nul\0inside", 10),
                                          std::string(1, '\0'),
                                          every_byte,
                                          "\xed\xa0\x80" /* surrogate */,
                                          "\xc0\x80" /* overlong */,
                                          "\xf4\x90\x80\x80" /* too large */,
                                          "cut \xe2\x82",
                                          std::string(300000, 'x')};
  const Reader reader = written([&](Tree& tree) {
    for (std::size_t i = 0; i < texts.size(); ++i)
      tree.write_text("/netloft/t" + std::to_string(i), texts[i]);
  });
  for (std::size_t i = 0; i < texts.size(); ++i)
    EXPECT_EQ(reader.text("/netloft/t" + std::to_string(i)), texts[i]) << i;
}

TEST_F(TreeOfData, OnlyTextThatIsNoUtf8IsStoredAsBytes) {
  const Reader reader = written([](Tree& tree) {
    tree.write_text("/netloft/utf8", "Flügel 网 🐟");
    tree.write_text("/netloft/bytes", "\xfcgel");
  });
  EXPECT_FALSE(reader.has_attribute("/netloft/utf8", "content"));
  EXPECT_EQ(reader.text_attribute("/netloft/bytes", "content"), "bytes");
}

TEST_F(TreeOfData, StringArraysKeepEmptyEntries) {
  const std::vector<std::string> names = {"belly", "", "Flügel"};
  const Reader reader = written([&](Tree& tree) { tree.write_strings("/netloft/parts", names, "names"); });
  EXPECT_EQ(reader.strings("/netloft/parts"), names);
}

TEST_F(TreeOfData, ANulInAnArrayOfStringsIsRefused) {
  ResultFile file(in("a.hdf"));
  const std::vector<std::string> names = {std::string("a\0b", 3)};
  EXPECT_THROW(file.tree().write_strings("/netloft/parts", names), std::invalid_argument);
}

TEST_F(TreeOfData, UnitsAndDocsAreAttributes) {
  const Reader reader = written([](Tree& tree) {
    tree.write_real("/netloft/drag", 1, "N", "drag of the gear");
    tree.write_real("/netloft/bare", 1, "");
  });
  EXPECT_EQ(reader.text_attribute("/netloft/drag", "unit"), "N");
  EXPECT_EQ(reader.text_attribute("/netloft/drag", "doc"), "drag of the gear");
  EXPECT_FALSE(reader.has_attribute("/netloft/bare", "unit"));
}

TEST_F(TreeOfData, AttributesOfAllKindsAreReplacedWhenSetAgain) {
  const Reader reader = written([](Tree& tree) {
    tree.set_attribute("/netloft/run/deep", "status", "running");
    tree.set_attribute("/netloft/run/deep", "status", "converged, größer");
    tree.set_attribute("/netloft/run/deep", "iterations", 12);
    tree.set_attribute("/netloft/run/deep", "residual", 1e-11);
    tree.write_text("/netloft/scene", "");
    tree.set_attribute("/netloft/scene", "path", "");
  });
  EXPECT_EQ(reader.text_attribute("/netloft/run/deep", "status"), "converged, größer");
  EXPECT_EQ(reader.real_attribute("/netloft/run/deep", "iterations"), 12);
  EXPECT_EQ(reader.real_attribute("/netloft/run/deep", "residual"), 1e-11);
  EXPECT_EQ(reader.text_attribute("/netloft/scene", "path"), "");
}

TEST_F(TreeOfData, ADatasetCanBeWrittenAnewInAnotherShape) {
  const Reader reader = written([](Tree& tree) {
    tree.write_reals("/netloft/residual", std::vector<double>{1}, "N");
    tree.write_reals("/netloft/residual", std::vector<double>{1, 0.1}, "N");
  });
  EXPECT_EQ(reader.reals("/netloft/residual"), (std::vector<double>{1, 0.1}));
}

TEST_F(TreeOfData, AGroupIsNotReplacedByADataset) {
  ResultFile file(in("a.hdf"));
  file.tree().write_real("/netloft/scalars/drag", 1, "N");
  EXPECT_THROW(file.tree().write_real("/netloft/scalars", 1, "N"), std::invalid_argument);
}

TEST_F(TreeOfData, ADatasetInTheWayOfAGroupIsAnErrorThatNamesThePath) {
  ResultFile file(in("a.hdf"));
  file.tree().write_real("/netloft/drag", 1, "N");
  const std::string message = test::error_of([&] { file.tree().write_real("/netloft/drag/belly", 1, "N"); });
  EXPECT_TRUE(test::says(message, "cannot write /netloft/drag/belly in")) << message;
}

TEST_F(TreeOfData, PathsAreAbsolute) {
  ResultFile file(in("a.hdf"));
  for (const char* path : {"", "netloft/x", "/netloft/"})
    EXPECT_THROW(file.tree().write_real(path, 1, "N"), std::invalid_argument) << path;
}

}  // namespace
}  // namespace netloft::formats
