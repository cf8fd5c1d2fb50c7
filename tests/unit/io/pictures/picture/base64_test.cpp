// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/base64.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(bytes_of("")), "");
  EXPECT_EQ(base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes_of("foo")), "Zm9v");
  EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
  EXPECT_EQ(base64(bytes_of("\xff\xfe\xfd")), "//79");
}

TEST(Deflated, IsSmallerWhereBytesRepeat) {
  const std::string text(10000, 'a');
  EXPECT_LT(deflated(bytes_of(text)).size(), 100u);
}

}  // namespace
}  // namespace netloft::pictures
