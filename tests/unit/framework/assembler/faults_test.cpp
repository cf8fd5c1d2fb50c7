// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/faults.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace netloft {
namespace {

netloft_tile tile_with_fault(std::uint32_t first, std::uint32_t lane, FaultNote& note, const char* message) {
  netloft_tile t{};
  t.first = first;
  t.count = 10;
  t.lane_at_fault = lane;
  note.begin(t);
  std::snprintf(t.message, t.message_size, "%s", message);
  return t;
}

TEST(FaultNote, KeepsTheElementWithTheLowestNumber) {
  FaultNote note;
  EXPECT_FALSE(note.is_set());
  note.keep(2, tile_with_fault(64, 3, note, "second"), NETLOFT_OUTSIDE_DOMAIN);
  note.keep(1, tile_with_fault(0, 5, note, "first"), NETLOFT_ERROR);
  note.keep(0, tile_with_fault(128, 0, note, "third"), NETLOFT_OUTSIDE_DOMAIN);
  EXPECT_EQ(note.fault().element, 5u);
  EXPECT_EQ(note.fault().family, 1u);
  EXPECT_EQ(note.fault().status, NETLOFT_ERROR);
  EXPECT_STREQ(note.fault().message, "first");
}

TEST(FaultNote, IsBeforeAnotherWithAHigherElement) {
  FaultNote early, late, none;
  late.keep(0, tile_with_fault(64, 3, late, ""), NETLOFT_ERROR);
  early.keep(0, tile_with_fault(64, 2, early, ""), NETLOFT_ERROR);
  EXPECT_TRUE(early.is_before(late));
  EXPECT_FALSE(late.is_before(early));
  EXPECT_TRUE(late.is_before(none));
  early.clear();
  EXPECT_FALSE(early.is_set());
  EXPECT_FALSE(early.is_before(late));
}

TEST(FaultNote, DoesNotBelieveALaneThatTheTileDoesNotHave) {
  FaultNote note;
  note.keep(0, tile_with_fault(64, 4000, note, ""), NETLOFT_ERROR);
  EXPECT_EQ(note.fault().element, 73u);
}

}  // namespace
}  // namespace netloft
