// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

/// Finds the equilibrium by the analysis of the scene, from displacements `from` (empty: the start of the
/// scene). The scene adopts the solution (PreparedScene::adopt).
Solution find_equilibrium(PreparedScene& scene, const Watch& watch = {},
                          const std::vector<double>& from = {});

/// Looks for the equilibrium near displacements `u` by the solver of the analysis alone, in at most
/// `iterations`.
Solution continue_equilibrium(PreparedScene& scene, const std::vector<double>& u, int iterations,
                              const Watch& watch = {});

/// continue_equilibrium, followed by find_equilibrium from an equilibrium that is not stable, and from the
/// start of the scene if none was found.
Solution find_equilibrium_near(PreparedScene& scene, const std::vector<double>& u, const Watch& watch = {});

/// Finds the equilibrium that a motion starts from, with the forces, tangent, tolerance and solver of a
/// static analysis: a motion may leave out parts of the tangent and still swing about this equilibrium. Both
/// number their unknowns alike.
Solution find_start_of_motion(PreparedScene& scene, const Watch& watch);

/// Assesses displacements `u` that no solver has declared an equilibrium, by the given assembler: if a plugin
/// does not come back, that of the scene stays busy.
Solution assess_point(const PreparedScene& scene, std::span<const double> u, Assembler& assembler);

/// Why the solver of the analysis cannot work on this scene, for example because it needs an energy.
std::optional<std::string> why_unfit(PreparedScene& scene);

/// The attempts of the strategy in their order, with reasons, a line each.
std::string explain_strategy(PreparedScene& scene);

}  // namespace netloft::runs
