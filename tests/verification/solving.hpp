// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

#include <array>
#include <cmath>
#include <map>
#include <memory>

namespace netloft::test {

/// The shipped plugins of this build.
Registry& shipped_plugins();

/// How a test solves its scene. The defaults are those of the program.
struct Solving {
  Values solver_parameters = {};
  Limits limits = {};
  int threads = 1;
  std::string solver = "newton";
  std::string strategy = "";  // empty: only the solver, in one solve
  Values strategy_parameters = {};
  double work = 5000;                   // budget of the strategy
  std::map<std::string, Values> given;  // parameters of the solvers and strategies that it calls, by type
  MakeFactorisation make = make_factorisation;
};

/// A scene with its assembler and the result of the solver.
struct Solved {
  Scene scene;
  ScenePlan plan;
  std::unique_ptr<Assembler> assembler;
  Solution solution;

  std::array<double, 3> position(std::uint32_t node) const { return vector_at(solution.x, node); }
  /// Force of the support on a node along its held axes [N].
  std::array<double, 3> reaction(std::uint32_t node) const { return vector_at(solution.residual, node); }
  /// Sum of reaction(n) over all nodes.
  std::array<double, 3> total_reaction() const;
  double lowest_z() const;
  /// The first output of the only family with that output, by element.
  std::vector<double> output(const std::string& name) const;

 private:
  std::array<double, 3> vector_at(const std::vector<double>& v, std::uint32_t node) const;
};

Solved solve(Scene scene, const Solving& how = {});

/// Lets a shipped solver solve a problem that a test defines.
netloft_outcome solve_problem(netloft_problem& problem, const std::string& solver,
                              const Values& parameters = {});

/// The size of an error, as a fraction of the exact value.
inline double relative(double value, double exact) { return std::abs(value - exact) / std::abs(exact); }

/// Energy at the same positions without gravity: the energy stored in the stretched netting [J].
double elastic_energy(const Solved& solved);

}  // namespace netloft::test
