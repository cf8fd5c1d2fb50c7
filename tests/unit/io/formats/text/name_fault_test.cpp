// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/name_fault.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

TEST(NameFault, IsOfNamesThatLeadElsewhere) {
  for (const char* good : {"net", "lowest z", "Größe", "a.b", "..a", "$(x)"}) EXPECT_EQ(name_fault(good), "");
  for (const char* bad : {"", "a/b", "../a", "/a", ".", "..", "...", "a\nb", "a\x1b", "a\xc2\x9b"})
    EXPECT_NE(name_fault(bad), "") << bad;
  EXPECT_NE(name_fault(std::string(101, 'a')), "");
}

}  // namespace
}  // namespace netloft::formats
