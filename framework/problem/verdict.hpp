// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/assessment.hpp"

#include <optional>

namespace netloft {

/// One solve on the way to an answer: of the scene itself, or of an easier one.
struct StageRecord {
  std::string name;    // "tension only"
  std::string solver;  // "newton/newton"
  std::size_t unknowns = 0;
  SolveStatus status = SolveStatus::not_converged;
  std::string reason;
  Statistics statistics;
  netloft_variant variant{};  // of the scene that was solved
  double work = 0;            // in the units of work.hpp
};

/// Another place where the gear is in equilibrium that is not unstable.
struct OtherShape {
  double energy = 0;           // [J]
  double distance = 0;         // of its furthest node from where the solution has it [m]
  std::string furthest;        // that node
  int times = 1;               // that it was found
  std::vector<double> x = {};  // positions over all dofs
};

/// What was found by looking for other shapes, and by which rule the solution was chosen among them
/// (framework/study/shapes.hpp).
struct Shapes {
  bool by_energy = false;       // the least; else the first that was found
  int restarts = 0, times = 1;  // that the solution was found, the first time included
  std::vector<OtherShape> others;
};

/// Where a solver ended, what the host makes of it, and what it cost.
struct Solution : Assessment {
  Stop stop = Stop::none;
  double work = 0;               // of all stages, in the units of work.hpp
  std::vector<double> u;         // displacements of the unknowns that x stands for
  bool does_not_settle = false;  // given up because it went on and on (Limits::path), or its motions were
  Statistics statistics;         // the solver's own counts, and the time of everything
  std::vector<IterationRecord> history;
  std::string factorisation;
  std::vector<std::string> diagnostics;  // what may be why it did not converge, by whoever knows the parts
  std::vector<StageRecord> stages;       // if there were several; `statistics` is then their sum
  Shapes shapes;
  std::vector<double> factors;  // of the settings of the scene, at which this is its equilibrium
};

/// Of positions, while they are looked for: what a double has room for, or also what it rounds off
/// (StaticProblem::count_from).
enum class Positions { plain, compensated };

/// Why a solver cannot work on problems with these traits (traits_of): it needs an energy, say. Empty: it
/// can.
std::optional<std::string> why_unfit(const SolverType& solver, std::uint32_t problem_traits);

/// Lets `solver` find the static equilibrium of the assembled scene, from displacements `start` of the
/// unknowns (empty: from the start of the scene), recomputes the residual where it ended and judges it. How
/// far from the equilibrium a balanced point is estimated to be, says `correction`. A stationary point whose
/// tangent is not positive definite is called unstable, and so is one about which something grows, where
/// forces have no energy (Judging::ask_growth). A solver that is unfit is not started, and nothing is
/// computed. What elements remember (friction) does not change: an equilibrium is one of the past that the
/// scene had.
Solution solve_static(const Scene& scene, Assembler& assembler, const SolverType& solver,
                      const void* parameters, const Limits& limits, const MakeFactorisation& make,
                      Observer observer = {}, std::span<const double> start = {},
                      Positions positions = Positions::plain);

}  // namespace netloft
