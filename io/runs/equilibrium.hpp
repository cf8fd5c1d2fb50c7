// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

/// Finds the equilibrium with the strategy and the solver that the scene names, from displacements `from`
/// (empty: the initial positions of the scene). If the search also finds a quantity of the scene, such as the
/// length of a rope, the scene gets the value found (PreparedScene::adopt).
Solution find_equilibrium(PreparedScene& scene, const Watch& watch = {},
                          const std::vector<double>& from = {});

/// Searches for the equilibrium near displacements `u` with the solver alone, without the fallbacks of the
/// strategy, in at most `iterations`.
Solution continue_equilibrium(PreparedScene& scene, const std::vector<double>& u, int iterations,
                              const Watch& watch = {});

/// Searches near `u` by continue_equilibrium. If this search ends at an unstable equilibrium,
/// find_equilibrium continues from there. If this second search fails, or if the first one found no
/// equilibrium, find_equilibrium starts from the initial positions.
Solution find_equilibrium_near(PreparedScene& scene, const std::vector<double>& u, const Watch& watch = {});

/// Finds the equilibrium from which a motion starts. It uses the forces, tangent, tolerance and solver of a
/// static analysis, because the settings of a motion may leave out parts of the tangent. The displacements
/// found are valid for the motion, because both analyses number the unknowns in the same way.
Solution find_start_of_motion(PreparedScene& scene, const Watch& watch);

/// Assesses displacements `u` at which a search was broken off. The caller provides an assembler, because the
/// assembler of the scene is busy if a call of a plugin never returns.
Solution assess_point(const PreparedScene& scene, std::span<const double> u, Assembler& assembler);

/// The reason why the solver of the scene cannot solve it, for example that the solver needs forces with a
/// potential; nullopt if it can.
std::optional<std::string> why_unfit(PreparedScene& scene);

/// The attempts that the strategy will make, in their order: a line with a reason for each attempt.
std::string explain_strategy(PreparedScene& scene);

}  // namespace netloft::runs
