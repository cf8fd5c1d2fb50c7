// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/scales.hpp"
#include "framework/judging/correction.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/run_kinds.hpp"
#include "io/program/commands/study_shared.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/recorded_scene.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"
#include "io/studies/sweep/branch.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <stdexcept>

namespace netloft::program {

namespace {

/// Ends the command with a sentence if there is no equilibrium with derivatives.
int end_without_equilibrium(const SensitivityOptions& o, Terminal& terminal, const Solution& solution,
                            const std::string& why_not) {
  terminal.clear();
  if (o.json) print_line(studies::sensitivity_json({}, {}, name_of(solution.status)));
  terminal.say(why_not);
  return solution.status == SolveStatus::interrupted ? kInterrupted : kNotConverged;
}

/// Says if an equilibrium is elsewhere than at displacements `u`, which a result has: a plugin or the program
/// is then not that of the result, or --set has changed the scene.
void say_if_moved(runs::PreparedScene& scene, const std::string& result, const std::vector<double>& u,
                  const Solution& found, Terminal& terminal) {
  if (found.status != SolveStatus::converged) return;
  Assembler& assembler = scene.assembler();
  std::vector<double> x(assembler.start().begin(), assembler.start().end());
  assembler.place(u, x);
  const double moved = largest_node_distance(scene.loaded().scene, assembler.numbering(), found.x, x);
  if (moved <= studies::BranchOptions{}.noticed * Scales(assembler).gear_size()) return;
  terminal.say(fmt::format("the equilibrium is up to {:.3g} m from the shape in {}", moved, result));
}

/// Finds the equilibrium of the scene, near the shape in the file `result` if there is one.
Solution solve(runs::PreparedScene& scene, const std::string& result, Terminal& terminal,
               Watchdog& watchdog) {
  const double tolerance = scene.loaded().analysis.limits.tolerance;
  const runs::Watch watch{.interrupt = &interrupt_flag(),
                          .on_iteration = [&](const IterationRecord& r) { terminal.progress(r, tolerance); },
                          .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  std::vector<double> u;
  if (!result.empty()) u = read_start(result, "SCENE", scene);
  Solution solution =
      u.empty() ? runs::find_equilibrium(scene, watch) : runs::find_equilibrium_near(scene, u, watch);
  if (!u.empty()) say_if_moved(scene, result, u, solution, terminal);
  watchdog.allow(std::numeric_limits<double>::infinity());  // the limit of the scene is for its solve
  return solution;
}

/// Prints the effects, and draws or writes them.
int end_with(const SensitivityOptions& o, Terminal& terminal, const results::Result& result,
             const studies::Sensitivities& found, std::size_t numbers) {
  const auto figures = studies::chosen_figures(result, o.of);
  const std::string status = found.is_interrupted ? "interrupted" : result.outcome;
  print(o.json ? studies::sensitivity_json(found, figures, status) + "\n"
               : fmt::format("{}: {}, {} equilibrium; numbers that were examined: {}\n", result.title,
                             result.outcome, result.stability, found.effects.size()) +
                     studies::sensitivity_text(found, figures));
  if (found.is_interrupted)
    return end_interrupted(terminal,
                           fmt::format("{} of {} numbers were examined{}", found.effects.size(), numbers,
                                       o.output.empty() ? "" : ", and " + o.output + " is not written"));
  return write_last(terminal, kDone, [&] {
    if (o.output.ends_with(".svg"))
      write_bars(o.output, studies::sensitivity_bars(found, figures), "--of");
    else if (!o.output.empty())
      formats::write_keeping(o.output, studies::sensitivity_hdf(found, figures, status));
  });
}

/// Prepares the scene and refuses scenes that have no derivatives. Returns an exit code.
int open(Session& session, const SensitivityOptions& o, const std::optional<RecordedScene>& recorded) {
  if (const int code = session.open(); code != kDone) return code;
  const scenes::LoadedScene& loaded = session.scene().loaded();
  if (const auto why_not = studies::why_no_derivatives(loaded)) throw UsageError{*why_not};
  std::vector<std::string> sources = paths_of(loaded);
  if (recorded) {
    refuse_changed_files(*recorded, loaded);
    sources.push_back(o.scene);
  }
  require_place(o.output, sources);
  return kDone;
}

int run_sensitivity(const SensitivityOptions& o) {
  require_ending("-o", o.output, {".svg", ".hdf"});
  require_memory_to_solve();
  std::optional<RecordedScene> recorded;
  if (names_result(o)) recorded = recorded_scene(o);
  const MethodOptions& options = recorded ? recorded->options : static_cast<const MethodOptions&>(o);
  Session session(options, recorded ? recorded->source : source_of(options));
  if (const int code = open(session, o, recorded); code != kDone) return code;
  runs::PreparedScene& scene = session.scene();
  const auto numbers = studies::chosen_numbers(scene, o.to);
  catch_interrupts();
  Terminal& terminal = session.terminal();
  Watchdog watchdog(terminal, ending_with_a_sentence(terminal, "there are no derivatives yet"));
  const Solution solution = solve(scene, recorded ? o.scene : "", terminal, watchdog);
  if (const auto why_not = studies::why_no_derivatives(solution))
    return end_without_equilibrium(o, terminal, solution, *why_not);
  const results::Result result = results::make_result(scene.loaded(), scene.assembler(), solution);
  studies::chosen_figures(result, o.of);  // refuses unknown names now, before the work begins
  const auto show = [&](std::size_t done, const std::string& path) {
    terminal.progress_in_steps("numbers", done, numbers.size(), path);
  };
  const studies::Sensitivities found = studies::find_sensitivities(scene, solution,
                                                                   {.figures = studies::all_figures(result),
                                                                    .numbers = numbers,
                                                                    .with_long_step = o.check,
                                                                    .interrupt = &interrupt_flag(),
                                                                    .on_number = show,
                                                                    .with_reach = true});
  terminal.clear();
  return end_with(o, terminal, result, found, numbers.size());
}

}  // namespace

int sensitivity_command(const SensitivityOptions& options) {
  try {
    return run_sensitivity(options);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace netloft::program
