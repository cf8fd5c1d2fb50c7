// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/static_problem.hpp"

namespace netloft {

enum class SolveStatus { converged, unstable, not_converged, interrupted };
enum class Stability { stable, neutral, unstable, unknown };

/// One solve on the way to an answer: of the scene itself, or of an easier one.
struct Leg {
  std::string name;    // "tension only"
  std::string solver;  // "newton/newton"
  std::size_t unknowns = 0;
  SolveStatus status = SolveStatus::not_converged;
  std::string reason;
  Books books;
};

/// Another place where the gear is in equilibrium that is not unstable.
struct OtherShape {
  double energy = 0;     // [J]
  double distance = 0;   // of its furthest node from where the solution has it [m]
  std::string furthest;  // that node
  int times = 1;         // that it was found
};

/// What was found by looking for other shapes.
struct Shapes {
  int looks = 0, times = 1;  // that the solution was found, the first time included
  std::vector<OtherShape> others;
};

/// Where a solver ended and what the host makes of it.
struct Solution {
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;               // a sentence
  std::string at_fault;             // the part that is furthest from balance or could not be evaluated
  std::vector<double> x, residual;  // over all dofs [m], [N]
  std::vector<double> x_low;        // what x rounds off [m]; empty: not known
  std::vector<double> u;            // displacements of the unknowns that x stands for
  std::vector<double> growing;      // a disturbance of u that grows, where forces have no energy; length 1
  double growth_rate = 0;  // of that [1/s], and with which it swings [rad/s]; zero where nothing flows
  double growth_frequency = 0;
  bool is_restless = false;  // given up because it went on and on (Limits::way), or its motions were
  double energy = 0;
  Balance balance;
  std::vector<double> corrected;      // x after the Newton step that is left, over all dofs; empty: not known
  std::vector<double> corrected_low;  // what that rounds off
  double correction = std::numeric_limits<double>::quiet_NaN();  // its largest nodal move [m]
  Books books;
  std::vector<IterationRecord> history;
  std::string factorisation;
  std::vector<std::string> signs;  // of what may be why, where it did not arrive; from who knows the parts
  std::vector<Leg> legs;           // if there were several; `books` is then their sum
  Shapes shapes;
};

/// Forces balance there, whether or not it is stable.
inline bool is_stationary(const Solution& s) {
  return s.status == SolveStatus::converged || s.status == SolveStatus::unstable;
}

/// Where a disturbance swings faster than it grows: its motion goes round and comes to rest nowhere near.
inline bool flutters(const Solution& s) { return s.growth_frequency > s.growth_rate; }

/// Of positions, while they are looked for: what a double has room for, or also what it rounds off
/// (StaticProblem::count_from).
enum class Digits { of_doubles, all };

/// Lets `solver` find the static equilibrium of the assembled scene, from displacements `start` of the
/// unknowns (empty: from the scene's own start), recomputes the residual where it ended and judges it. How
/// far from the equilibrium a balanced point is estimated to be, says `correction`. A stationary point whose
/// tangent is not positive definite is called unstable. What elements remember (friction) stands still while
/// the solver works; where it converged is what they remember next.
Solution solve_static(const Scene& scene, Assembler& assembler, const SolverType& solver,
                      const void* parameters, const Limits& limits, const MakeFactorisation& make,
                      std::function<void(const IterationRecord&)> on_iteration = {},
                      std::span<const double> start = {}, Digits digits = Digits::of_doubles);

const char* name_of(SolveStatus status);
const char* name_of(Stability stability);

}  // namespace netloft
