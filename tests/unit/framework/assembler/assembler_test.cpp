// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/assembler.hpp"
#include "framework/assembler/reports.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// A net on two ropes. Every twine and bar is taut, and one node is held along one axis only.
Sketch net_with_ropes() {
  Sketch s;
  s.scene = sample::hanging_panel(3, 45);
  const auto corner = [](std::uint32_t i, std::uint32_t j) { return 4 * j + i; };
  s.scene.held[corner(1, 3)] = kAxisY;
  const auto left = s.node(-40, 5, 3, kAllAxes), half = s.node(-28, 2, 1.5),
             right = s.node(40, 5, 3, kAllAxes);
  s.scene.held[corner(0, 0)] = s.scene.held[corner(3, 0)] = 0;
  s.rope("left", {left, half, corner(0, 0)}, 10);
  s.rope("right", {corner(3, 0), right}, 20);
  return s;
}

/// Step h of central differences. The third derivatives of a bar are about its stiffness divided by its
/// length squared, so that the relative error is about (h/length)².
constexpr double kStep = 1e-4;

TEST(Assembler, HasTheGradientOfTheEnergyAsResidual) {
  Assembled a(net_with_ropes().scene);
  const auto x = a.moved(0.2);
  const auto r = a.residual(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    auto right = x, left = x;
    right[i] += kStep, left[i] -= kStep;
    EXPECT_NEAR(r[i], (a.energy(right) - a.energy(left)) / (right[i] - left[i]), 1e-7 * largest(r)) << i;
  }
}

TEST(Assembler, ScattersTheTangentOfSeveralFamiliesToItsPlaces) {
  Assembled a(net_with_ropes().scene);
  ASSERT_TRUE(a.assembler.pattern().symmetric);
  const auto x = a.moved(0.2);
  const auto K = a.matrix(x, MatrixKind::exact), reference = difference(a, x, kStep);
  EXPECT_LT(largest_difference(K, reference), 1e-7 * largest(K));
}

TEST(Assembler, LeavesOutTermsWithATrait) {
  Assembled a(net_with_ropes().scene);
  const auto x = a.moved(0.2);
  std::vector<double> loads(x.size()), weights(x.size(), 0.0), values(a.assembler.value_slots());
  double energy = 0, weight_energy = 0;
  ASSERT_TRUE(a.assembler.evaluate(x, {.energy = &energy,
                                       .without = NETLOFT_OF_MEMBERS,
                                       .residual = loads.data(),
                                       .matrix = MatrixKind::exact,
                                       .values = values.data()}));
  for (std::size_t f = 0; f < a.assembler.families().size(); ++f) {
    const auto& terms = a.assembler.families()[f]->active_terms();
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (terms[t].traits & NETLOFT_OF_MEMBERS) continue;
      std::vector<double> one(x.size());
      double of_one = 0;
      ASSERT_TRUE(a.assembler.reports().evaluate_term(x, f, t, one) &&
                  a.assembler.reports().term_energy(x, f, t, of_one));
      for (std::size_t i = 0; i < x.size(); ++i) weights[i] += one[i];
      weight_energy += of_one;
    }
  }
  EXPECT_GT(largest(weights), 0);
  EXPECT_LT(largest_difference(loads, weights), 1e-12 * largest(weights));
  EXPECT_NEAR(energy, weight_energy, 1e-12 * std::abs(weight_energy));
  EXPECT_EQ(largest(values), 0) << "weight has no tangent";
}

TEST(Assembler, ScattersAnUnsymmetricTangentToItsPlaces) {
  Sketch s = net_with_ropes();
  s.part("push", "test/follower", {{"k", 40.0}}, {5, 6, 10, 6, 8, 4}).data["rest_length"] = {1, 1, 1};
  Assembled a(s.scene);
  ASSERT_FALSE(a.assembler.pattern().symmetric);
  EXPECT_FALSE(a.plan.conservative);
  const auto x = a.moved(0.2);
  const auto K = a.matrix(x, MatrixKind::exact), reference = difference(a, x, kStep);
  EXPECT_LT(largest_difference(K, reference), 1e-7 * largest(K));
  const auto n = static_cast<std::size_t>(a.assembler.pattern().size);
  double unsymmetric = 0;
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < r; ++c)
      unsymmetric = std::max(unsymmetric, std::abs(K[r * n + c] - K[c * n + r]));
  EXPECT_GT(unsymmetric, 10);
}

