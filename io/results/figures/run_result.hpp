// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/results/figures/response.hpp"
#include "io/results/figures/rope_tensions.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace netloft::results {

/// Sum of the forces with which one hold acts on the gear [N].
struct HoldForce {
  std::string name;
  std::array<double, 3> force{};
};

struct NamedScalar {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::string name, unit, doc;
  double value = 0;
  double solver_error = kUnknown;  // its change by the next Newton step
  double mesh_error =
      kUnknown;  // bound of the distance from the limit of finer meshes, if that was asked for
  // observed; unknown: there is no order to be believed
  double mesh_order = kUnknown;
  // over all equilibria that were found; unknown: there was one only
  double least = kUnknown, largest = kUnknown;
  // its change for each metre that the furthest node of what swings moves; unknown: nothing swings
  double per_swing = kUnknown;
};

/// Returns null if none has this name.
const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name);

/// Where a stage of the solve ended.
struct StageShape {
  std::string name;       // "coarse: converged"
  std::vector<double> x;  // positions over all dofs
};

/// The record of a run, from which the terminal, JSON and file outputs are written.
struct RunResult {
  Solution solution;
  std::vector<StageShape> stages;  // before the solution; kept if they are asked for
  std::vector<PartForce> part_forces;
  std::vector<HoldForce> hold_forces;
  std::array<double, 3> balance{};  // sum of all forces on the gear, those of the holds included [N]
  double largest_force = 0;         // the largest of the forces that were summed [N]
  std::vector<NamedScalar> scalars;
  std::vector<RopeTensions> ropes;    // of a scene with a net plan
  std::vector<NamedScalar> gear;      // figures of a scene with a net plan (gear_figures.hpp)
  std::vector<LawUse> law_use;        // of laws that were measured in some range
  std::string swings_most;            // the furthest node of what grows there; empty: nothing does
  std::vector<std::string> warnings;  // of parts that bear more than they can, of laws outside their range
  // the meshes behind the mesh errors, or why there are no errors; empty: not asked for
  std::string mesh_note;
  FamilyOutputs outputs;
  double reading_seconds = 0, setup_seconds = 0;
  std::string output_file;
};

/// The figures of a scene's gear at an answer, without errors; none if it has no net plan.
std::vector<NamedScalar> collect_gear(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer);

/// Sums, outputs and named scalars at the solution's last point, with the solver's errors.
void collect(const scenes::LoadedScene& loaded, Assembler& assembler, RunResult& result);

}  // namespace netloft::results
