// SPDX-License-Identifier: BSD-3-Clause
//
// Ropes of straight bars: compared bar by bar with an independent program, and with the elastic catenary, the
// limit for short bars.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/sample_scenes.hpp"
#include "tests/verification/reference.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

class RopeInBars : public testing::TestWithParam<int> {};

TEST_P(RopeInBars, LiesAsTheIndependentProgramSays) {
  const Level want = read_level("rope-in-bars.txt", GetParam());
  const Solved s = solve(sample::hanging_rope(want.n));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  double worst = 0;
  for (const auto& node : want.nodes) {
    const auto x = s.position(static_cast<std::uint32_t>(node[0]));
    worst = std::max(worst, std::hypot(x[0] - node[1], x[1], x[2] - node[2]));
  }
  const auto start = s.reaction(0);
  const double energy = relative(s.solution.energy, want.values[0]),
               force = std::hypot(start[0] - want.values[1], start[2] - want.values[2]) /
                       std::hypot(want.values[1], want.values[2]);
  std::printf("%4d bars: %3d iterations, node %.1e m, energy %.1e, reaction %.1e\n", want.n,
              s.solution.cost.statistics.iterations, worst, energy, force);
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(energy, 1e-12);
  EXPECT_LT(force, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(AllBars, RopeInBars, testing::Values(10, 20, 40, 80, 160),
                         testing::PrintToStringParamName());

/// Ends at one height, by Irvine, Cable Structures, MIT Press 1981, eq. 2.25 to 2.27:
///   span = H L₀/EA + (2H/w) asinh(w L₀/2H)                          (1)
///   sag = w L₀²/(8 EA) + (H/w) (√(1 + (w L₀/2H)²) − 1)              (2)
///   T at the ends = √(H² + (w L₀/2)²)                               (3)
/// L₀ [m] unstretched length, w [N/m] weight per unstretched metre, EA [N].
struct Catenary {
  double span, L0, w, EA;
  double H() const {
    double low = 1e-9 * w * L0, high = 1e9 * w * L0;
    for (int i = 0; i < 200; ++i) {
      const double middle = std::sqrt(low * high);
      const double x = middle * L0 / EA + 2 * middle / w * std::asinh(w * L0 / (2 * middle));  // (1)
      (x < span ? low : high) = middle;
    }
    return low;
  }
  double sag() const {
    const double h = H();
    return w * L0 * L0 / (8 * EA) + h / w * (std::hypot(1, w * L0 / (2 * h)) - 1);  // (2)
  }
  double T_end() const { return std::hypot(H(), w * L0 / 2); }  // (3)
};

/// A scene file and its expected results: the closed form, and the published digits.
struct Case {
  const char *name, *file;
  std::vector<std::string> overrides;
  const char* part;
  Catenary rope;
  double H, sag, T_end;  // published; 0: not published
  double digits;         // half a unit of the last published digit, relative
};

const double kWireWeight = 2844.23 * 2.2783e-4 * 9.81;  // [N/m]
const Case kCases[] = {
    // code_aster, validation V6.02.114
    {"Cold",
     "verification/catenary-cold.toml",
     {},
     "wire",

     {325, 325, kWireWeight, 12986310},
     13206.24,
     6.352161,
     13246.58,
     5e-7},
    {"Heated",
     "verification/catenary-heated.toml",
     {},
     "wire",

     {325, 325.2934685, kWireWeight, 12986310},
     10241.73,
     8.195452,
     0,
     5e-7},
    // closed form (1) to (3), evaluated by another program to nine digits
    {"EA100",
     "hanging-rope.toml",
     {},
     "rope",

     {8, 10, 1, 100},
     2.99708988,
     2.95736530,
     5.82945518,
     5e-9},
    {"EA1000",
     "hanging-rope.toml",
     {"parts.rope.rope.EA=1000"},
     "rope",

     {8, 10, 1, 1000},
     3.33548086,
     2.68746276,
     6.01044363,
     5e-9},
};

/// Sag, horizontal tension and tension at the ends.
using Values3 = std::array<double, 3>;

Values3 exact(const Case& c) { return {c.rope.sag(), c.rope.H(), c.rope.T_end()}; }

Values3 solve_in_bars(const Case& c, int bars, bool sagging = false) {
  auto overrides = c.overrides;
  if (sagging) overrides.push_back(std::string("parts.") + c.part + ".rope.sag=1");
  overrides.push_back(std::string("parts.") + c.part + ".cells=" + std::to_string(bars));
  const SolvedFile s = solve_file(c.file, overrides);
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  const auto end = s.solved.reaction(s.node(c.part, "end"));
  return {-s.solved.position(s.node(c.part, "middle"))[2], end[0], std::hypot(end[0], end[1], end[2])};
}

class ElasticCatenary : public testing::TestWithParam<Case> {};

TEST_P(ElasticCatenary, HasAClosedFormThatGivesThePublishedDigits) {
  const Case& c = GetParam();
  EXPECT_LT(relative(c.rope.H(), c.H), c.digits);
  EXPECT_LT(relative(c.rope.sag(), c.sag), c.digits);
  if (c.T_end > 0) {
    EXPECT_LT(relative(c.rope.T_end(), c.T_end), c.digits);
  }
}

TEST_P(ElasticCatenary, IsApproachedWithTheSquareOfTheBarLength) {
  const Values3 want = exact(GetParam());
  Values3 before{};
  std::printf("bars   sag         order   H           order   T at end    order   (relative errors)\n");
  for (int bars = 10; bars <= 320; bars *= 2) {
    const Values3 got = solve_in_bars(GetParam(), bars);
    std::printf("%4d", bars);
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = relative(got[k], want[k]), order = std::log2(before[k] / error);
      std::printf("   %.3e  %6.3f", error, bars == 10 ? 0.0 : order);
      if (bars > 10) {
        EXPECT_NEAR(order, 2, 0.1) << "value " << k << " at " << bars << " bars";
      }
      before[k] = error;
    }
    std::printf("\n");
  }
}

// The error of straight bars is of the order of (1/200)^2 = 2.5e-5, because a rope also sags within each bar
// and a chord is shorter than its arc. This error is so regular that extrapolation from 100 and 200 bars
// leaves 1e-9.
TEST_P(ElasticCatenary, IsKnownToAMillionthFromTwoHundredBars) {
  const Values3 want = exact(GetParam()), half = solve_in_bars(GetParam(), 100),
                full = solve_in_bars(GetParam(), 200);
  const char* names[] = {"sag", "H", "T at end"};
  for (std::size_t k = 0; k < 3; ++k) {
    const double extrapolated = full[k] + (full[k] - half[k]) / 3;
    std::printf("%-8s  200 bars %.2e, extrapolated from 100 and 200 bars %.2e\n", names[k],
                relative(full[k], want[k]), relative(extrapolated, want[k]));
    EXPECT_LT(relative(full[k], want[k]), 1.4e-5);
    EXPECT_LT(relative(extrapolated, want[k]), 1e-8);
  }
}

// The same catenary with `rope.sag = 1`: the deformation within a bar is included, and the error is of fourth
// order. This requires bars whose weight is small compared with their tension; with few long bars there are
// other equilibria, too.
TEST_P(ElasticCatenary, IsApproachedWithTheFourthPowerOfTheBarLengthIfBarsSag) {
  const Values3 want = exact(GetParam());
  Values3 before{};
  for (int bars = 50; bars <= 200; bars *= 2) {
    const Values3 got = solve_in_bars(GetParam(), bars, true);
    std::printf("%4d", bars);
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = relative(got[k], want[k]), order = std::log2(before[k] / error);
      std::printf("   %.3e  %6.3f", error, bars == 50 ? 0.0 : order);
      if (bars == 100) {  // with 200 bars, the error is that of the solver
        EXPECT_NEAR(order, 4, 0.5) << "value " << k << " at " << bars << " bars";
      }
      before[k] = error;
    }
    std::printf("\n");
  }
}

