// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "io/results/figures/response.hpp"
#include "io/results/figures/result.hpp"

#include <optional>
#include <vector>

namespace netloft::results {

/// The motion of a scene at rest, as input of an evaluation: without velocities, and with the digits that
/// rounding removed from the positions, if these digits are known.
Kinematics at_rest(const Solution& solution);

/// The figures of the gear, computed from a response of its elements, without error estimates. Empty if there
/// is neither a net plan nor a rigid body.
std::vector<NamedScalar> find_figures(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer);
/// The numbers that the scene requests in its table [results].
std::vector<NamedScalar> find_scalars(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Solution& solution, const FamilyOutputs& outputs);

/// All numbers of a scene at one set of positions.
struct Numbers {
  std::vector<NamedScalar> scalars, figures, reactions;
};

/// The components of the forces of holds, such as "held/towing-point/x" [N].
std::vector<NamedScalar> reactions_of(const std::vector<HoldForce>& holds);

/// The numbers at the positions of the solution `there`; nullopt if the solution has no positions, or if the
/// forces cannot be evaluated there.
std::optional<Numbers> numbers_at(const scenes::LoadedScene& loaded, Assembler& assembler, Solution there);

/// The facts of a scene that are known before it is solved.
Result describe_scene(const scenes::LoadedScene& loaded, const Assembler& assembler);

/// Makes the result of a solve: figures, forces and warnings at its last point. The caller adds the origins
/// (files, versions, machine), the reading times and the mesh errors.
Result make_result(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution);

}  // namespace netloft::results