TEST(Assembler, FindsTheGradientOfTheEnergyBesideTheResidual) {
  Sketch s = net_with_ropes();
  s.part("push", "test/follower", {{"k", 40.0}}, {5, 6, 10, 6, 8, 4}).data["rest_length"] = {1, 1, 1};
  s.scene.current = {.samples = {{-10, {0.5, 0.3, 0}}, {0, {1.5, 0.2, 0.1}}}};
  Assembled a(s.scene);
  expect_gradient_beside_residual(a, a.moved(0.2));
}

// Collapsed netting: two corners of a triangle are one node.
TEST(Assembler, ScattersTheTangentOfAnElementThatHasANodeTwice) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1.5, 0.3, -0.4);
  auto& net = s.part("net", "priour/triangle",
                     {{"twine.EA", 1e3}, {"twine.diameter", 0.002}, {"twine.density", 1000.0}}, {a, b, b});
  net.data = {{"u", {0, 2, 1}}, {"v", {0, 1, 3}}, {"bar_length", {0.1}}};
  Assembled one(s.scene);
  const auto x = one.moved(0.1);
  const auto K = one.matrix(x, MatrixKind::exact), reference = difference(one, x, kStep);
  EXPECT_LT(largest_difference(K, reference), 1e-6 * largest(reference));
}

double quadratic_form(const std::vector<double>& A, const std::vector<double>& v) {
  double sum = 0;
  for (std::size_t r = 0; r < v.size(); ++r)
    for (std::size_t c = 0; c < v.size(); ++c) sum += v[r] * A[r * v.size() + c] * v[c];
  return sum;
}

/// Random vectors of the size of the unknowns, from a fixed seed.
std::vector<std::vector<double>> directions(const Assembled& a, int count) {
  std::vector<std::vector<double>> all;
  for (int i = 0; i < count; ++i)
    all.push_back(random_numbers(static_cast<std::size_t>(a.assembler.pattern().size),
                                 100u + static_cast<unsigned>(i)));
  return all;
}

void expect_ordered(Assembled& a, const std::vector<double>& x) {
  const auto exact = a.matrix(x, MatrixKind::exact), convex = a.matrix(x, MatrixKind::convex),
             metric = a.matrix(x, MatrixKind::metric);
  for (const auto& v : directions(a, 200)) {
    const double c = quadratic_form(convex, v), m = quadratic_form(metric, v);
    EXPECT_GE(c, -1e-9 * m);
    EXPECT_GE(m, c * (1 - 1e-12));
    EXPECT_LE(quadratic_form(exact, v), c + 1e-9 * m);
  }
}

// Nodes are displaced by metres, so that some twines are slack, some are taut, and springs are in
// compression.
TEST(Assembler, HasAConvexPartBetweenNothingAndTheMetricOfNetting) {
  Assembled a(net_with_ropes().scene);
  expect_ordered(a, a.moved(8));
}

/// Springs that implement only their energy.
Scene springs() {
  Sketch s;
  const auto fixed = s.node(0, 0, 0, kAllAxes), b = s.node(0.4, 0.1, 0), c = s.node(0.7, 0, 0.2),
             d = s.node(2.9, 0.1, 0.3);
  s.part("springs", "test/spring", {{"k", 50.0}}, {fixed, b, b, c, c, d}).data["rest_length"] = {1, 1, 1};
  return s.scene;
}

TEST(Assembler, MakesTheConvexPartOfATermThatOffersNone) {
  Assembled a(springs());
  const auto x = a.assembler.start();
  const auto exact = a.matrix(x, MatrixKind::exact), convex = a.matrix(x, MatrixKind::convex);
  bool lost = false;
  for (const auto& v : directions(a, 200)) {
    lost |= quadratic_form(exact, v) < 0;
    EXPECT_GE(quadratic_form(convex, v), -1e-12);
    EXPECT_GE(quadratic_form(convex, v), quadratic_form(exact, v) - 1e-9);
  }
  EXPECT_TRUE(lost) << "the exact tangent was meant to be indefinite";
}

