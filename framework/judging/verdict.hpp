// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/solution.hpp"

#include <optional>

namespace netloft {

/// Of positions, while they are looked for: what a double has room for, or also what it rounds off
/// (StaticProblem::count_from).
enum class Positions { plain, compensated };

/// Where a solver begins.
struct StartPoint {
  std::span<const double> u = {};  // displacements of the unknowns; empty: none, the start of the scene
  Positions positions = Positions::plain;
};

/// Why a solver cannot work on problems with these traits (traits_of): it needs an energy, say. Empty: it
/// can.
std::optional<std::string> why_unfit(const SolverType& solver, std::uint32_t problem_traits);

/// Lets `solver` find the static equilibrium of a scene, recomputes the residual where it ended and judges
/// it. How far from the equilibrium a balanced point is estimated to be, says `correction`. A stationary
/// point whose tangent is not positive definite is called unstable, and so is one about which something
/// grows, where forces have no energy (Judging::ask_growth). A solver that is unfit is not started, and
/// nothing is computed. What elements remember (friction) does not change: an equilibrium is one of the past
/// that the scene had.
Solution solve_static(const AssembledScene& scene, SolverChoice solver, const Limits& limits,
                      StartPoint start = {}, Observer observer = {});

}  // namespace netloft
