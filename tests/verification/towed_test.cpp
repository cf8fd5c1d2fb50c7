// SPDX-License-Identifier: BSD-3-Clause
//
// Ropes in a current: compared bar by bar with an independent program, with the continuous cable integrated
// from its end, and with closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/verification/reference.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

SolvedFile solve_in_bars(const std::string& name, const std::string& part, int bars) {
  SolvedFile s = solve_file("verification/" + name, {"parts." + part + ".cells=" + std::to_string(bars)});
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged)
      << bars << " bars: " << s.solved.solution.reason;
  return s;
}

// This test uses no solver: the positions of the independent program are put into the assembler. They are
// stored to 15 digits, 5e-13 m beyond 100 m, which EA/l0 = 5e4 N/m turns into 2.5e-8 N in each bar.
TEST(TowedRope, IsInBalanceWhereTheIndependentProgramHasIt) {
  const Level want = read_level("towed-cable-in-bars.txt", 10);
  const SolvedFile s = solve_in_bars("towed-rope.toml", "rope", 10);
  Assembler& assembler = *s.solved.assembler;
  std::vector<double> x = assembler.start(), residual(x.size());
  const auto at = [&](std::uint32_t node, int axis) { return assembler.numbering().dof(node, axis).at(); };
  for (const auto& node : want.nodes) {
    const std::uint32_t id = s.part("rope").nodes.at(static_cast<std::size_t>(node[0]));
    x[at(id, 0)] = node[1], x[at(id, 1)] = 0, x[at(id, 2)] = node[2];
  }
  ASSERT_TRUE(assembler.evaluate(x, {.residual = residual.data()}));
  double worst = 0;
  for (std::size_t n = 1; n < want.nodes.size(); ++n)
    for (int axis = 0; axis < 3; ++axis)
      worst = std::max(worst, std::abs(residual[at(s.part("rope").nodes.at(n), axis)]));
  std::printf("largest residual %.2e N\n", worst);
  EXPECT_LT(worst, 5e-8);
  EXPECT_LT(std::abs(residual[at(s.part("rope").nodes.at(0), 0)] - want.values[0]), 1e-7);
  EXPECT_LT(std::abs(residual[at(s.part("rope").nodes.at(0), 2)] - want.values[1]), 1e-7);
}

class TowedRopeInBars : public testing::TestWithParam<int> {};

