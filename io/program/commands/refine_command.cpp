// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/numerics.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/studies/compare/refinement.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace netloft::program {

namespace {

/// Divisions of the leading part, which is the first panel or rope. They range from a quarter to twice its
/// number of cells if this number is divisible by four, otherwise from one to four times.
studies::CellList cells_around(const scenes::LoadedScene& loaded) {
  const std::int64_t own = studies::leading_part(loaded).cells[0];
  if (own % 4 == 0) return {"", {own / 4, own / 2, own, 2 * own}};
  return {"", {own, 2 * own, 4 * own}};
}

std::vector<studies::MeshLevel> levels_of_gear(const RefineOptions& options,
                                               const scenes::LoadedScene& loaded) {
  if (!options.cells.empty())
    throw UsageError{"--cells: a gear is divided as a whole; write --nodes 500,2000,8000"};
  if (options.nodes.empty()) return studies::gear_levels(loaded, {500, 2000, 8000, 30000});
  if (options.nodes.size() < 2)
    throw UsageError{"--nodes needs two or more numbers, better four, such as 500,2000,8000,30000"};
  return studies::gear_levels(loaded, options.nodes);
}

std::vector<studies::MeshLevel> wanted_levels(const RefineOptions& options,
                                              const scenes::LoadedScene& loaded) {
  if (loaded.analysis.kind == AnalysisKind::dynamics)
    throw UsageError{
        "refine finds equilibria on several meshes, but this scene is a motion; add --set "
        "analysis.kind=static"};
  if (loaded.gear) return levels_of_gear(options, loaded);
  if (!options.nodes.empty())
    return studies::gear_levels(loaded, options.nodes);  // throws, because there is no gear
  return studies::mesh_levels(
      loaded, options.cells.empty() ? cells_around(loaded) : studies::read_cell_list(options.cells));
}

int run_refinement(const RefineOptions& options) {
  require_memory_to_solve();
  Session session(options);
  if (const int code = session.open(); code != kDone) return code;
  catch_interrupts();
  Watchdog watchdog(session.terminal(),
                    ending_with_a_sentence(session.terminal(), "the refinement ends here without a table"));
  const scenes::LoadedScene& loaded = session.scene().loaded();
  const auto levels = wanted_levels(options, loaded);
  const double tolerance = loaded.analysis.limits.tolerance;
  const runs::Watch watch{
      .interrupt = &interrupt_flag(),
      .on_iteration = [&](const IterationRecord& r) { session.terminal().progress(r, tolerance); },
      .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  studies::Refinement refinement =
      studies::refine(session.scene().source(), session.scene().registry(), levels, watch);
  session.terminal().clear();
  refinement.scene = loaded.scene.name;
  print_line(options.json ? studies::refinement_json(refinement) : studies::refinement_text(refinement));
  if (refinement.is_interrupted)
    return end_interrupted(session.terminal(), fmt::format("the table has {} of {} meshes",
                                                           refinement.meshes.size(), levels.size()));
  return refinement.missing.empty() ? kDone : kNotConverged;
}

}  // namespace

int refine_command(const RefineOptions& options) {
  try {
    return run_refinement(options);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace netloft::program
