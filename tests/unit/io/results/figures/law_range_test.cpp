// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/law_range.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace netloft::results::test {
namespace {

netloft_validity range_of(std::uint32_t quantity, double lo, double hi) {
  netloft_validity v{};
  v.size = sizeof v, v.quantity = quantity, v.lo = lo, v.hi = hi, v.source = "nobody 1991";
  return v;
}

/// A scene with five parts, and one law that acts on all of them.
struct Gear {
  Gear() {
    for (const char* name : {"wing", "body", "belly", "bag", "tail"}) {
      scene.parts.emplace_back();
      scene.parts.back().name = name;
    }
    law.type = "test/screen", law.law.kind = NETLOFT_SCREEN_LAW;
  }
  std::vector<std::string> warnings(const netloft_validity& range, double inside, double outside,
                                    std::vector<std::uint32_t> parts = {0, 1}) {
    return law_range_warnings(scene, {{&law, parts, {{&range, inside, outside, 0.11, 0.62}}}});
  }
  Scene scene;
  LawType law;
};

TEST(LawRange, SaysForHowMuchOfWhichPartsALawIsAskedOutside) {
  const auto solidity = range_of(NETLOFT_SOLIDITY, 0.13, 0.32);
  const auto said = Gear().warnings(solidity, 66, 34);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0],
            "test/screen was measured for a solidity of 0.13 to 0.32 (nobody 1991); 34 % of the area of "
            "wing, body lies outside this range; the values are 0.11 to 0.62");
}

TEST(LawRange, NamesThreePartsAndCountsTheRest) {
  const auto solidity = range_of(NETLOFT_SOLIDITY, 0.13, 0.32);
  EXPECT_NE(Gear().warnings(solidity, 1, 1, {0, 1, 2, 3, 4})[0].find("wing, body, belly and 2 more"),
            std::string::npos);
}

TEST(LawRange, IsSilentAboutWhatRoundsToNothing) {
  const auto solidity = range_of(NETLOFT_SOLIDITY, 0.13, 0.32);
  EXPECT_TRUE(Gear().warnings(solidity, 1000, 4).empty());
  EXPECT_TRUE(Gear().warnings(solidity, 0, 0).empty());
}

TEST(LawRange, WritesRangesWithOneEndAndAngles) {
  EXPECT_EQ(validity_text(range_of(NETLOFT_REYNOLDS, 0, 1e5)), "Reynolds number up to 1e+05, nobody 1991");
  EXPECT_EQ(validity_text(range_of(NETLOFT_ATTACK, std::numbers::pi / 12, std::numbers::pi / 2)),
            "angle of attack 15 to 90°, nobody 1991");
  netloft_validity v = range_of(NETLOFT_REYNOLDS, 200, std::numeric_limits<double>::infinity());
  v.where = "measured_at";
  EXPECT_EQ(validity_text(v), "Reynolds number from 200, nobody 1991; with measured_at");
}

}  // namespace
}  // namespace netloft::results::test