TEST(Assembler, BoundsTheTangentOfATermThatOffersNoMetric) {
  Assembled a(springs());
  const auto x = a.assembler.start();
  const auto exact = a.matrix(x, MatrixKind::exact), metric = a.matrix(x, MatrixKind::metric);
  for (const auto& v : directions(a, 200))
    EXPECT_GE(quadratic_form(metric, v), std::abs(quadratic_form(exact, v)) - 1e-9);
}

TEST(Assembler, ReportsWhatHoldsTheGearAsReactions) {
  Sketch s;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0, 0, -2);
  s.rope("rope", {top, end}, 1, 100);
  s.part("load", "test/load", {{"x", 3.0}, {"z", -50.0}}, {end});
  Assembled a(s.scene);
  const auto r = a.residual(a.assembler.start());
  const double half = 0.5 * std::acos(-1.0) / 4 * 1e-4 * (7850 - 1025) * 9.81;
  const auto at = [&](std::uint32_t node, int axis) {
    return r[a.assembler.numbering().dof(node, axis).at()];
  };
  // The bar is stretched by 1 m and pulls with 100 N. The reaction at its top is this force and half of the
  // weight.
  EXPECT_NEAR(at(top, 2), 100 + half, 1e-12 * 100);
  EXPECT_NEAR(at(end, 2), -100 + half + 50, 1e-12 * 100);
  EXPECT_NEAR(at(end, 0), -3, 1e-15);
}

TEST(Assembler, GivesOneTermAloneAndSumsOfItByPart) {
  Sketch s = net_with_ropes();
  Assembled a(s.scene);
  const auto x = a.moved(0.1);
  std::vector<double> sum(x.size(), 0.0), term(x.size());
  for (std::size_t f = 0; f < a.assembler.families().size(); ++f)
    for (std::size_t t = 0; t < a.assembler.families()[f]->active_terms().size(); ++t) {
      ASSERT_TRUE(a.assembler.reports().evaluate_term(x, f, t, term));
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term[i];
    }
  EXPECT_LT(largest_difference(sum, a.residual(x)), 1e-12 * largest(sum));

  // Weight of the ropes, which are 30 m and 20 m long.
  std::vector<double> weight(3 * a.assembler.families()[1]->parts().size());
  ASSERT_TRUE(a.assembler.reports().sum_term(x, 1, 1, weight));
  const double per_metre = std::acos(-1.0) / 4 * 1e-4 * (7850 - 1025) * 9.81;
  EXPECT_EQ(a.assembler.families()[1]->active_terms()[1].name, std::string("weight"));
  EXPECT_NEAR(weight[2], 20 * per_metre, 1e-10);
  EXPECT_NEAR(weight[5], 20 * per_metre, 1e-10);
}

TEST(Assembler, NamesTheElementThatHasNoForce) {
  Sketch s;
  std::vector<std::uint32_t> chain{s.node(0, 0, 0, kAllAxes)};
  for (int i = 1; i <= 200; ++i) chain.push_back(s.node(i, 0, 0));
  std::vector<std::uint32_t> ends;
  for (std::size_t i = 0; i < 200; ++i) ends.insert(ends.end(), {chain[i], chain[i + 1]});
  s.part("first", "test/picky", {{"limit", 100.0}}, {chain[0], chain[1]}).data["rest_length"] = {1};
  s.part("second", "test/picky", {{"limit", 1.5}}, ends).data["rest_length"].assign(200, 1);
  Assembled a(s.scene, 3);
  auto x = a.assembler.start();
  double energy = 0;
  ASSERT_TRUE(a.assembler.evaluate(x, {.energy = &energy}));
  const auto place = a.assembler.numbering().dof(chain[151], 0).at();
  x[place] += 0.7;  // bar 150 is 1.7 m long
  EXPECT_FALSE(a.assembler.evaluate(x, {.energy = &energy}));
  EXPECT_EQ(a.assembler.fault().status, NETLOFT_OUTSIDE_DOMAIN);
  EXPECT_EQ(a.assembler.fault_sentence(a.scene), "second element 150 (test/picky): longer than its limit");
  x[place] -= 0.7;
  EXPECT_TRUE(a.assembler.evaluate(x, {.energy = &energy})) << "a fault is over with the state that had it";
}

