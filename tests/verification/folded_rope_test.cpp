// SPDX-License-Identifier: BSD-3-Clause
//
// Ropes of straight bars, compared with the exact equilibrium of the bars in extended precision.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

using Real = long double;

/// The exact equilibrium of n bars between two points at one height, `span` [m] apart: with the horizontal
/// tension H and the lift V of the first point, bar k carries
///   T_k = (H, V − w l₀ (k + ½)),  x_(k+1) = x_k + l₀ (1 + |T_k|/EA) (H, −V_k)/|T_k|                     (1)
/// half the weight of a bar at each of its ends. V is half of all weight; H is found by bisection.
struct HungBars {
  int n;
  Real length, span, w, EA;
  std::vector<std::array<Real, 2>> x;
  std::vector<Real> T;

  Real reach(Real H) {
    const Real l0 = length / n, V = w * length / 2;
    x.assign(1, {0, 0}), T.clear();
    for (int k = 0; k < n; ++k) {
      const Real down = V - w * l0 * (k + Real{0.5}), t = std::hypot(H, down), l = l0 * (1 + t / EA);
      x.push_back({x.back()[0] + l * H / t, x.back()[1] - l * down / t}), T.push_back(t);
    }
    return x.back()[0];
  }
  void hang() {
    Real low = 1e-9L * w * length / n, high = 1e3L * w * length;
    for (int i = 0; i < 200; ++i) {
      const Real middle = std::sqrt(low * high);
      (reach(middle) < span ? low : high) = middle;
    }
    reach(high);
  }
};

/// Largest errors of a node [m] and of a tension [N], and the reported error of the result `tension` if the
/// scene has it.
struct Off {
  double furthest = 0, tension = 0, reported = std::numeric_limits<double>::quiet_NaN();
};

Off off(const std::vector<std::string>& overrides, HungBars bars) {
  runs::CaseSource source{test::source_folder() + "/tests/stability/scenes/rope.toml", overrides, 1};
  source.changes.push_back(formats::make_change({"parts", "rope", "cells"}, {{}, std::int64_t{bars.n}}));
  source.changes.insert(source.changes.begin(), formats::read_change("analysis.strategy=auto"));
  runs::PreparedScene rope(source, shipped_plugins());
  EXPECT_EQ(rope.prepare(), runs::PreparedScene::State::ready);
  const Solution s = runs::find_equilibrium(rope);
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  const std::vector<double> x = rope.assembler().node_positions(s.x);
  bars.hang();
  Off off;
  for (std::size_t k = 0; k < bars.x.size(); ++k)
    off.furthest =
        std::max(off.furthest, std::hypot(x[3 * k] - static_cast<double>(bars.x[k][0]), x[3 * k + 1],
                                          x[3 * k + 2] - static_cast<double>(bars.x[k][1])));
  const results::Result result = results::make_result(rope.loaded(), rope.assembler(), s);
  const auto outputs =
      results::ask_elements(rope.loaded().scene, rope.assembler(), s.x, results::at_rest(s)).outputs;
  for (std::size_t k = 0; k < bars.T.size(); ++k)
    off.tension = std::max(off.tension, std::abs(outputs[0][0][k] - static_cast<double>(bars.T[k])));
  if (const auto* tension = results::find_scalar(result.scalars, "tension"))
    off.reported = tension->solver_error;
  std::printf("%d bars: furthest %.1e m, tension off by %.1e N, reported %.1e N\n", bars.n, off.furthest,
              off.tension, off.reported);
  return off;
}

double furthest(const std::vector<std::string>& overrides, const HungBars& bars) {
  return off(overrides, bars).furthest;
}

constexpr Real kRopeWeight = (3000.0L - 1025.0L) * 9.81L * std::numbers::pi_v<Real> * 0.01L * 0.01L;  // [N/m]

// An odd number of bars would leave a middle bar that is longer than the distance between the ends.
const std::vector<std::string> kFolded = {"parts.rope.sketch=[[0,0,0],[0.001,0,0]]"};

HungBars folded(int bars) { return {bars, 100, 0.001L, kRopeWeight, 1e6L, {}, {}}; }

// With 4000 bars a residual at the round-off of the positions, 1e-6 N, would allow the fold to slide by 3e-7
// m.
TEST(FoldedRope, HangsWhereItsTensionIsNearlyNothing) {
  for (const int n : {66, 266, 4000}) EXPECT_LT(furthest(kFolded, folded(n)), 1e-10);
}

// From the straight sketch, near the solution, differences in energy are below round-off; slopes are not.
TEST(FoldedRope, HangsToTheLastDigitsByNewtonAlone) {
  std::vector<std::string> alone = kFolded;
  alone.insert(alone.end(), {"analysis.solver=newton"});
  EXPECT_LT(furthest(alone, folded(4000)), 1e-10);
}

// Rounding of positions changes forces by 0.06 N for EA = 1e10 N, and by 6 N for 1e12 N; no solver can reduce
// the residual below this without the low-order part of the positions.
TEST(FoldedRope, StiffItIsNoFurtherOff) {
  for (const Real EA : {1e10L, 1e12L})
    for (const int n : {67, 4000})
      EXPECT_LT(furthest({"parts.rope.rope.EA=" + std::to_string(static_cast<double>(EA))},
                         {n, 100, 80, kRopeWeight, EA, {}, {}}),
                1e-11);
}

// Tensions of the longer bars computed from rounded positions would have errors of a newton.
TEST(FoldedRope, StiffItTellsItsTensionsAsWell) {
  const Off stiff = off({"parts.rope.rope.EA=1e12", "results.tension={of=\"rope\",take=\"max tension\"}"},
                        {4000, 100, 80, kRopeWeight, 1e12L, {}, {}});
  EXPECT_LT(stiff.tension, 1e-3);
  EXPECT_LT(stiff.reported, 1e-3);
}

TEST(FoldedRope, UnfoldedItDoesTheSame) {
  for (const int n : {67, 4000}) EXPECT_LT(furthest({}, {n, 100, 80, kRopeWeight, 1e6L, {}, {}}), 1e-10);
}

}  // namespace
}  // namespace netloft::test
