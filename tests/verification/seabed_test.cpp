// SPDX-License-Identifier: BSD-3-Clause
//
// Wires that lie partly on the seabed, and ropes drawn over it, compared with closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

double pull_at(const SolvedFile& s, const std::string& part, const std::string& set) {
  const auto r = s.solved.reaction(s.node(part, set));
  return std::hypot(r[0], r[1], r[2]);
}

// 28 mm wire of 3 kg/m in air, EA 30 MN; elastic catenary after Irvine, Cable Structures, MIT Press 1981.
const double kMooringWeight = (3 - 1025 * std::acos(-1.0) / 4 * 0.028 * 0.028) * 9.80665;  // [N/m] in water
constexpr double kEA = 3e7;

/// The root of an increasing function.
template <class F>
double root(double low, double high, F&& f) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return low;
}

/// The tension at the top of 480 m of this wire, 400 m away from its end and 190 m above a rigid bed. s
/// metres hang; H is the tension on the bed.
///   190 = w s²/(2 EA) + (H/w)(√(1 + (w s/H)²) − 1)                       (1)
///   400 = H s/EA + (H/w) asinh(w s/H) + (480 − s)(1 + H/EA)              (2)
double top_tension_on_rigid_bed() {
  const double w = kMooringWeight;
  const auto hanging = [&](double H) {
    return root(0, 480, [&](double s) {
      return w * s * s / (2 * kEA) + H / w * (std::hypot(1, w * s / H) - 1) - 190;  // (1)
    });
  };
  const double H = root(100, 1e5, [&](double h) {
    const double s = hanging(h);
    return h * s / kEA + h / w * std::asinh(w * s / h) + (480 - s) * (1 + h / kEA) - 400;  // (2)
  });
  return std::hypot(H, w * hanging(H));
}

TEST(CatenaryOnSeabed, HasAClosedFormThatGivesThePublishedDigits) {
  EXPECT_NEAR(top_tension_on_rigid_bed(), 8655.4, 0.05);
}

TEST(CatenaryOnSeabed, PullsAsOnARigidBed) {
  const SolvedFile s = solve_file("verification/catenary-on-seabed.toml");
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_EQ(s.solved.solution.stability, Stability::stable);
  EXPECT_LT(relative(pull_at(s, "wire", "start"), 8655.4), 3e-5);
}

// A soft bed is indented by √(2 ε w/k) or ε/2 + w/k: the error decreases with growing stiffness until only
// the error of straight bars remains, here 3e-6.
TEST(CatenaryOnSeabed, ApproachesTheRigidBedAsItsStiffnessGrows) {
  const double exact = top_tension_on_rigid_bed();
  double before = 1;
  for (const double k : {1e3, 1e4, 1e5, 1e6}) {
    const SolvedFile s = solve_file("verification/catenary-on-seabed.toml",
                                    {"parts.wire.cells=960", "parts.bed.seabed.softness=1e-4",
                                     "parts.bed.seabed.stiffness=" + std::to_string(k)});
    ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
    const double error = relative(pull_at(s, "wire", "start"), exact);
    std::printf("stiffness %.0e N/m2: %3d iterations, top tension %.3f N, error %.2e\n", k,
                s.solved.solution.cost.statistics.iterations, pull_at(s, "wire", "start"), error);
    EXPECT_LT(error, before);
    before = k < 1e5 ? error / 4 : 3e-6;
  }
}

/// F = √(2 EA μ w (D − d/2)), d = μ w/κ: first integral of EA u'' = friction.
TEST(RopeOverSeabed, IsHeldByTheFrictionOfWhatSlidesAndNoMore) {
  const double EA = 1e5, friction = 0.5 * 10, shear = 1e5, D = 0.04;
  const double exact = std::sqrt(2 * EA * friction * (D - 0.5 * friction / shear));
  for (const int bars : {80, 160, 320}) {
    const SolvedFile s = solve_file("verification/rope-dragged-over-seabed.toml",
                                    {"parts.rope.cells=" + std::to_string(bars)});
    ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
    // The dragged end was sketched at its held position, so that half of its bar is not dragged.
    const double pull = -s.solved.reaction(s.node("rope", "start"))[0] + friction * 0.5 * 80 / bars;
    std::printf("%3d bars: %2d iterations, pull %.4f N, error %.2e\n", bars,
                s.solved.solution.cost.statistics.iterations, pull, relative(pull, exact));
    EXPECT_LT(relative(pull, exact), 1e-4);
    const auto end = s.solved.position(s.node("rope", "end"));
    EXPECT_NEAR(end[0], 80, 1e-12) << "40 m away it sticks to where it was laid";
  }
}

// A chain towed over a bed that rises by s aft, V = 1.5 m/s, 50 m of 10 N/m in water:
//   N = w cos θ + ρ/2 C_n d V² sin θ |sin θ|,  T = L (ρ/2 C_t d V² cos² θ + μ N − w sin θ)
struct TowedChain {
  double slope, friction;
  double cos() const { return 1 / std::hypot(1, slope); }
  double sin() const { return slope * cos(); }
  double exact() const {
    const double q = 0.5 * 1025 * 0.03 * 1.5 * 1.5;
    const double N = 10 * cos() + q * 1.2 * sin() * std::abs(sin());
    return 50 * (q * 0.08 * cos() * cos() + friction * N - 10 * sin());
  }
  SolvedFile solve() const {
    const std::string end =
        "[" + std::to_string(50 * cos()) + ", 0, " + std::to_string(50 * sin() - 50.0002) + "]";
    return solve_file("verification/towed-chain.toml",
                      {"parts.bed.seabed.friction=" + std::to_string(friction),
                       "parts.bed.seabed.slope_x=" + std::to_string(slope),
                       "parts.chain.sketch=[[0, 0, -50.0002], " + end + "]"});
  }
};

