// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/verification/solving.hpp"

#include <cmath>
#include <numbers>

namespace netloft::test {

/// A mass on a linear spring: a bar along x with equal stiffness in tension and compression. One end is
/// fixed, and the free end carries half of the bar's mass. There is no water and no gravity.
struct Oscillator {
  double EA = 1000, length = 2, mass = 0.5;  // [N], [m], [kg] at the free end

  double omega() const { return std::sqrt(EA / length / mass); }
  Scene scene() const {
    constexpr double kDiameter = 0.02;
    Scene s;
    s.name = "oscillator";
    s.water = {0, 0};
    s.positions = {0, 0, 0, length, 0, 0};
    s.held = {kAllAxes, kAxisY | kAxisZ};
    s.labels = {{0, 0}, {0, 1}};
    Part bar;
    bar.name = "bar", bar.type = "rope/bar", bar.nodes = {0, 1};
    bar.data["rest_length"] = {length};
    const double volume = std::numbers::pi / 4 * kDiameter * kDiameter * length;
    bar.parameters = {{"rope.EA", EA},
                      {"rope.EA_compression", EA},
                      {"rope.diameter", kDiameter},
                      {"rope.density", 2 * mass / volume}};
    s.parts.push_back(bar);
    return s;
  }
};

/// An integrator of this build with parameters.
struct Chosen {
  Chosen(const std::string& name, const Values& values)
      : type(shipped_plugins().integrator(name)),
        block(type.parameters, type.integrator.parameter_bytes, values, faults) {}
  IntegratorChoice choice() const { return {&type, block.data()}; }

  std::vector<std::string> faults;
  const IntegratorType& type;
  ParameterBlock block;
};

/// The plan of a scene in motion, with mean forces over the steps for the integrator `by_means`, if it is not
/// empty.
inline ScenePlan plan_in_motion(const Scene& scene, const std::string& by_means) {
  ScenePlan plan =
      make_scene_plan(scene, shipped_plugins(), TangentChoice::symmetric, AnalysisKind::dynamics);
  if (!by_means.empty()) use_mean_forces(plan, by_means);
  return plan;
}

/// A scene in motion, with the solver of its steps.
struct Moving {
  explicit Moving(Scene given, const std::string& solver = "chord", int threads = 1,
                  const std::string& by_means = "")
      : scene(std::move(given)),
        plan(plan_in_motion(scene, by_means)),
        assembler(scene, plan, threads),
        solver_type(shipped_plugins().solver(solver)),
        solver_block(solver_type.parameters, solver_type.solver.parameter_bytes, {}, faults) {
    limits.tolerance = 1e-12, limits.iterations = 50;
  }
  MarchResult run(const std::string& integrator, const Values& values, const MarchSettings& settings,
                  const MarchState* from = nullptr) {
    const Chosen chosen(integrator, values);
    return march({scene, assembler, make_factorisation},
                 {chosen.choice(), {&solver_type, solver_block.data()}}, limits, settings, watch, from);
  }

  std::vector<std::string> faults;
  Scene scene;
  ScenePlan plan;
  Assembler assembler;
  const SolverType& solver_type;
  ParameterBlock solver_block;
  Limits limits;
  MarchWatch watch;
};

}  // namespace netloft::test
