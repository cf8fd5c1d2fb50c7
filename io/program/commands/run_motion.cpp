// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/run_kinds.hpp"
#include "io/program/commands/run_output.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/results/motion/motion_run.hpp"

#include <filesystem>

namespace netloft::program {

namespace {

void refuse_options_of_equilibria(const RunOptions& options) {
  if (!options.start_from.empty())
    throw UsageError{"--start-from is for equilibria; --set analysis.start=RESULT.hdf is for motions"};
  if (options.stages)
    throw UsageError{"--stages is for equilibria; analysis.output_interval sets the outputs of a motion"};
  if (options.error)
    throw UsageError{
        "--error is for equilibria; for a motion, run the scene again with other cells and another "
        "`accuracy`, and compare the results by `netloft diff`"};
}

/// Identifies the scene with its changes. A motion can be resumed only with the same identity.
std::string identity_of(const RunOptions& options, const scenes::LoadedScene& loaded) {
  std::string identity = options.solver;
  for (const auto& file : loaded.files) identity += "\n" + file.hash;
  for (const auto& word : options.set) identity += "\n" + word;
  return identity;
}

/// The displacements of a motion that starts from a result; nullopt for other motions.
std::optional<std::vector<double>> start_of_motion(const RunOptions& options, runs::PreparedScene& scene) {
  const auto& file = scene.loaded().analysis.dynamics.start_file;
  if (options.resume || file.empty()) return {};
  return read_start(file.string(), "analysis.start", scene);
}

/// The exit code: a motion that is less accurate than required counts as not converged.
int exit_code(const MarchResult& march) {
  if (march.status == MarchStatus::interrupted) return kInterrupted;
  return march.status == MarchStatus::finished && !march.accuracy.is_missed() ? kDone : kNotConverged;
}

/// Reports the outputs so far after a plugin call that never returns.
int end_early(Terminal& terminal, const std::string& part, const Overdue& overdue) {
  terminal.say("netloft: " + overdue.sentence + "; the run ends here");
  terminal.say(std::filesystem::exists(part)
                   ? "netloft: the outputs so far are in " + part + "; --resume goes on from them"
                   : "netloft: no shape was found until then, so that no result is written");
  return overdue.interrupted ? kInterrupted : kNotConverged;
}

}  // namespace

int run_motion(const RunOptions& options, Session& session, results::RunContext& context) {
  refuse_options_of_equilibria(options);
  runs::PreparedScene& scene = session.scene();
  const scenes::LoadedScene& loaded = scene.loaded();
  Terminal& terminal = session.terminal();
  const std::string output = output_file(options, loaded), part = output + ".part";
  Watchdog watchdog(terminal, [&](const Overdue& overdue) { return end_early(terminal, part, overdue); });
  // Allows twice the limit, because the search for the start may take as long as the motion.
  watchdog.allow(2 * loaded.analysis.limits.seconds);
  if (options.resume && !std::filesystem::exists(part))
    throw UsageError{"--resume: there is no " + part + " to go on from"};
  protect_outputs(options, part);
  const results::MotionOptions how{
      output,
      options.resume,
      start_of_motion(options, scene),
      identity_of(options, loaded),
      &interrupt_flag(),
      [&](const StepRecord& step) { terminal.progress_in_time(step.t, step.end, step.seconds); },
      [&](const std::string& text) { terminal.say("netloft: warning: " + text); },
      [&](const IterationRecord& r) { terminal.progress(r, loaded.analysis.limits.tolerance); }};
  const results::MotionResult motion = results::run_motion(scene, context, how);
  print_result(options, terminal, motion.result);
  return exit_code(motion.march);
}

}  // namespace netloft::program