TEST(TowedChain, IsPulledByItsDragAndTheFrictionOfAllThatSlides) {
  for (const double slope : {-0.1, 0.0, 0.1})
    for (const double friction : {0.0, 0.25, 0.5, 1.0}) {
      const TowedChain chain{slope, friction};
      if (chain.exact() < 0) continue;  // it would slide down by itself
      const SolvedFile s = chain.solve();
      ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
      const auto r = s.solved.reaction(s.node("chain", "start"));
      const double pull = -(r[0] * chain.cos() + r[2] * chain.sin());
      std::printf("slope %4.1f, friction %.2f: %2d iterations, pull %.3f N, exact %.3f N\n", slope, friction,
                  s.solved.solution.cost.statistics.iterations, pull, chain.exact());
      EXPECT_LT(relative(pull, chain.exact()), 5e-3);
      EXPECT_LE(s.solved.solution.cost.statistics.iterations, 15);
    }
}

TEST(TowedChain, DoesNotDependOnWhereItWasSketched) {
  const SolvedFile straight = TowedChain{0, 0.5}.solve();
  const SolvedFile askew = solve_file("verification/towed-chain.toml",
                                      {"parts.chain.sketch=[[0, 0, -50.0002], [30, 35, -50.0002]]"});
  ASSERT_EQ(askew.solved.solution.status, SolveStatus::converged) << askew.solved.solution.reason;
  const auto end = askew.solved.position(askew.node("chain", "end"));
  const auto expected = straight.solved.position(straight.node("chain", "end"));
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(end[axis], expected[axis], 1e-6);
}

// A model of the towed chain in a tank, at 1 : 8 in the same water and towed √8 times slower, computed at its
// own scale and by water.model_scale at full scale: forces differ by 8³ (Froude), Reynolds numbers are the
// same.
TEST(TowedChain, IsPulledInATankAsItsModelIs) {
  const double s = 8, force = s * s * s;
  const std::vector<std::string> by_reynolds{"parts.chain.drag={law=\"hydro/morison-reynolds\"}",
                                             "parts.bed.seabed.slope_x=0.05",
                                             "parts.chain.sketch=[[0,0,-50.0002],[49.9,0,-47.5]]"};
  std::vector<std::string> in_tank = by_reynolds, model = by_reynolds;
  in_tank.push_back("water.model_scale=8");
  model.back() = "parts.chain.sketch=[[0,0,-6.250025],[6.2375,0,-5.9375]]";
  for (const auto& [key, value] :
       std::initializer_list<std::pair<const char*, double>>{{"tow.speed", 1.5 / std::sqrt(s)},
                                                             {"parts.chain.length", 50 / s},
                                                             {"parts.chain.rope.diameter", 0.03 / s},
                                                             {"parts.chain.rope.EA", 1e7 / force},
                                                             {"parts.bed.seabed.depth", 50 / s},
                                                             {"parts.bed.seabed.softness", 2e-4 / s},
                                                             {"parts.bed.seabed.stiffness", 1e5 / s}}) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    model.push_back(std::string(key) + "=" + text);
  }
  const auto pull = [](const std::vector<std::string>& overrides) {
    const SolvedFile f = solve_file("verification/towed-chain.toml", overrides);
    EXPECT_EQ(f.solved.solution.status, SolveStatus::converged) << f.solved.solution.reason;
    return pull_at(f, "chain", "start");
  };
  EXPECT_LT(relative(force * pull(model), pull(in_tank)), 1e-8);
  EXPECT_GT(relative(pull(by_reynolds), pull(in_tank)), 1e-3) << "the Reynolds number counts";
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// During the solution the anchors of friction are at the sketch, afterwards at the positions to which the
// rope has slid. The forces in equilibrium are unchanged, but forces at the sketch are no longer zero.
TEST(RopeOverSeabed, SticksToWhereItWasFoundInEquilibrium) {
  const Solved s = solve(solve_file("verification/rope-dragged-over-seabed.toml").loaded.scene,
                         {.limits = {.tolerance = 1e-10}, .strategy = "direct"});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  Assembler& after = *s.assembler;
  Assembler before(s.scene, s.plan, 1);
  std::vector<double> r(s.solution.residual.size());
  ASSERT_TRUE(after.evaluate(s.solution.x, {.residual = r.data()}));
  EXPECT_LT(largest_difference(r, s.solution.residual), 1e-9);
  std::vector<double> fresh(r.size());
  ASSERT_TRUE(after.evaluate(after.start(), {.residual = r.data()}));
  ASSERT_TRUE(before.evaluate(after.start(), {.residual = fresh.data()}));
  EXPECT_NEAR(largest_difference(r, fresh), 0.5 * 10 * 0.25, 1e-9) << "0.25 m of rope slide back at most";
}

}  // namespace
}  // namespace netloft::test
