// SPDX-License-Identifier: BSD-3-Clause
//
// Several models of one small trawl must agree: half and whole, over the seabed and on it, from the drawing
// and from another start.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "framework/assembler/reports.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

SolvedFile solve_trawl(const std::string& model) {
  SolvedFile s = solve_file("validation/small-trawl/" + model + ".toml");
  const Statistics& b = s.solved.solution.cost.statistics;
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  std::printf("%s: %zu unknowns, %d iterations, %d factorisations, %.3f s\n", model.c_str(),
              s.solved.plan.unknowns, b.iterations, b.factorisations, b.total_cpu_seconds);
  return s;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The four sections of upper and lower netting, and headline and footrope.
const std::vector<std::string> kPanels = {"upper1", "upper2", "upper3", "upper4",
                                          "lower1", "lower2", "lower3", "lower4"};
const std::vector<std::string> kRopes = {"headline", "footrope"};
constexpr std::uint32_t kHalf = 4;  // cells across the half trawl

/// Largest distance between a node of the half and the same node of the whole. Both number nodes along rows
/// from the port side; of each row, the half has only the part from the middle on.
double distance_of_half(const SolvedFile& half, const SolvedFile& whole, const std::string& part) {
  double worst = 0;
  const auto& nodes = half.part(part).nodes;
  for (std::uint32_t id = 0; id < nodes.size(); ++id) {
    const std::uint32_t row = id / (kHalf + 1), across = id % (kHalf + 1);
    const std::uint32_t like = whole.part(part).nodes.at(row * (2 * kHalf + 1) + kHalf + across);
    worst = std::max(worst, distance(half.solved.position(nodes[id]), whole.solved.position(like)));
  }
  return worst;
}

// The mesh of the whole is symmetric, so that the results may differ only by the tolerance of the solver.
TEST(SmallTrawl, IsTheSameAsAHalfBesideAMirror) {
  const SolvedFile half = solve_trawl("half"), whole = solve_trawl("whole");
  for (const auto& parts : {kPanels, kRopes})
    for (const auto& part : parts) EXPECT_LT(distance_of_half(half, whole, part), 1e-5) << part;
  for (const char* bridle : {"starboard-upper-bridle", "starboard-lower-bridle"}) {
    const auto one = half.solved.reaction(half.node(bridle, "start"));
    const auto other = whole.solved.reaction(whole.node(bridle, "start"));
    EXPECT_LT(distance(one, other), 1e-5) << bridle;
  }
}

// Every free coordinate is perturbed by 10 cm.
TEST(SmallTrawl, StandsTheSameFromAnotherStart) {
  const SolvedFile half = solve_trawl("half");
  std::mt19937_64 random(1);
  Scene scene = half.loaded.scene;
  for (std::size_t i = 0; i < scene.positions.size(); ++i)
    if (!(scene.held[i / 3] >> (i % 3) & 1))
      scene.positions[i] += 0.1 * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
  Solving how;
  how.limits = half.loaded.analysis.limits;
  const Solved again = solve(scene, how);
  ASSERT_EQ(again.solution.status, SolveStatus::converged) << again.solution.reason;
  double worst = 0;
  for (std::uint32_t n = 0; n < scene.node_count(); ++n)
    worst = std::max(worst, distance(half.solved.position(n), again.position(n)));
  EXPECT_LT(worst, 1e-5);
}

/// The load on the bed, computed from the depth of the footrope in the bed: 1e5 N/m2 per metre of rope, soft
/// over 1 mm.
double carried_by_depth(const SolvedFile& s) {
  constexpr double kStiffness = 1e5, kSoftness = 1e-3, kDepth = 31, kLength = 2.8;
  const auto& rope = s.part("footrope").nodes;
  double carried = 0;
  for (std::size_t i = 0; i < rope.size(); ++i) {
    const double ends = i == 0 || i + 1 == rope.size() ? 0.5 : 1;
    const double metres = ends * kLength / static_cast<double>(rope.size() - 1);
    const double depth = std::max(0.0, -kDepth - s.solved.position(rope[i])[2]);
    const double pressed = depth < kSoftness ? depth * depth / (2 * kSoftness) : depth - 0.5 * kSoftness;
    carried += kStiffness * metres * pressed;
  }
  return carried;
}

/// Upward force of everything except the bed: weight, floats, water on the gear, and the holds of the
/// bridles.
double lift_without_bed(const SolvedFile& s) {
  double lift = 0;
  for (std::size_t f = 0; f < s.solved.assembler->families().size(); ++f) {
    const ElementFamily& family = *s.solved.assembler->families()[f];
    if (family.type().type == "seabed/plane") continue;
    for (std::size_t t = 0; t < family.active_terms().size(); ++t) {
      std::vector<double> sums(3 * family.parts().size());
      EXPECT_TRUE(s.solved.assembler->reports().sum_term(s.solved.solution.x, f, t, sums));
      for (std::size_t p = 0; p < family.parts().size(); ++p) lift -= sums[3 * p + 2];
    }
  }
  for (const char* bridle : {"starboard-upper-bridle", "starboard-lower-bridle"})
    lift += s.solved.reaction(s.node(bridle, "start"))[2];
  return lift;
}

TEST(SmallTrawl, LiesAsDeepInTheSeabedAsItIsHeavy) {
  const SolvedFile s = solve_trawl("on-seabed");
  const double carried = carried_by_depth(s);
  std::printf("the bed carries %.6f N, the rest lifts %.6f N\n", carried, lift_without_bed(s));
  EXPECT_GT(carried, 100);
  EXPECT_NEAR(carried, -lift_without_bed(s), 1e-6 * carried);
}

}  // namespace
}  // namespace netloft::test
