// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <functional>
#include <random>

namespace netloft::test {

/// The shipped plugins and the plugin "test", with elements whose behaviour no shipped element has:
///   test/follower   bar; pushes sideways and turns with the bar: no potential, unsymmetric tangent
///   test/spring     bar; quartic spring that implements only its energy
///   test/picky      bar; its force is not defined beyond a limit of its length
///   test/leash      node; pulls back along x to the position that it remembers
///   test/alike      bar; its rest length, shared by its part, is an unknown if `free` is set
///   test/load       node; a constant force
///   test/vane body; a mass and a plate in the water, whose energy and force are implemented without
///   derivatives
Registry& plugins();

/// A scene to which tests add nodes and parts one by one.
struct Sketch {
  Scene scene;

  Sketch() { scene.name = "sketch", scene.water = {1025, 9.81}; }
  std::uint32_t node(double x, double y, double z, std::uint8_t held = 0);
  /// Adds a part. Each element takes the next nodes of the list, as many as its stencil has.
  Part& part(const std::string& name, const std::string& type, Values parameters,
             std::vector<std::uint32_t> nodes);
  /// Adds a part of bars of rest length `l0`, from each node of the chain to the next.
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

  /// Positions at the start with every coordinate moved by up to `size`, from a fixed seed.
  std::vector<double> moved(double size, unsigned seed = 1) const;
  std::vector<double> residual(const std::vector<double>& x);
  double energy(const std::vector<double>& x);
  /// A full matrix over the unknowns, row by row.
  std::vector<double> matrix(const std::vector<double>& x, MatrixKind kind);
};

/// Central differences of the residual, d residual_row / d x_column over the unknowns: a full matrix, row by
/// row.
std::vector<double> difference(Assembled& a, const std::vector<double>& x, double h);

/// Expects that the gradient computed together with the residual at x equals, to the bit, the gradient
/// computed alone, differs from the residual, and leaves all other sums unchanged.
void expect_gradient_beside_residual(Assembled& a, const std::vector<double>& x);

/// Random numbers between -1 and 1, the same on every machine.
std::vector<double> random_numbers(std::size_t count, unsigned seed);

double largest(const std::vector<double>& v);
double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace netloft::test
