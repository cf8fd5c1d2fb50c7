// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/mean_tension.hpp"

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

void of_steps(ScenePlan& plan) { use_mean_forces(plan, "test"); }

/// Springs that implement only their energy, and ropes that are slack or taut.
Scene springs() {
  test::Sketch s;
  std::vector<std::uint32_t> chain;
  for (int i = 0; i < 5; ++i) chain.push_back(s.node(i, 0.1 * i * i, -0.3 * i, i == 0 ? kAllAxes : 0));
  s.rope("rope", chain, 1.1);
  s.part("springs", "test/spring", {{"k", 50.0}}, {chain[0], chain[2], chain[2], chain[4]})
      .data["rest_length"] = {1.5, 1.8};
  return s.scene;
}

/// A step between two states that are far apart, in which twines become slack and taut.
struct Step {
  Step(Scene scene, double size)
      : all(std::move(scene), 1, of_steps),
        before(all.moved(size, 1)),
        after(all.moved(size, 2)),
        middle(before) {
    for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = 0.5 * (before[i] + after[i]);
  }
  std::vector<double> mean_force() {
    const StepEnds ends{before.data(), after.data(), 1, 0};
    std::vector<double> r(middle.size());
    EXPECT_TRUE(all.assembler.evaluate(middle, {.residual = r.data(), .between = &ends}));
    return r;
  }
  test::Assembled all;
  std::vector<double> before, after, middle;
};

double dot(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * (b[i] - c[i]);
  return sum;
}

TEST(MeanForces, DoTheWorkByWhichTheEnergyChanges) {
  for (const Scene& scene : {sample::hanging_panel(4, 34), sample::hanging_rope(6), springs()}) {
    Step step(scene, 0.4);
    const double gain = step.all.energy(step.after) - step.all.energy(step.before);
    const double scale = std::abs(step.all.energy(step.after)) + std::abs(step.all.energy(step.before));
    EXPECT_NEAR(dot(step.mean_force(), step.after, step.before), gain, 1e-12 * scale);
    EXPECT_GT(std::abs(dot(step.all.residual(step.middle), step.after, step.before) - gain), 1e-6 * scale);
  }
}

TEST(MeanForces, NeitherPushNorTurnAsAWhole) {
  for (Scene scene : {sample::hanging_panel(4, 34), springs()}) {
    scene.water.gravity = 0;
    Step step(std::move(scene), 0.4);
    const auto f = step.mean_force();
    const Assembler& a = step.all.assembler;
    double push[3] = {}, turn[3] = {}, most = 0;
    for (std::uint32_t node = 0; node < step.all.scene.node_count(); ++node) {
      const auto x = a.node_position(node, step.middle), r = a.node_position(node, f);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        push[i] += r[i], turn[i] += x[j] * r[k] - x[k] * r[j];
        most = std::max({most, std::abs(r[i]), std::abs(x[j] * r[k])});
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(push[i], 0, 1e-11 * most);
      EXPECT_NEAR(turn[i], 0, 1e-11 * most);
    }
  }
}

TEST(MeanForces, HaveTheSlopeOfTheirChangeWithTheMiddle) {
  Step step(sample::hanging_rope(6), 0.05);
  const auto at = [&](std::vector<double> u_step) {
    Step other = Step(sample::hanging_rope(6), 0.05);
    for (std::size_t i = 0; i < u_step.size(); ++i)
      other.middle[i] += u_step[i], other.after[i] = 2 * other.middle[i] - other.before[i];
    return other.mean_force();
  };
  Assembler& a = step.all.assembler;
  const auto n = static_cast<std::size_t>(a.pattern().size);
  std::vector<double> values(a.value_slots()), r(step.middle.size());
  const StepEnds ends{step.before.data(), step.after.data(), 1, 0};
  ASSERT_TRUE(a.evaluate(
      step.middle,
      {.residual = r.data(), .matrix = MatrixKind::exact, .values = values.data(), .between = &ends}));
  const SparsePattern& p = a.pattern();
  ASSERT_FALSE(p.symmetric);
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  for (std::size_t c = 0; c < n; ++c) {
    constexpr double h = 1e-6;
    std::vector<double> there(n), back(n);
    there[c] = h, back[c] = -h;
    const auto f = at(there), b = at(back);
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto row = static_cast<std::size_t>(p.row[k]);
      EXPECT_NEAR(values[p.slot_of(k)], (f[row] - b[row]) / (2 * h), 1e-6 * most) << row << " " << c;
    }
  }
}

/// Computed by hand for EA = 100 N and l0 = 2 m: the length changes from 1.9 m (slack, EA_compression = 1 N)
/// to 2.2 m, so that the mean tension is (½ 50 0.2² − ½ 0.5 0.1²)/0.3 N.
TEST(MeanTension, IsTheEnergyOverTheWay) {
  const netloft_member m{{-1, 1, 0}, 2, 100, 1, 1};
  EXPECT_NEAR(mean_tension(m, 1.9, 2.2).T, (0.5 * 50 * 0.04 - 0.5 * 0.5 * 0.01) / 0.3, 1e-12);
  EXPECT_NEAR(mean_tension(m, 2.1, 2.3).T, 10, 1e-12);
  EXPECT_NEAR(mean_stiffness(m, 1.9, 2.2).k, (10 + 0.05) / 0.3, 1e-12);
  const double h = 1e-6;
  EXPECT_NEAR(mean_stiffness(m, 1.9, 2.2).slope,
              (mean_stiffness(m, 1.9, 2.2 + h).k - mean_stiffness(m, 1.9, 2.2 - h).k) / (2 * h), 1e-6);
  EXPECT_NEAR(mean_tension(m, 1.9, 2.2).slope,
              (mean_tension(m, 1.9, 2.2 + h).T - mean_tension(m, 1.9, 2.2 - h).T) / (2 * h), 1e-6);
}

}  // namespace
}  // namespace netloft
