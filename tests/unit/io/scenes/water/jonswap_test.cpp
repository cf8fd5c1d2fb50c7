// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/water/jonswap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace netloft::scenes {
namespace {

const Jonswap kSea{2.5, 9, 3.3, 200, 7};

TEST(Jonswap, HasTheEnergyOfItsSignificantHeight) {
  double m0 = 0;
  for (const auto& c : sample(kSea)) m0 += c.amplitude * c.amplitude / 2;
  EXPECT_NEAR(4 * std::sqrt(m0), kSea.height, 1e-12);
}

TEST(Jonswap, IsTheSameToTheBitForASeedAndAnotherForAnother) {
  const auto a = sample(kSea), b = sample(kSea);
  Jonswap other = kSea;
  other.seed = 8;
  const auto c = sample(other);
  ASSERT_EQ(a.size(), 200u);
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]), 0);
  EXPECT_NE(a[0].phase, c[0].phase);
}

/// The test contains a second SplitMix64, seeded by name and number: every machine must draw the same random
/// numbers.
TEST(Jonswap, DrawsWhatTheGeneratorSays) {
  std::uint64_t state = 14695981039346656037ull;
  for (const char c : {'w', 'a', 'v', 'e', 's'})
    state = (state ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  state ^= 7 * 0x9e3779b97f4a7c15ull;
  const auto next = [&] {
    std::uint64_t z = state += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull, z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  };
  const auto sea = sample(kSea);
  for (const auto& c : sea) {
    next();
    EXPECT_EQ(c.phase, 2 * std::numbers::pi * next());
  }
}

/// Half of the energy of the spectrum is below the frequency `median`, found by Simpson's rule from (1).
TEST(Jonswap, HasItsEnergyWhereTheSpectrumHasIt) {
  double sum = 0, all = 0, median = 0;
  const double h = 1e-4;
  const auto piece = [&](double r) {
    return h / 6 * (Jonswap::shape(r, 3.3) + 4 * Jonswap::shape(r + h / 2, 3.3) + Jonswap::shape(r + h, 3.3));
  };
  for (double r = 0.4; r < 5; r += h) all += piece(r);
  for (double r = 0.4; sum < all / 2; r += h) sum += piece(r), median = r;
  auto sea = sample(kSea);
  std::sort(sea.begin(), sea.end(), [](const auto& a, const auto& b) { return a.omega < b.omega; });
  const double drawn = sea[99].omega * kSea.period / (2 * std::numbers::pi),
               above = sea[100].omega * kSea.period / (2 * std::numbers::pi);
  EXPECT_LE(drawn, median + 1e-3);
  EXPECT_GE(above, median - 1e-3);
}

/// At the peak, a spectrum with γ = 3.3 is 3.3 times that with γ = 1 (DNV-RP-C205, 2010, section 3.5.5).
TEST(Jonswap, PeaksByItsPeakedness) {
  EXPECT_NEAR(Jonswap::shape(1, 3.3) / Jonswap::shape(1, 1), 3.3, 1e-12);
  EXPECT_NEAR(Jonswap::shape(2, 3.3) / Jonswap::shape(2, 1), 1, 1e-12);
}

}  // namespace
}  // namespace netloft::scenes
