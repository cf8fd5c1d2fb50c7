// SPDX-License-Identifier: BSD-3-Clause
//
// A converged solution has the reactions that the load requires, however stiff the gear is and however far it
// is from the origin: forces come from differences of positions, and if their rounding errors exceed the
// load, no residual proves convergence. Stiffness and distance vary over ten decades, with each solver and
// the default strategy.
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>

namespace netloft::test {
namespace {

using Force = std::array<double, 3>;

/// A gear, and the forces of its supports in equilibrium.
struct Known {
  Scene scene;
  std::vector<std::pair<std::uint32_t, Force>> reactions;  // of a held node, or of all held nodes together
  bool all_together = false;
};

constexpr double kLoad = 100;  // [N]

void add_load(Sketch& s, std::uint32_t node, const Force& f) {
  s.part("load", "test/load", {{"x", f[0]}, {"y", f[1]}, {"z", f[2]}}, {node});
}

/// One bar of 1 m, pulled down at its end.
Known hanging_bar(double EA) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0.2, 0.1, -0.9);
  s.rope("bar", {top, end}, 1, EA);
  add_load(s, end, {0, 0, -kLoad});
  return {s.scene, {{top, {0, 0, kLoad}}}};
}

/// Six bars of 1 m, pulled aside and down at the end.
Known pulled_rope(double EA) {
  Sketch s;
  s.scene.water.gravity = 0;
  std::vector<std::uint32_t> chain{s.node(0, 0, 0, kAllAxes)};
  for (int i = 1; i <= 6; ++i) chain.push_back(s.node(0.3 * i, 0.1 * (i % 2), -0.9 * i));
  s.rope("rope", chain, 1, EA);
  add_load(s, chain.back(), {0.6 * kLoad, 0, -0.8 * kLoad});
  return {s.scene, {{chain[0], {-0.6 * kLoad, 0, 0.8 * kLoad}}}};
}

/// Depth of the joint of two bars of 4 m and stiffness EA between supports 6 m apart under the load: found by
/// bisection, as the root of an increasing function.
double depth_of_truss(double EA) {
  double lo = 0, hi = 1e6;
  for (int i = 0; i < 200; ++i) {
    const double h = 0.5 * (lo + hi), l = std::hypot(3.0, h);
    (2 * EA * (l / 4 - 1) * h / l > kLoad ? hi : lo) = h;
  }
  return 0.5 * (lo + hi);
}

/// Two bars with the load at their joint: the lateral forces of the supports depend on its depth.
Known truss(double EA) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto left = s.node(-3, 0, 0, kAllAxes), right = s.node(3, 0, 0, kAllAxes),
             joint = s.node(0.3, 0.2, -2.5);
  s.rope("left", {left, joint}, 4, EA);
  s.rope("right", {right, joint}, 4, EA);
  add_load(s, joint, {0, 0, -kLoad});
  const double aside = 0.5 * kLoad * 3 / depth_of_truss(EA);
  return {s.scene, {{left, {-aside, 0, 0.5 * kLoad}}, {right, {aside, 0, 0.5 * kLoad}}}};
}

constexpr double kBar = 0.5, kTwine = 0.01, kDensity = 2000;

/// 2 x 2 squares of netting, held along the top, under their own weight.
Known hanging_netting(double EA) {
  Sketch s;
  std::array<std::array<std::uint32_t, 3>, 3> n{};
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      n[j][i] = s.node(2.0 * static_cast<double>(i), 0.05 * static_cast<double>(j * i),
                       -2.5 * static_cast<double>(j), j == 0 ? kAllAxes : 0);
  std::vector<std::uint32_t> corners;
  std::vector<double> u, v;
  const auto add = [&](std::size_t j, std::size_t i) {
    corners.push_back(n[j][i]);
    u.push_back(4.0 * static_cast<double>(i + j)),
        v.push_back(4.0 * static_cast<double>(j) - 4.0 * static_cast<double>(i));
  };
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2; ++i)
      add(j, i), add(j + 1, i), add(j, i + 1), add(j + 1, i), add(j + 1, i + 1), add(j, i + 1);
  Part& net = s.part("net", "priour/triangle",
                     {{"twine.EA", EA},
                      {"twine.EA_compression", 1e-4 * EA},
                      {"twine.diameter", kTwine},
                      {"twine.density", kDensity}},
                     corners);
  net.data["u"] = u, net.data["v"] = v, net.data["bar_length"].assign(8, kBar);
  // |d| = 4·4 + 4·4 bars in every triangle, in both directions together
  const double weight = 8 * 32 * kBar * std::numbers::pi / 4 * kTwine * kTwine * (kDensity - 1025) * 9.81;
  return {s.scene, {{0, {0, 0, weight}}}, true};
}

