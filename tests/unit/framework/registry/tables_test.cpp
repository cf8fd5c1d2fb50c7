// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers in the tables of a plugin that no table can have, as what wrote over them leaves behind.
#include "framework/registry/descriptors.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace netloft {
namespace {

netloft_law law() {
  netloft_law l{};
  l.size = sizeof l, l.kind = NETLOFT_TWINE_LAW, l.name = "law", l.doc = "a law";
  l.evaluate = [](const void*, const netloft_law_tile*) -> int { return NETLOFT_OK; };
  return l;
}

/// The message on a plugin with this one law.
std::string refusal(const netloft_law* laws, std::uint32_t count) {
  netloft_plugin p{};
  p.size = sizeof p, p.abi_major = NETLOFT_ABI_MAJOR, p.abi_minor = NETLOFT_ABI_MINOR;
  p.name = "made", p.laws = laws, p.law_count = count;
  try {
    read_plugin(&p, "made.so", "made");
    return "";
  } catch (const PluginRefused& refused) {
    return refused.what();
  }
}

TEST(Tables, OfOneRowAreTaken) {
  const netloft_law one = law();
  EXPECT_EQ(refusal(&one, 1), "");
}

TEST(Tables, LongerThanAnyTableAreRefusedWithoutReadingThem) {
  const netloft_law one = law();
  EXPECT_EQ(refusal(&one, 4000000000u),
            "made.so: has a table of 4000000000 rows; build the plugin again, or look for what wrote over "
            "its tables");
}

TEST(Tables, ThatAreNullAreRefused) {
  EXPECT_NE(refusal(nullptr, 2).find("has a table of 2 rows that is null"), std::string::npos);
}

TEST(Tables, WithRowsTooShortForASizeAreRefused) {
  netloft_law one = law();
  one.size = 0;
  EXPECT_NE(refusal(&one, 2).find("has a table whose rows are 0 bytes long"), std::string::npos);
}

// Half a pointer is a wild one. Found by table_fuzzer.
TEST(Tables, WithRowsThatEndWithinAPointerAreRefused) {
  netloft_law one = law();
  one.size = offsetof(netloft_law, parameters) + 4;
  EXPECT_NE(refusal(&one, 1).find("bytes long"), std::string::npos);
}

TEST(Tables, HaveRowsAsLongAsTheFirst) {
  netloft_law two[2] = {law(), law()};
  two[1].name = "second";
  EXPECT_EQ(refusal(two, 2), "");
  two[1].size = sizeof two[1] + 8;
  EXPECT_NE(refusal(two, 2).find("rows are not equally long"), std::string::npos);
}

}  // namespace
}  // namespace netloft
