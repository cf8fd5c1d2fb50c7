// SPDX-License-Identifier: BSD-3-Clause
//
// A rope with bending stiffness as a strongly bent cantilever, compared with the elastica.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

/// The end of a horizontally clamped cantilever of length 1 under a downward force P at its end: Bisshopp and
/// Drucker 1945, Large deflection of cantilever beams, Quart. Appl. Math. 3, 272-275. With a = sqrt(P/EI),
/// sin φ₁ = 1/(k sqrt 2):
///   K(k) − F(φ₁, k) = a,  down = 1 − (2/a)[E(k) − E(φ₁, k)],  along = (2/a) sqrt(k² − 1/2)
struct Elastica {
  explicit Elastica(double load) : a(std::sqrt(load)) {
    double low = std::numbers::sqrt2 / 2, high = 1 - 1e-15;
    for (int i = 0; i < 200; ++i) {
      k = 0.5 * (low + high);
      (std::comp_ellint_1(k) - std::ellint_1(k, phi()) < a ? low : high) = k;
    }
  }
  double phi() const { return std::asin(std::min(1.0, 1 / (k * std::numbers::sqrt2))); }
  double down() const { return 1 - 2 / a * (std::comp_ellint_2(k) - std::ellint_2(k, phi())); }
  double along() const { return 2 / a * std::sqrt(k * k - 0.5); }
  double a, k = 0;
};

TEST(Elastica, HasThePublishedDeflections) {
  EXPECT_NEAR(Elastica(1).down(), 0.30172, 5e-6);
  EXPECT_NEAR(1 - Elastica(1).along(), 0.05643, 5e-6);
  EXPECT_NEAR(Elastica(10).down(), 0.81061, 5e-6);
  EXPECT_NEAR(1 - Elastica(10).along(), 0.55500, 5e-6);
}

/// x and z of the end of n bars, measured from the clamp.
std::array<double, 2> bend(int n) {
  const double h = 1 / (n - 0.5);
  const auto text = [](double v) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", v);
    return std::string(digits);
  };
  const SolvedFile s =
      solve_file("verification/cantilever.toml",
                 {"parts.rod.cells=" + std::to_string(n), "parts.rod.length=" + text(n * h),
                  "hold=[{ on = \"rod.start\" }, { on = \"rod.node-1\", at = [" + text(h) + ", 0, 0] }]"});
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << n << " bars: " << s.solved.solution.reason;
  const auto end = s.solved.position(s.node("rod", "end"));
  EXPECT_NEAR(end[1], 0, 1e-9);
  return {end[0] - h / 2, end[2]};
}

TEST(Cantilever, BendsLikeTheElastica) {
  const Elastica exact(10);
  const std::array<double, 2> want = {exact.along(), -exact.down()};
  std::array<double, 2> before{}, coarse{};
  for (int n = 10; n <= 80; n *= 2) {
    const auto got = bend(n);
    std::printf("%3d bars", n);
    for (std::size_t i = 0; i < 2; ++i) {
      const double error = std::abs(got[i] - want[i]), order = std::log2(before[i] / error);
      std::printf("   %.3e m  %6.3f", error, n == 10 ? 0.0 : order);
      if (n > 20) {
        EXPECT_NEAR(order, 2, 0.15) << "bars: " << n;
      }
      before[i] = error;
    }
    std::printf("\n");
    coarse = got;
  }
  EXPECT_LT(std::hypot(coarse[0] - want[0], coarse[1] - want[1]), 5e-4);
}

}  // namespace
}  // namespace netloft::test
