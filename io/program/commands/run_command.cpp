// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/run_kinds.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/file/start_from.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"

namespace netloft::program {

namespace {

// Gears with fewer unknowns get no forecast of memory: they use less than 300 MiB, and a forecast orders the
// matrix once more, which takes a hundredth of the run time.
constexpr std::int32_t kFewUnknowns = 20000;

/// If a run needs much of the available memory, reports the forecast. Throws if the run needs more than is
/// available.
void check_memory(Session& session) {
  if (session.scene().assembler().pattern().size < kFewUnknowns) return;
  const std::string note = note_of_memory(runs::foresee_memory(session.scene()), runs::memory_within_reach());
  if (!note.empty()) session.terminal().say("netloft: " + note);
}

}  // namespace

std::vector<double> read_start(const std::string& file, const char* key, runs::PreparedScene& scene) {
  try {
    const results::StoredShape shape(file);
    return scene.assembler().displacements(results::positions_from(shape, scene.loaded()));
  } catch (const formats::FileError& e) {
    throw UsageError{std::string(key) + ": " + e.what()};
  }
}

int run_command(const RunOptions& options) {
  require_memory_to_solve();
  results::RunContext context{options.words, results::utc_now(), {}, ""};
  Session session(options);
  if (const int code = session.open(); code != kDone) return code;
  runs::PreparedScene& scene = session.scene();
  if (options.sensitivities)
    if (const auto why_not = studies::why_no_derivatives(scene.loaded()))
      throw UsageError{"--sensitivities: " + *why_not};
  context.plugins = scene.registry().opened();
  context.plan_text = results::plan_text(scene.plan(), plan_extras(scene));
  check_memory(session);
  catch_interrupts();
  const bool moves = scene.loaded().analysis.kind == AnalysisKind::dynamics;
  return moves ? run_motion(options, session, context) : run_equilibrium(options, session, context);
}

}  // namespace netloft::program
