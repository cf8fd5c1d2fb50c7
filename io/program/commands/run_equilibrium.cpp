// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/run_kinds.hpp"
#include "io/program/commands/run_output.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/file/write_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/studies/compare/mesh_error.hpp"
#include "io/studies/sensitivity/key_sensitivities.hpp"

#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace netloft::program {

namespace {

constexpr std::size_t kMostStages = 60;  // a page with this many states of 2 000 nodes has about 6 MB

int exit_code(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return kDone;
    case SolveStatus::interrupted:
      return kInterrupted;
    default:
      return kNotConverged;
  }
}

void refuse_what_cannot_be(const RunOptions& options, runs::PreparedScene& scene) {
  if (options.resume)
    throw UsageError{"--resume continues motions only; leave it out to find an equilibrium"};
  if (const auto why_not = runs::why_unfit(scene)) throw UsageError{*why_not};
}

/// The meshes with which --error estimates the errors of figures.
std::vector<studies::MeshLevel> levels_for_errors(const RunOptions& options,
                                                  const scenes::LoadedScene& loaded) {
  if (!options.error) return {};
  try {
    return studies::levels_around(loaded);
  } catch (const std::invalid_argument& e) {
    throw UsageError{std::string("--error: ") + e.what()};
  }
}

/// Saves the initial shape, and the shape at the end of each of the first kMostStages stages.
void keep_stages(const Assembler& assembler, std::vector<results::StageShape>& stages, runs::Watch& watch) {
  const auto start = assembler.start();
  stages.push_back({"start", {start.begin(), start.end()}});
  watch.on_stage = [&stages, &assembler](const StageRecord& stage, std::span<const double> u) {
    if (stages.size() >= kMostStages) return;
    std::vector<double> x(assembler.start().begin(), assembler.start().end());
    assembler.place(u, x);
    stages.push_back(
        {(stage.name.empty() ? stage.solver : stage.name) + ": " + name_of(stage.status), std::move(x)});
  };
}

/// One run. It stores the best point so far, which is written if a call of a plugin never returns.
class EquilibriumRun {
 public:
  EquilibriumRun(const RunOptions& options, Session& session, results::RunContext& context)
      : options_(options),
        scene_(session.scene()),
        terminal_(session.terminal()),
        context_(context),
        levels_(levels_for_errors(options, scene_.loaded())),
        file_(output_file(options, scene_.loaded())) {}

  int run(const std::optional<std::vector<double>>& start) {
    Watchdog watchdog(terminal_, [&](const Overdue& overdue) { return end_early(overdue); });
    const auto on_budget = [&](double seconds) { watchdog.allow(seconds); };
    solve(start, on_budget);
    const bool goes_on = options_.error || options_.sensitivities;
    if (!goes_on) begin_writing(watchdog);
    results::Result result = results::make_result(scene_.loaded(), scene_.assembler(), solution_);
    if (options_.error)
      studies::find_mesh_errors(scene_.source(), scene_.registry(), scene_, solution_, levels_,
                                {.interrupt = &interrupt_flag(), .on_budget = on_budget}, result);
    if (options_.sensitivities) find_sensitivities(watchdog, result);
    if (goes_on) begin_writing(watchdog);
    context_.plugins = scene_.registry().opened();
    finish(scene_.assembler(), std::move(result), [&] { watchdog.end_writing(); });
    return goes_on && interrupt_flag() ? kInterrupted : exit_code(solution_.status);
  }

 private:
  void solve(const std::optional<std::vector<double>>& start, const std::function<void(double)>& on_budget) {
    const double tolerance = scene_.loaded().analysis.limits.tolerance;
    runs::Watch watch{.interrupt = &interrupt_flag(),
                      .on_iteration = [&](const IterationRecord& r) { terminal_.progress(r, tolerance); },
                      .kept = &kept_,
                      .on_budget = on_budget};
    if (options_.stages) keep_stages(scene_.assembler(), stages_, watch);
    solution_ =
        start ? runs::find_equilibrium_near(scene_, *start, watch) : runs::find_equilibrium(scene_, watch);
  }

  void find_sensitivities(Watchdog& watchdog, results::Result& result) {
    watchdog.allow(std::numeric_limits<double>::infinity());  // the limit of the scene is for solves
    const auto show = [&](std::size_t done, std::size_t all, const std::string& path) {
      terminal_.progress_in_steps("numbers", done, all, path);
    };
    studies::find_key_sensitivities(scene_, solution_, &interrupt_flag(), show, result);
  }

  void begin_writing(Watchdog& watchdog) {
    watchdog.begin_writing([part = (*file_).part_path()] {
      std::error_code none;
      std::filesystem::remove(part, none);
    });
  }

  /// Adds to the result what the solution does not contain, writes the result and prints it. `on_written` is
  /// called before the file gets its final name.
  void finish(Assembler& assembler, results::Result result, const std::function<void()>& on_written) {
    result.origins = results::make_origins(scene_.loaded(), context_);
    result.origins.finished = results::utc_now();
    result.reading_seconds = scene_.seconds().reading;
    result.setup_seconds = scene_.seconds().setup;
    result.states = stages_.size() + 1;
    result.path = name_by_outcome(*file_, solution_, terminal_);
    results::write_result(*file_, scene_.loaded(), assembler, {solution_, stages_}, result);
    on_written();
    (*file_).finish_as(result.path);
    print_result(options_, terminal_, result);
  }

  /// Writes the best accepted point after a plugin call that never returns. Uses a new assembler, because the
  /// unfinished call still uses the assembler of the scene.
  int end_early(const Overdue& overdue) {
    const int code = overdue.interrupted ? kInterrupted : kNotConverged;
    terminal_.say("netloft: " + overdue.sentence + "; the run ends here");
    if (kept_.u.empty()) {
      terminal_.say("netloft: no shape was found until then, so that no result is written");
      (*file_).discard();
      return code;
    }
    Assembler assembler(scene_.loaded().scene, scene_.plan(), 1);
    Solution& s = solution_ = runs::assess_point(scene_, kept_.u, assembler);
    s.status = overdue.interrupted ? SolveStatus::interrupted : SolveStatus::not_converged;
    s.reason = overdue.sentence + "; the result has the best shape found until then";
    finish(assembler, results::make_result(scene_.loaded(), assembler, s), [] {});
    return code;
  }

  const RunOptions& options_;
  runs::PreparedScene& scene_;
  Terminal& terminal_;
  results::RunContext& context_;
  std::vector<studies::MeshLevel> levels_;
  OutputFile file_;
  Solution solution_;
  std::vector<results::StageShape> stages_;
  KeptPoint kept_;
};

}  // namespace

int run_equilibrium(const RunOptions& options, Session& session, results::RunContext& context) {
  runs::PreparedScene& scene = session.scene();
  refuse_what_cannot_be(options, scene);
  std::optional<std::vector<double>> start;
  if (!options.start_from.empty()) start = read_start(options.start_from, "--start-from", scene);
  protect_outputs(options, output_file(options, scene.loaded()) + ".part");
  return EquilibriumRun(options, session, context).run(start);
}

}  // namespace netloft::program
