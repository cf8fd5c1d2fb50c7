// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/solution.hpp"

#include <optional>

namespace netloft {

/// Precision of positions during a solve: `plain` is double precision; `compensated` also stores the digits
/// that double precision rounds off (StaticProblem::count_from).
enum class Positions { plain, compensated };

/// The initial guess of a solver.
struct StartPoint {
  std::span<const double> u = {};  // displacements of the unknowns; empty: the start of the scene
  Positions positions = Positions::plain;
};

/// The reason why a solver cannot work on problems with these traits (traits_of), for example that it needs
/// conservative forces; nullopt if there is none.
std::optional<std::string> why_unfit(const SolverType& solver, std::uint32_t problem_traits);

/// Lets `solver` find the static equilibrium of a scene, and assesses its final point, including its distance
/// from the equilibrium (`correction`). If all forces have a potential, a stationary point is unstable if its
/// tangent is not positive definite; otherwise, it is unstable if a disturbance grows
/// (Judging::examine_growth). A solver that cannot work on the scene is not started. The memory of elements
/// (friction) is used but not changed: the equilibrium depends on the history of the scene before this call.
Solution solve_static(const AssembledScene& scene, SolverChoice solver, const Limits& limits,
                      StartPoint start = {}, Observer observer = {});

}  // namespace netloft