TEST_P(TowedRopeInBars, LiesAsTheIndependentProgramSays) {
  const Level want = read_level("towed-cable-in-bars.txt", GetParam());
  const SolvedFile s = solve_in_bars("towed-rope.toml", "rope", want.n);
  double worst = 0;
  for (const auto& node : want.nodes) {
    const auto place = static_cast<std::size_t>(node[0]) * static_cast<std::size_t>(want.n) / 10;
    const auto x = s.solved.position(s.part("rope").nodes.at(place));
    worst = std::max(worst, std::hypot(x[0] - node[1], x[1], x[2] - node[2]));
  }
  const auto top = s.solved.reaction(s.node("rope", "start"));
  const double force = std::hypot(top[0] - want.values[0], top[2] - want.values[1]);
  std::printf("%4d bars: %3d iterations, node %.1e m, reaction %.1e N\n", want.n,
              s.solved.solution.cost.statistics.iterations, worst, force);
  EXPECT_LT(worst, 1e-7);
  EXPECT_LT(force, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(AllLevels, TowedRopeInBars, testing::Values(10, 20, 40, 80, 160, 320),
                         testing::PrintToStringParamName());

/// The continuous wire of towed-cable.toml, from its end upwards:
///   dN/ds = −(weight + drag(t)),  dx/ds = (1 + ‖N‖/EA) t,  t = N/‖N‖
/// N is the force of the upper part of the wire on the lower part, s the unstretched length.
struct ContinuousWire {
  static constexpr double rho = 1025, g = 9.80665, V = 1.5, EA = 3e7, D = 0.028, L = 300;
  using State = std::array<double, 4>;  // x, z, N_x, N_z

  static State rate(const State& y) {
    const double N = std::hypot(y[2], y[3]), tx = y[2] / N, tz = y[3] / N;
    const double weight = (4872.0901 - rho) * std::numbers::pi / 4 * D * D * g;
    const double along = V * tx, nx = V - along * tx, nz = -along * tz;  // flow across
    const double k = 0.5 * rho * D, C_n = 1.2, C_t = 0.01 * std::numbers::pi;
    const double a = k * C_n * std::hypot(nx, nz), b = k * C_t * std::abs(along) * along;
    const double stretched = 1 + N / EA;
    return {stretched * tx, stretched * tz, -(a * nx + b * tx), weight - (a * nz + b * tz)};
  }
  static State add(const State& y, double h, const State& d) {
    return {y[0] + h * d[0], y[1] + h * d[1], y[2] + h * d[2], y[3] + h * d[3]};
  }
  /// Integrates to the top, with the end at the origin; Runge-Kutta of 4th order.
  static State top() {
    State y = {0, 0, -0.5 * rho * V * V, (1500 - 0.2 * rho) * g};  // the sinker's drag and weight
    constexpr int steps = 30000;
    for (int i = 0; i < steps; ++i) {
      constexpr double h = L / steps;
      const State a = rate(y), b = rate(add(y, h / 2, a)), c = rate(add(y, h / 2, b)), d = rate(add(y, h, c));
      y = add(add(add(add(y, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    return y;
  }
};

/// x and z of the end relative to the top, and the tension at the top.
using Values3 = std::array<double, 3>;

Values3 continuous_wire() {
  const auto y = ContinuousWire::top();
  return {-y[0], -y[1], std::hypot(y[2], y[3])};
}

Values3 wire_in_bars(int bars) {
  const SolvedFile s = solve_in_bars("towed-cable.toml", "wire", bars);
  const auto end = s.solved.position(s.node("wire", "end")), top = s.solved.reaction(s.node("wire", "start"));
  return {end[0], end[2], std::hypot(top[0], top[1], top[2])};
}

// Published result of a shooting method: the end is at (110.074, -276.309) m, and the tension at the top is
// 19 213 N.
TEST(TowedCable, HasAContinuousFormThatGivesThePublishedDigits) {
  const Values3 wire = continuous_wire();
  EXPECT_NEAR(wire[0], 110.074, 5e-4);
  EXPECT_NEAR(wire[1], -276.309, 5e-4);
  EXPECT_NEAR(wire[2], 19213, 0.5);
}

TEST(TowedCable, IsApproachedWithTheSquareOfTheBarLength) {
  const Values3 want = continuous_wire();
  Values3 before{}, coarse{};
  std::printf("bars   x           order   z           order   top         order   (relative errors)\n");
  for (int bars = 10; bars <= 160; bars *= 2) {
    const Values3 got = wire_in_bars(bars);
    std::printf("%4d", bars);
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = relative(got[k], want[k]), order = std::log2(before[k] / error);
      std::printf("   %.3e  %6.3f", error, bars == 10 ? 0.0 : order);
      if (bars > 10) {
        EXPECT_NEAR(order, 2, 0.1) << "value " << k << " at " << bars << " bars";
      }
      if (bars == 160) {
        EXPECT_LT(error, 2e-6);
        EXPECT_LT(relative(got[k] + (got[k] - coarse[k]) / 3, want[k]), 1e-8);
      }
      before[k] = error;
    }
    coarse = got;
    std::printf("\n");
  }
}

// A catenary with the parameter T/k, k = 12.3 N/m: span/2 = c asinh(L/2c), sag = c (cosh(span/2c) - 1), c =
// T/k.
TEST(TowedLineWithoutWeight, IsACatenaryOfConstantTension) {
  constexpr double T = 415.988311, sag = 26.5437509, c = T / 12.3;
  EXPECT_NEAR(c * std::asinh(50 / c), 40, 1e-7);
  EXPECT_NEAR(c * (std::cosh(40 / c) - 1), sag, 1e-7);
  Values3 at[2];
  for (const int k : {0, 1}) {
    const SolvedFile s = solve_in_bars("towed-line.toml", "line", k ? 200 : 100);
    const auto tension = s.solved.output("tension");
    const auto middle = s.solved.position(s.node("line", "middle"));
    EXPECT_NEAR(middle[1], 0, 1e-6);
    EXPECT_NEAR(middle[2], 0, 1e-6);
    const auto [least, most] = std::minmax_element(tension.begin(), tension.end());
    std::printf("%3d bars: tension from %.6f to %.6f N, sag %.7f m\n", k ? 200 : 100, *least, *most,
                middle[0]);
    EXPECT_LT((*most - *least) / T, k ? 1e-4 : 4e-4);
    at[k] = {middle[0], *least, *most};
  }
  EXPECT_LT(relative(at[1][0], sag), 2e-5);
  EXPECT_LT(relative(at[1][1], T), 1e-4);
  EXPECT_LT(relative(at[1][0] + (at[1][0] - at[0][0]) / 3, sag), 1.5e-6);  // stretched by 4e-7: 1e-6 in sag
}

// cos(angle) = (-w + sqrt(w² + 4k²))/(2k); the tension at the top carries w sin(angle) of every metre. The
// wire stretches by at most 1.5e-5.
TEST(TowedWire, HangsStraightAtTheCriticalAngle) {
  constexpr double w = 10, k = 12.3, L = 200;
  const double angle = std::acos((-w + std::sqrt(w * w + 4 * k * k)) / (2 * k));
  EXPECT_NEAR(angle * 180 / std::numbers::pi, 47.704, 5e-4);
  const SolvedFile s = solve_in_bars("towed-wire-heavy.toml", "wire", 20);
  for (const double found : s.solved.output("angle_to_flow")) EXPECT_NEAR(found, angle, 1e-8);
  const auto end = s.solved.position(s.node("wire", "end")), top = s.solved.reaction(s.node("wire", "start"));
  EXPECT_LT(relative(std::hypot(top[0], top[2]), w * L * std::sin(angle)), 1e-7);
  EXPECT_LT(relative(std::hypot(end[0], end[2]), L), 1.5e-5);
  EXPECT_NEAR(std::atan2(-end[2], end[0]), angle, 1e-8);
}

// With w = 1 N/m, the angle is 16.224 degrees. The density gives the wire a tenth of the weight of the wire
// in the scene.
TEST(TowedWire, StreamsOutWhenItIsLight) {
  const double density = 1025 + 1 / (std::numbers::pi / 4 * 4e-4 * 9.80665);
  const SolvedFile s = solve_file(
      "verification/towed-wire-heavy.toml",
      {"parts.wire.rope.density=" + std::to_string(density), "parts.wire.sketch=[[0, 0, 0], [190, 0, -55]]"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  for (const double found : s.solved.output("angle_to_flow"))
    EXPECT_NEAR(found * 180 / std::numbers::pi, 16.224, 5e-4);
}

// Elastic catenary between ends of different depth, whose published closed form gives 6393.5 N.
TEST(FreeCatenary, HasTheTensionThatAMooringProgramMisses) {
  double before = 0;
  for (const int bars : {130, 260}) {
    const SolvedFile s = solve_in_bars("catenary-wire.toml", "wire", bars);
    const auto top = s.solved.reaction(s.node("wire", "start"));
    const double found = std::hypot(top[0], top[1], top[2]);
    std::printf("%d bars: %.4f N\n", bars, found);
    EXPECT_NEAR(found, 6393.5, 0.2);
    if (bars == 260) {
      EXPECT_NEAR(found + (found - before) / 3, 6393.5, 0.05);
    }
    before = found;
  }
}

}  // namespace
}  // namespace netloft::test
