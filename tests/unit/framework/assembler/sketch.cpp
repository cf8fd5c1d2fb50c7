// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/framework/assembler/sketch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/verification/solving.hpp"

namespace netloft::test {

const netloft_plugin* test_plugin();

Registry& plugins() {
  Registry& registry = shipped_plugins();
  [[maybe_unused]] static const bool added = (registry.add_builtin("test", &test_plugin), true);
  return registry;
}

std::uint32_t Sketch::node(double x, double y, double z, std::uint8_t held) {
  scene.positions.insert(scene.positions.end(), {x, y, z});
  scene.held.push_back(held);
  scene.labels.push_back({0, static_cast<std::uint32_t>(scene.labels.size())});
  return static_cast<std::uint32_t>(scene.node_count() - 1);
}

Part& Sketch::part(const std::string& name, const std::string& type, Values parameters,
                   std::vector<std::uint32_t> nodes) {
  scene.parts.push_back({name, type, std::move(parameters), std::move(nodes), {}});
  return scene.parts.back();
}

Part& Sketch::rope(const std::string& name, const std::vector<std::uint32_t>& chain, double l0, double EA) {
  std::vector<std::uint32_t> ends;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) ends.insert(ends.end(), {chain[i], chain[i + 1]});
  Part& rope = part(name, "rope/bar", {{"rope.EA", EA}, {"rope.diameter", 0.01}, {"rope.density", 7850.0}},
                    std::move(ends));
  rope.data["rest_length"].assign(chain.size() - 1, l0);
  return rope;
}

std::vector<double> random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> numbers(count);
  for (double& v : numbers) v = 2 * (static_cast<double>(random()) / 4294967295.0) - 1;
  return numbers;
}

std::vector<double> Assembled::moved(double size, unsigned seed) const {
  std::vector<double> x = assembler.start();
  const auto moves = random_numbers(x.size(), seed);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += size * moves[i];
  return x;
}

std::vector<double> Assembled::residual(const std::vector<double>& x) {
  std::vector<double> r(assembler.numbering().dofs());
  if (!assembler.evaluate(x, {.residual = r.data()}))
    throw std::runtime_error(assembler.fault_sentence(scene));
  return r;
}

double Assembled::energy(const std::vector<double>& x) {
  double e = 0;
  if (!assembler.evaluate(x, {.energy = &e})) throw std::runtime_error(assembler.fault_sentence(scene));
  return e;
}

std::vector<double> Assembled::matrix(const std::vector<double>& x, MatrixKind kind) {
  std::vector<double> values(assembler.value_slots());
  if (!assembler.evaluate(x, {.matrix = kind, .values = values.data()}))
    throw std::runtime_error(assembler.fault_sentence(scene));
  const SparsePattern& p = assembler.pattern();
  const auto n = static_cast<std::size_t>(p.size);
  std::vector<double> full(n * n, 0.0);
  for (std::size_t c = 0; c < n; ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      full[r * n + c] = values[p.slot_of(k)];
      if (p.symmetric) full[c * n + r] = values[p.slot_of(k)];
    }
  return full;
}

std::vector<double> difference(Assembled& a, const std::vector<double>& x, double h) {
  const auto n = static_cast<std::size_t>(a.assembler.pattern().size);
  std::vector<double> full(n * n);
  for (std::size_t c = 0; c < n; ++c) {
    auto right = x, left = x;
    right[c] += h, left[c] -= h;
    const auto r = a.residual(right), l = a.residual(left);
    for (std::size_t row = 0; row < n; ++row) full[row * n + c] = (r[row] - l[row]) / (right[c] - left[c]);
  }
  return full;
}

void expect_gradient_beside_residual(Assembled& a, const std::vector<double>& x) {
  std::vector<double> alone(x.size()), residual(x.size()), gradient(x.size(), 1.0);
  double energy = 0, energy_alone = 0;
  ASSERT_TRUE(a.assembler.evaluate(
      x, {.energy = &energy_alone, .conservative_only = true, .residual = alone.data()}));
  ASSERT_TRUE(
      a.assembler.evaluate(x, {.energy = &energy, .residual = residual.data(), .gradient = gradient.data()}));
  EXPECT_EQ(gradient, alone);
  EXPECT_EQ(residual, a.residual(x));
  EXPECT_EQ(energy, energy_alone);
  EXPECT_GT(largest_difference(residual, gradient), 0.01 * largest(gradient));
}

double largest(const std::vector<double>& v) {
  double most = 0;
  for (const double a : v) most = std::max(most, std::abs(a));
  return most;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace netloft::test
