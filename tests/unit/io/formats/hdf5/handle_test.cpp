// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "tests/unit/io/formats/hdf5/scratch.hpp"

namespace netloft::formats {
namespace {

int closed = 0;

herr_t count_and_close(hid_t id) {
  ++closed;
  return H5Sclose(id);
}

TEST(Handle, TheCleanUpAtExitIsOffAheadOfAnyCall) { EXPECT_LT(H5dont_atexit(), 0) << "it was on until now"; }

TEST(Handle, ClosesExactlyOnce) {
  closed = 0;
  {
    Handle first(H5Screate(H5S_SCALAR), count_and_close);
    Handle second(std::move(first));
    Handle third;
    third = std::move(second);
    EXPECT_EQ(closed, 0);
  }
  EXPECT_EQ(closed, 1);
}

TEST(Handle, CloseCanBeCalledAheadOfTheDestructor) {
  closed = 0;
  {
    Handle space(H5Screate(H5S_SCALAR), count_and_close);
    space.close();
    EXPECT_EQ(closed, 1);
  }
  EXPECT_EQ(closed, 1);
}

TEST(Handle, ANegativeIdBecomesTheHdf5Message) {
  silence_hdf5();
  const std::string message =
      test::error_of([] { Handle(H5Fopen("/no/such/file.hdf", H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose); });
  EXPECT_TRUE(test::says(message, "unable to open file")) << message;
  EXPECT_TRUE(test::says(message, "No such file or directory")) << message;
}

TEST(Handle, NothingIsPrintedInAnyThreadThatAskedForSilence) {
  testing::internal::CaptureStderr();
  std::thread([] {
    silence_hdf5();
    H5Fopen("/no/such/file.hdf", H5F_ACC_RDONLY, H5P_DEFAULT);
    H5Eclear2(H5E_DEFAULT);  // HDF5 leaks the error stack of a thread that ends
  }).join();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Handle, ContextGoesInFrontOfTheReason) {
  EXPECT_EQ(test::error_of([] { with_context("cannot x", [] { throw FileError("because"); }); }),
            "cannot x: because");
}

}  // namespace
}  // namespace netloft::formats
