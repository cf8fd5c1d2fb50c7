// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/open.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>

#include "io/formats/hdf5/image.hpp"
#include "io/formats/hdf5/read.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"

namespace netloft::formats {
namespace {

using test::error_of;
using test::says;

Handle space_of(hsize_t count) { return Handle(H5Screate_simple(1, &count, nullptr), H5Sclose); }

void make_dataset(hid_t file, const Handle& space, const Handle& properties) {
  const Handle made(H5Dcreate2(file, "/x", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                    H5Dclose);
}

/// Makes HDF5 files that refer to other files. The other file is a pipe without a writer: reading it would
/// never end.
class Opening : public test::InScratchFolder {
 protected:
  void SetUp() override { ASSERT_EQ(mkfifo(other().c_str(), 0600), 0); }

  std::filesystem::path other() const { return in("other"); }

  std::string error_after(const std::function<void(hid_t)>& change) const {
    silence_hdf5();
    {
      const Handle file(H5Fcreate(in("a.hdf").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
      change(file);
    }
    const std::string error = error_of([&] { Reader(in("a.hdf")); });
    EXPECT_EQ(error_of([&] { open_image(bytes_of("a.hdf")); }).empty(), error.empty());
    return error;
  }
};

TEST_F(Opening, RefusesExternalStorage) {
  const std::string error = error_after([&](hid_t file) {
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    check(H5Pset_external(properties, other().c_str(), 0, H5F_UNLIMITED));
    make_dataset(file, space_of(3), properties);
  });
  EXPECT_EQ(error, "cannot read " + in("a.hdf").string() + ": /x has its numbers in another file, " +
                       other().string() +
                       " (external storage); only data in the file itself are read, so ask for a file that "
                       "holds all its data");
}

TEST_F(Opening, RefusesVirtualDatasets) {
  const std::string error = error_after([&](hid_t file) {
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const Handle space = space_of(3);
    check(H5Pset_virtual(properties, space, other().c_str(), "/x", space));
    make_dataset(file, space, properties);
  });
  EXPECT_TRUE(says(error, ": /x is made of datasets of other files (a virtual dataset); only data")) << error;
}

// HDF5 opens the source files of a virtual dataset of unlimited length to find its length.
TEST_F(Opening, RefusesVirtualDatasetsOfUnlimitedLength) {
  const std::string error = error_after([&](hid_t file) {
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const hsize_t count = 3, most = H5S_UNLIMITED, start = 0, one = 1, block = 1;
    const Handle space(H5Screate_simple(1, &count, &most), H5Sclose);
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, &one, &most, &block));
    check(H5Pset_virtual(properties, space, other().c_str(), "/x", space));
    make_dataset(file, space, properties);
  });
  EXPECT_TRUE(says(error, "(a virtual dataset)")) << error;
}

TEST_F(Opening, RefusesLinksThatAreNotHard) {
  const std::string external = error_after([&](hid_t file) {
    check(H5Lcreate_external(other().c_str(), "/x", file, "/x", H5P_DEFAULT, H5P_DEFAULT));
  });
  EXPECT_TRUE(says(external, ": /x is an external link; only data")) << external;
  const std::string soft =
      error_after([](hid_t file) { check(H5Lcreate_soft("/y", file, "/x", H5P_DEFAULT, H5P_DEFAULT)); });
  EXPECT_TRUE(says(soft, ": /x is a soft link; only data")) << soft;
}

TEST_F(Opening, RefusesGroupsThatHaveNoEnd) {
  const auto group_in = [](hid_t place, const char* name) {
    return Handle(H5Gcreate2(place, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  };
  const std::string deep = error_after([&](hid_t file) {
    Handle group = group_in(file, "a");
    for (int i = 0; i < 3000; ++i) group = group_in(group, "a");
  });
  EXPECT_TRUE(says(deep, "/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a/a is nested deeper than 16 groups")) << deep;
  const std::string again = error_after([&](hid_t file) {
    const Handle group = group_in(file, "a");
    for (const char* name : {"b", "c", "d"})
      check(H5Lcreate_hard(file, "/a", group, name, H5P_DEFAULT, H5P_DEFAULT));
  });
  EXPECT_TRUE(says(again, ": /a/b is a group that also appears in another group")) << again;
}

TEST_F(Opening, RefusesNamesThatATerminalObeys) {
  const std::string error = error_after([](hid_t file) {
    const Handle group(H5Gcreate2(file, "a\x1b[31m", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  });
  EXPECT_TRUE(says(error, "the name of /a\\u001b[31m has control characters")) << error;
}

// HDF5 gives a file in memory a name, and looks for a file of this name on the disk.
TEST_F(Opening, OfAnImageLooksForNoFile) {
  const std::string image = hdf5_image([](Tree& tree) { tree.write_real("/netloft/x", 1, "m"); });
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(in(""));
  for (const char* name : {"image", "origins"}) ASSERT_EQ(mkfifo(name, 0600), 0);
  EXPECT_EQ(error_of([&] { open_image(image); }), "");
  std::filesystem::current_path(before);
}

TEST_F(Opening, AcceptsADatasetInTwoPlaces) {
  EXPECT_EQ(error_after([](hid_t file) {
              make_dataset(file, space_of(3), Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose));
              check(H5Lcreate_hard(file, "/x", file, "/y", H5P_DEFAULT, H5P_DEFAULT));
            }),
            "");
}

}  // namespace
}  // namespace netloft::formats
