// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

/// Finds the equilibrium by the analysis of the scene, from displacements `from` (empty: the initial
/// positions of the scene). The scene adopts the solution (PreparedScene::adopt).
Solution find_equilibrium(PreparedScene& scene, const Watch& watch = {},
                          const std::vector<double>& from = {});

/// Searches for the equilibrium near displacements `u` with the solver of the analysis only, in at most
/// `iterations`.
Solution continue_equilibrium(PreparedScene& scene, const std::vector<double>& u, int iterations,
                              const Watch& watch = {});

/// Calls continue_equilibrium, and then find_equilibrium if the result is not stable: from the equilibrium
/// found, or from the initial positions if there is none.
Solution find_equilibrium_near(PreparedScene& scene, const std::vector<double>& u, const Watch& watch = {});

/// Finds the equilibrium from which a motion starts, with the forces, tangent, tolerance and solver of a
/// static analysis: a motion may leave out parts of the tangent and still oscillate about this equilibrium.
/// Both analyses number their unknowns alike.
Solution find_start_of_motion(PreparedScene& scene, const Watch& watch);

/// Assesses displacements `u` that no solver has declared an equilibrium, with the given assembler. The
/// assembler of the scene cannot be used if a plugin call never returns, because it stays busy.
Solution assess_point(const PreparedScene& scene, std::span<const double> u, Assembler& assembler);

/// The reason why the solver of the analysis cannot work on this scene, for example because it needs an
/// energy; empty if it can.
std::optional<std::string> why_unfit(PreparedScene& scene);

/// The attempts of the strategy in their order, with reasons, one line each.
std::string explain_strategy(PreparedScene& scene);

}  // namespace netloft::runs