TEST(Assembler, TellsABrokenElementFromAStateWithoutForce) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0);
  s.part("bad", "test/picky", {{"limit", 9.0}, {"broken", true}}, {a, b}).data["rest_length"] = {1};
  Assembled scene(s.scene);
  double energy = 0;
  EXPECT_FALSE(scene.assembler.evaluate(scene.assembler.start(), {.energy = &energy}));
  EXPECT_EQ(scene.assembler.fault().status, NETLOFT_ERROR);
}

/// All results of one evaluation, to be compared between numbers of threads.
struct Everything {
  Everything(const Scene& scene, int threads) {
    Assembled a(scene, threads);
    EXPECT_EQ(a.assembler.threads_used(), threads);
    const auto x = a.moved(0.3);
    residual.resize(x.size()), values.resize(a.assembler.value_slots());
    for (const MatrixKind kind : {MatrixKind::exact, MatrixKind::convex, MatrixKind::metric}) {
      EXPECT_TRUE(a.assembler.evaluate(
          x, {.energy = &energy, .residual = residual.data(), .matrix = kind, .values = values.data()}));
      matrices.insert(matrices.end(), values.begin(),
                      values.begin() + static_cast<std::ptrdiff_t>(a.assembler.pattern().value_slots()));
    }
    EXPECT_TRUE(a.assembler.evaluate(x, {.energy = &energy_alone}));
  }
  double energy = 0, energy_alone = 0;
  std::vector<double> residual, values, matrices;
};

TEST(Assembler, GivesTheSameBitsForOneTwoAndThreeThreads) {
  Sketch s;
  s.scene = sample::hanging_panel(48, 34);
  std::vector<std::uint32_t> chain;
  for (std::uint32_t i = 0; i <= 48; ++i) chain.push_back(i);
  s.rope("headline", chain, 0.7);
  s.scene.held.assign(s.scene.held.size(), 0);
  const Everything one(s.scene, 1);
  for (const int threads : {2, 3}) {
    const Everything more(s.scene, threads);
    EXPECT_EQ(one.energy, more.energy);
    EXPECT_EQ(one.energy_alone, more.energy_alone);
    EXPECT_EQ(one.residual, more.residual);
    EXPECT_EQ(one.matrices, more.matrices);
  }
  EXPECT_EQ(one.energy, one.energy_alone);
}

/// Two scenes that differ only in stiffness have the same layout; a scene with one more held node has another
/// layout.
TEST(Assembler, TakesOverTheLayoutOfTheSameConnections) {
  const Sketch sketch = net_with_ropes();
  Scene stiffer = sketch.scene, shorter = sketch.scene;
  stiffer.positions[0] += 0.5;
  shorter.held[5] = kAllAxes;
  Assembled first(sketch.scene), alone(stiffer);
  const ScenePlan plan = make_scene_plan(stiffer, plugins()),
                  of_shorter = make_scene_plan(shorter, plugins());
  Assembler alike(stiffer, plan, 1, &first.assembler), other(shorter, of_shorter, 1, &first.assembler);
  EXPECT_EQ(&alike.pattern(), &first.assembler.pattern());
  EXPECT_NE(&other.pattern(), &first.assembler.pattern());
  EXPECT_EQ(other.pattern(), Assembler(shorter, of_shorter, 1).pattern());
  const auto x = alone.moved(0.2);
  std::vector<double> residual(x.size());
  ASSERT_TRUE(alike.evaluate(x, {.residual = residual.data()}));
  EXPECT_EQ(residual, alone.residual(x));
}

}  // namespace
}  // namespace netloft::test