struct Gear {
  const char* name;
  Known (*make)(double EA);
  int weakest;  // power of ten of the least stiffness [N]
};
constexpr Gear kGears[] = {{"hanging bar", hanging_bar, 1},
                           {"pulled rope", pulled_rope, 1},
                           {"truss", truss, 1},
                           {"netting", hanging_netting, -1}};

void move_away(Scene& scene, double distance) {
  for (std::size_t i = 0; i < scene.positions.size(); i += 3) {
    scene.positions[i] += 0.6 * distance, scene.positions[i + 1] += 0.48 * distance;
    scene.positions[i + 2] -= 0.64 * distance;
  }
}

double length(const Force& f) { return std::hypot(f[0], f[1], f[2]); }

/// Largest error of a reaction over the reaction.
double error_of(const Known& known, const Solved& solved) {
  double worst = 0;
  for (const auto& [node, expected] : known.reactions) {
    const Force found = known.all_together ? solved.total_reaction() : solved.reaction(node);
    const Force off{found[0] - expected[0], found[1] - expected[1], found[2] - expected[2]};
    worst = std::max(worst, length(off) / length(expected));
  }
  return worst;
}

struct Tally {
  int asked = 0, converged = 0;
  double worst = 0;  // error of what has converged
  std::string where = "";

  void add(const Solved& solved, double error, const std::string& place) {
    ++asked;
    if (solved.solution.status != SolveStatus::converged) return;
    ++converged;
    if (!(error <= worst)) worst = error, where = place;
  }
};

struct Method {
  const char* name;
  Solving how;
};

void PrintTo(const Method& m, std::ostream* out) { *out << m.name; }

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const char* solver : {"newton", "ptc", "relaxation", "lbfgs", "chord"})
    all.push_back({solver, {}}), all.back().how.solver = solver;
  all.push_back({"classic", {}}), all.back().how.solver_parameters = {{"method", std::string("classic")}};
  all.push_back({"auto", {}}), all.back().how.strategy = "auto";
  for (auto& m : all) m.how.limits.iterations = m.how.solver == "relaxation" ? 100 : 200, m.how.work = 1000;
  return all;
}

class RoundOff : public testing::TestWithParam<Method> {};

TEST_P(RoundOff, IsNeverTakenForBalance) {
  plugins();
  for (const Gear& gear : kGears) {
    Tally tally;
    for (int stiff = gear.weakest; stiff <= gear.weakest + 10; stiff += 2)
      for (int far = 0; far <= 10; far += 2) {
        Known known = gear.make(std::pow(10.0, stiff));
        move_away(known.scene, far == 0 ? 0 : std::pow(10.0, far));
        const Solved solved = solve(known.scene, GetParam().how);
        tally.add(solved, error_of(known, solved),
                  "EA = 1e" + std::to_string(stiff) + " N, 1e" + std::to_string(far) + " m from the origin");
      }
    std::cout << std::left << std::setw(12) << GetParam().name << std::setw(14) << gear.name
              << tally.converged << " of " << tally.asked << ", worst " << tally.worst << " " << tally.where
              << '\n';
    EXPECT_LE(tally.worst, 1e-3) << gear.name << ": " << tally.where;
    EXPECT_GE(tally.converged, 1) << gear.name << ": nothing converges, and nothing is shown";
  }
}

INSTANTIATE_TEST_SUITE_P(By, RoundOff, testing::ValuesIn(methods()),
                         [](const auto& m) { return std::string(m.param.name); });

}  // namespace
}  // namespace netloft::test
