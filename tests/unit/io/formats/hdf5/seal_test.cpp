// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/seal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "io/formats/hdf5/read.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"
#include "tests/unit/io/formats/hdf5/sheet.hpp"

namespace netloft::formats {
namespace {

using test::error_of;
using test::says;

class SealedResult : public test::InScratchFolder {
 protected:
  void SetUp() override {
    ResultFile file(in("a.hdf"));
    const test::Sheet sheet{3, 2};
    test::begin(file, sheet, 2);
    test::write_state(file, sheet, 0.0);
    test::write_state(file, sheet, 1.0);
    file.tree().write_real("/netloft/scalars/drag", 42, "N", "Drag of the gear");
    file.tree().write_text("/netloft/scene", "[water]");
    file.finish();
    bytes_ = bytes_of("a.hdf");
    table_ = bytes_.find("netloft checksums 1\n");
  }

  std::string error_with_flipped_bit(std::size_t at, int bit) const {
    const Descriptor file(open(in("a.hdf").c_str(), O_RDWR));
    const char flipped = static_cast<char>(bytes_[at] ^ (1 << bit));
    EXPECT_EQ(pwrite(file.get(), &flipped, 1, static_cast<off_t>(at)), 1);
    const std::string error = error_of([&] { check_seal(in("a.hdf")); });
    EXPECT_EQ(pwrite(file.get(), &bytes_[at], 1, static_cast<off_t>(at)), 1);
    return error;
  }

  std::string bytes_;
  std::size_t table_ = 0;
};

TEST_F(SealedResult, IsReadAsItWasWritten) {
  ASSERT_NE(table_, std::string::npos);
  EXPECT_EQ(error_of([&] { check_seal(in("a.hdf")); }), "");
  EXPECT_EQ(Reader(in("a.hdf")).real("/netloft/scalars/drag"), 42);
}

TEST_F(SealedResult, ShowsEveryFlippedBit) {
  for (std::size_t at = 0; at < table_; at += 3)
    ASSERT_TRUE(says(error_with_flipped_bit(at, static_cast<int>(at % 8)), "it is damaged: "))
        << "byte " << at;
}

TEST_F(SealedResult, NamesTheDatasetWhoseNumbersChanged) {
  const double drag = 42;
  const std::size_t at = bytes_.find(std::string(reinterpret_cast<const char*>(&drag), sizeof drag));
  ASSERT_LT(at, table_);
  EXPECT_EQ(error_with_flipped_bit(at + 7, 6),
            "cannot read " + in("a.hdf").string() +
                ": it is damaged: /netloft/scalars/drag does not match its checksum");
  const std::size_t doc = bytes_.find("Drag of the gear");
  EXPECT_TRUE(says(error_with_flipped_bit(doc, 1), "its names, texts or attributes do not match"));
}

/// If the table itself is damaged, the file is refused or read like a file without a table.
TEST_F(SealedResult, IsNeverReadWrongWhereItsTableIsDamaged) {
  std::size_t refused = 0;
  for (std::size_t at = table_; at < bytes_.size(); ++at)
    refused += !error_with_flipped_bit(at, static_cast<int>(at % 8)).empty();
  EXPECT_GE(refused, bytes_.size() - table_ - 8);
}

/// HDF5 would loop for ever at an object of zero length.
TEST_F(SealedResult, WithoutItsTableIsRefusedWhereItsTextsLeadNowhere) {
  const std::string kBegin("GCOL\1", 5);
  std::string whole = bytes_.substr(0, table_);
  const std::size_t texts = whole.find(kBegin);
  ASSERT_NE(texts, std::string::npos);
  put("b.hdf", whole);
  EXPECT_EQ(error_of([&] { check_seal(in("b.hdf")); }), "");
  const auto error_with_first_object = [&](char index, const std::string& length) {
    std::string damaged = whole;
    damaged[texts + 16] = index, damaged.replace(texts + 24, 8, length);
    put("b.hdf", damaged);
    return error_of([&] { Reader(in("b.hdf")).text("/netloft/scene"); });
  };
  const std::string kNone(8, '\0'), kMost(8, '\xff'), kAlmost = "\xe9" + kMost.substr(1);
  for (const auto& [index, length] :
       {std::pair('\0', kNone), {'\0', kMost}, {'\1', kMost}, {'\1', kAlmost}}) {
    const std::string error = error_with_first_object(index, length);
    EXPECT_TRUE(says(error, "it is damaged: the texts at byte " + std::to_string(texts))) << error;
  }
}

TEST_F(SealedResult, IsReadUncheckedAfterAnotherProgramChangedIt) {
  {
    const Handle file(H5Fopen(in("a.hdf").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    Tree(file, "a.hdf").write_real("/netloft/scalars/drag", 43, "N");
  }
  EXPECT_EQ(bytes_of("a.hdf").find("netloft checksums 1\n"), std::string::npos);
  EXPECT_EQ(Reader(in("a.hdf")).real("/netloft/scalars/drag"), 43);
}

TEST_F(SealedResult, WithATableOfOtherBytesIsRefused) {
  put("b.hdf", bytes_.substr(0, 1000) + bytes_.substr(table_));
  EXPECT_TRUE(says(error_of([&] { check_seal(in("b.hdf")); }), "it is damaged"));
  put("c.hdf", bytes_.substr(bytes_.size() - 33));
  EXPECT_TRUE(says(error_of([&] { check_seal(in("c.hdf")); }), "it is damaged"));
}

}  // namespace
}  // namespace netloft::formats
