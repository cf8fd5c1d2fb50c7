// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <functional>
#include <random>

namespace netloft::test {

/// The shipped plugins and one more, "test", with elements for what no shipped one does:
///   test/follower   bar; pushes sideways and turns with the bar: no energy, unsymmetric tangent
///   test/spring     bar; quartic spring known by its energy alone: the host makes convex part and metric
///   test/picky      bar; has no force when longer than its limit
///   test/leash      node; pulls back along x to the position that it remembers
///   test/alike      bar; its rest length, shared by its part, is an unknown if `free` is set
///   test/load       node; a constant force
///   test/vane       body; a mass and a plate in the water, known by energy and force alone
Registry& plugins();

/// A scene to which tests add nodes and parts one by one.
struct Sketch {
  Scene scene;

  Sketch() { scene.name = "sketch", scene.water = {1025, 9.81}; }
  std::uint32_t node(double x, double y, double z, std::uint8_t held = 0);
  /// A part of elements on these nodes, as many each as the stencil has.
  Part& part(const std::string& name, const std::string& type, Values parameters,
             std::vector<std::uint32_t> nodes);
  /// Bars of rest length `l0` from each node to the next.
  Part& rope(const std::string& name, const std::vector<std::uint32_t>& chain, double l0, double EA = 1e4);
};

/// A scene with its plan, assembled.
struct Assembled {
  explicit Assembled(Scene given, int threads = 1, const std::function<void(ScenePlan&)>& change = {})
      : scene(std::move(given)), plan(make_changed_plan(scene, change)), assembler(scene, plan, threads) {}
  static ScenePlan make_changed_plan(const Scene& scene, const std::function<void(ScenePlan&)>& change) {
    ScenePlan plan = make_scene_plan(scene, plugins());
    if (change) change(plan);
    return plan;
  }
  Scene scene;
  ScenePlan plan;
  Assembler assembler;

  /// The start, every coordinate moved by up to `size`, from a fixed seed.
  std::vector<double> moved(double size, unsigned seed = 1) const;
  std::vector<double> residual(const std::vector<double>& x);
  double energy(const std::vector<double>& x);
  /// A matrix over the unknowns, full, row by row.
  std::vector<double> matrix(const std::vector<double>& x, MatrixKind kind);
};

/// Central differences of the residual: d residual_row / d x_column over the unknowns, full, row by row.
std::vector<double> difference(Assembled& a, const std::vector<double>& x, double h);

/// A gradient found beside the residual at x has the bits that it has alone, and changes none of the other
/// sums; and it is not the residual.
void expect_gradient_beside_residual(Assembled& a, const std::vector<double>& x);

/// Between -1 and 1, the same on every machine.
std::vector<double> random_numbers(std::size_t count, unsigned seed);

double largest(const std::vector<double>& v);
double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace netloft::test
