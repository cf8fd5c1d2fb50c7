// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/correction.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

double node_distance(const Numbering& numbering, std::uint32_t node, std::span<const double> x,
                     std::span<const double> y) {
  std::array<double, 3> way{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = numbering.dof(node, axis).at();
    way[static_cast<std::size_t>(axis)] = y[i] - x[i];
  }
  return std::hypot(way[0], way[1], way[2]);
}

}  // namespace

bool factorise_tangent(StaticProblem& problem, std::span<const double> u) {
  netloft_problem& p = problem.interface();
  return p.evaluate(p.host, NETLOFT_WANT_TANGENT, u.data(), nullptr, nullptr) == NETLOFT_OK &&
         p.factorise(p.host, NETLOFT_EXACT | NETLOFT_INDEFINITE, 0) == NETLOFT_FACTOR_OK;
}

bool find_correction(StaticProblem& problem, std::span<const double> u, std::span<const double> residual,
                     std::span<double> du) {
  return factorise_tangent(problem, u) && solve_for_correction(problem, residual, du);
}

bool solve_for_correction(StaticProblem& problem, std::span<const double> residual, std::span<double> du) {
  netloft_problem& p = problem.interface();
  if (p.solve(p.host, residual.data(), du.data()) != NETLOFT_OK) return false;
  for (double& step : du) step = -step;  // (1)
  return std::all_of(du.begin(), du.end(), [](double step) { return std::isfinite(step); });
}

NodeDistance furthest_node(const Scene& scene, const Numbering& numbering, std::span<const double> x,
                           std::span<const double> y) {
  NodeDistance furthest;
  for (std::uint32_t node = 0; node < scene.node_count(); ++node) {
    const double distance = node_distance(numbering, node, x, y);
    if (distance > furthest.distance) furthest = {distance, node};
  }
  return furthest;
}

double largest_node_distance(const Scene& scene, const Numbering& numbering, std::span<const double> x,
                             std::span<const double> y) {
  return furthest_node(scene, numbering, x, y).distance;
}

}  // namespace netloft