TEST_P(ElasticCatenary, IsMetToAMillionthByTwoHundredBarsThatSag) {
  const Values3 want = exact(GetParam()), got = solve_in_bars(GetParam(), 200, true);
  for (std::size_t k = 0; k < 3; ++k) {
    std::printf("%.2e  ", relative(got[k], want[k]));
    EXPECT_LT(relative(got[k], want[k]), 1e-7);
  }
  std::printf("\n");
}

INSTANTIATE_TEST_SUITE_P(AllRopes, ElasticCatenary, testing::ValuesIn(kCases),
                         [](const auto& c) { return c.param.name; });

// Statics of pin-jointed bars; code_aster, validation SSNL105.
TEST(BracedSquare, LeavesOneDiagonalSlack) {
  const SolvedFile s = solve_file("verification/braced-square.toml");
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_EQ(s.solved.solution.stability, Stability::stable);
  const auto tension = s.solved.output("tension");
  const auto of = [&](const std::string& part) {
    for (std::size_t p = 0; p < s.loaded.parts.size(); ++p)
      if (s.loaded.parts[p].name == part) return tension.at(p);  // one bar each
    throw std::invalid_argument(part);
  };
  for (const auto& part : s.loaded.parts) std::printf("%-14s %16.9f N\n", part.name.c_str(), of(part.name));
  // The square deforms by 1e-6 of its side, and its forces may differ by the same fraction from the forces of
  // the undeformed square.
  EXPECT_NEAR(of("falling-cable"), 1000 * std::sqrt(2), 1e-5 * 1414);
  EXPECT_NEAR(of("lower"), -1000, 1e-5 * 1000);
  EXPECT_EQ(of("rising-cable"), 0);
  EXPECT_EQ(of("wall"), 0);
  EXPECT_NEAR(of("upper"), 0, 1e-6);
  EXPECT_NEAR(of("outer"), 0, 1e-6);
}

}  // namespace
}  // namespace netloft::test
