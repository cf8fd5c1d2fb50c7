// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/read.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/file/start_from.hpp"
#include "io/results/file/write_result.hpp"
#include "io/results/motion/motion_report.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/memory_forecast.hpp"
#include "io/studies/compare/mesh_error.hpp"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace netloft::program {

namespace {

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

/// The result file of a run; never one of the files that the scene was read from.
std::string output_file(const Options& options, const scenes::LoadedScene& loaded) {
  const std::string name = options.output.empty() ? loaded.scene.name + ".hdf" : options.output;
  std::error_code missing;
  for (const auto& file : loaded.files)
    if (std::filesystem::equivalent(name, file.path, missing))
      throw UsageError{"the result cannot be written to " + name +
                       ": the scene is read from it; name another file with -o"};
  return name;
}

/// HDF5 files of that name are of equilibria, which are written once they are found; but earlier versions
/// wrote motions so, too.
bool is_worthless_hdf5(const std::string& part) {
  formats::silence_hdf5();
  if (H5Fis_hdf5(part.c_str()) <= 0) return false;
  try {
    return !formats::Reader(part).has("/netloft/checkpoint");
  } catch (const formats::FileError&) {
    return true;
  }
}

/// Outputs of a motion that was killed are replaced only by who says so.
void spare_outputs(const Options& options, const std::string& part) {
  std::error_code none;
  if (options.resume || options.overwrite || !std::filesystem::is_regular_file(part, none) ||
      std::filesystem::file_size(part, none) == 0)
    return;
  formats::require_no_writer(part);
  const std::string cure = "; --overwrite replaces it, -o writes elsewhere";
  try {
    if (is_worthless_hdf5(part)) return;
    if (const auto left = formats::SeriesJournal::read(part); left.size() > 0)
      throw UsageError{part + " holds " + std::to_string(left.size()) +
                       " outputs of a run that did not end; --resume goes on from them" + cure};
  } catch (const formats::FileError& e) {
    throw UsageError{std::string(e.what()) + ". A run that did not end left it" + cure};
  }
}

/// The result is named by its outcome, and who reads the terminal learns of it.
std::string named_by_outcome(const formats::ResultFile& file, const Solution& solution, Terminal& terminal) {
  const auto wanted = file.final_path();
  const auto name = results::name_beside_better(wanted, name_of(solution.status));
  if (name != wanted)
    terminal.say("netloft: " + wanted.string() + " holds a better result and stays; this one is " +
                 name_of(solution.status) + " and goes to " + name.string());
  return name.string();
}

/// The file of a static run: what ends without a result leaves none.
class FileOfRun {
 public:
  explicit FileOfRun(const std::string& name) : file_(name) {}
  FileOfRun(const FileOfRun&) = delete;
  FileOfRun& operator=(const FileOfRun&) = delete;
  ~FileOfRun() { file_.discard(); }
  formats::ResultFile& operator*() { return file_; }

 private:
  formats::ResultFile file_;
};

/// Meshes that the errors of results are found from; none if they are not asked for.
std::vector<studies::MeshLevel> levels_for_errors(const Options& options, const scenes::LoadedScene& loaded) {
  if (!options.error) return {};
  try {
    return studies::levels_around(loaded);
  } catch (const std::invalid_argument& e) {
    throw UsageError{std::string("--error: ") + e.what()};
  }
}

}  // namespace

namespace {

/// The scene as it was read and changed: a motion goes on only as the same.
std::string identity_of(const Options& options, const scenes::LoadedScene& loaded) {
  std::string identity = options.solver;
  for (const auto& file : loaded.files) identity += "\n" + file.hash;
  for (const auto& word : options.set) identity += "\n" + word;
  return identity;
}

/// A path that is not known as well as was asked for is no answer.
int exit_code(const MarchResult& march) {
  if (march.status == MarchStatus::interrupted) return kInterrupted;
  return march.status == MarchStatus::finished && !march.accuracy.is_missed() ? kDone : kNotConverged;
}

/// Displacements that bring the gear to where the result in `file` has it, of which `key` speaks.
std::vector<double> read_start(const std::string& file, const char* key, Session& session) {
  try {
    const results::StoredResult result(file);
    return session.assembler().displacements(results::positions_from(result, session.loaded()));
  } catch (const formats::FileError& e) {
    throw UsageError{std::string(key) + ": " + e.what()};
  }
}

/// Where a motion begins, if that is a result.
std::optional<std::vector<double>> start_of_motion(const Options& options, Session& session) {
  const auto& file = session.loaded().analysis.dynamics.start_file;
  if (options.resume || file.empty()) return {};
  return read_start(file.string(), "analysis.start", session);
}

int run_in_time(const Options& options, Session& session, const results::RunContext& context) {
  const std::string part = output_file(options, session.loaded()) + ".part";
  if (options.resume && !std::filesystem::exists(part))
    throw UsageError{"--resume: there is no " + part + " to go on from"};
  spare_outputs(options, part);
  const results::MotionOptions how{
      output_file(options, session.loaded()),
      options.resume,
      start_of_motion(options, session),
      identity_of(options, session.loaded()),
      &interrupt_flag(),
      [&](const StepRecord& step) { session.terminal().progress_in_time(step.t, step.end, step.seconds); },
      [&](const std::string& text) { session.terminal().say("netloft: warning: " + text); },
      [&](const IterationRecord& r) {
        session.terminal().progress(r, session.loaded().analysis.limits.tolerance);
      }};
  const results::MotionResult result = results::run_motion(session.scene(), context, how);
  session.terminal().clear();
  std::puts(options.json ? results::motion_json(session.loaded(), session.plan(), result).c_str()
                         : results::motion_text(session.loaded(), session.plan(), result).c_str());
  return exit_code(result.march);
}

}  // namespace

namespace {

/// What a run has to show so far, for an end that is not its own.
struct RunSoFar {
  const Options& options;
  results::RunContext& context;
  Session& session;
  results::RunResult& result;
  KeptPoint kept;
  FileOfRun* file = nullptr;                      // once there is one
  std::optional<std::vector<double>> start = {};  // displacements where the search begins
  std::string part;                               // of a motion
};

void print_result(const Options& options, Session& session, const results::RunResult& result) {
  session.terminal().clear();
  std::puts(options.json ? results::run_json(session.loaded(), session.plan(), result).c_str()
                         : results::run_text(session.loaded(), session.plan(), result).c_str());
}

/// Where there is no point that could be written.
void say_what_is_left(RunSoFar& run) {
  const bool is_motion = !run.part.empty() && std::filesystem::exists(run.part);
  run.session.terminal().say(is_motion ? "netloft: the outputs so far are in " + run.part +
                                             "; --resume goes on from them"
                                       : "netloft: nothing was found before, and no result is written");
  if (run.file) (**run.file).discard();
}

/// Writes the best point that was accepted before a plugin did not come back.
int keep_what_was_found(RunSoFar& run, const Overdue& overdue) {
  const int code = overdue.interrupted ? kInterrupted : kNotConverged;
  run.session.terminal().say("netloft: " + overdue.sentence + "; the run ends here");
  if (!run.file || run.kept.u.empty()) return say_what_is_left(run), code;
  Assembler assembler(run.session.loaded().scene, run.session.plan(), 1);
  Solution& s = run.result.solution = runs::assess_point(run.session.scene(), run.kept.u, assembler);
  s.status = overdue.interrupted ? SolveStatus::interrupted : SolveStatus::not_converged;
  s.reason = overdue.sentence + "; this is the last that was found before";
  results::collect(run.session.loaded(), assembler, run.result);
  run.result.output_file = named_by_outcome(**run.file, s, run.session.terminal());
  results::write_result(**run.file, run.session.loaded(), assembler, run.result, run.context);
  print_result(run.options, run.session, run.result);
  return code;
}

constexpr std::size_t kMostStages = 60;  // a page with as many states of 2 000 nodes has some 6 MB

/// Keeps the start, and the shape in which each stage ended; stages beyond the first kMostStages are left
/// out.
void keep_stages(Session& session, std::vector<results::StageShape>& stages, runs::Watch& watch) {
  const auto& assembler = session.assembler();
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

void solve(Session& session, Watchdog& watchdog, RunSoFar& run) {
  const double tolerance = session.loaded().analysis.limits.tolerance;
  run.result.reading_seconds = session.scene().seconds().reading;
  run.result.setup_seconds = session.scene().seconds().setup;
  runs::Watch watch{
      .interrupt = &interrupt_flag(),
      .on_iteration = [&](const IterationRecord& r) { session.terminal().progress(r, tolerance); },
      .kept = &run.kept,
      .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  if (run.options.stages) keep_stages(session, run.result.stages, watch);
  run.result.solution = run.start ? runs::find_equilibrium_near(session.scene(), *run.start, watch)
                                  : runs::find_equilibrium(session.scene(), watch);
}

}  // namespace

namespace {

void refuse_for_motions(const Options& options) {
  if (!options.start_from.empty())
    throw UsageError{"--start-from is for equilibria; --set analysis.start=RESULT.hdf is for motions"};
  if (options.stages)
    throw UsageError{"--stages is for equilibria; output_interval says when a motion is kept"};
  if (options.error)
    throw UsageError{
        "--error is for equilibria; of a motion, compare runs with other cells and `accuracy` by `netloft "
        "diff`"};
}

// Gears of as many unknowns take less than 300 MiB, and ordering their matrix twice would take a hundredth of
// their time.
constexpr std::int32_t kFewUnknowns = 20000;

/// Where a run takes much of the memory there is; one that takes more is refused.
void say_memory(Session& session) {
  if (session.assembler().pattern().size < kFewUnknowns) return;
  const std::string note = note_of_memory(runs::foresee_memory(session.scene()), runs::memory_within_reach());
  if (!note.empty()) session.terminal().say("netloft: " + note);
}

}  // namespace

int run_command(const Options& options) {
  results::RunContext context{options.words, results::utc_now(), {}, ""};
  end_on_interrupts(options.json);
  Session session(options);
  results::RunResult result;
  RunSoFar so_far{options, context, session, result, {}, nullptr, {}, ""};
  Watchdog watchdog([&](const Overdue& overdue) { return keep_what_was_found(so_far, overdue); });
  if (const int code = session.open(); code != kDone) return code;
  catch_interrupts();
  context.plugins = session.registry().opened();
  context.plan_text = results::plan_text(session.plan(), session.plan_extras());
  say_memory(session);
  if (session.loaded().analysis.kind == AnalysisKind::dynamics) {
    refuse_for_motions(options);
    so_far.part = output_file(options, session.loaded()) + ".part";
    watchdog.allow(2 * session.loaded().analysis.limits.seconds);  // the start may take as long as the motion
    return run_in_time(options, session, context);
  }
  if (options.resume)
    throw UsageError{"--resume goes on with motions; an equilibrium is found from its start"};

  if (const auto why_not = runs::why_unfit(session.scene())) throw UsageError{*why_not};
  if (!options.start_from.empty()) so_far.start = read_start(options.start_from, "--start-from", session);
  const auto levels = levels_for_errors(options, session.loaded());
  spare_outputs(options, output_file(options, session.loaded()) + ".part");
  FileOfRun file(output_file(options, session.loaded()));
  so_far.file = &file;
  solve(session, watchdog, so_far);
  results::collect(session.loaded(), session.assembler(), result);
  if (options.error)
    studies::find_mesh_errors(
        source_of(options), session.registry(), session.scene(), levels,
        {.interrupt = &interrupt_flag(), .on_budget = [&](double seconds) { watchdog.allow(seconds); }},
        result);
  context.plugins = session.registry().opened();
  result.output_file = named_by_outcome(*file, result.solution, session.terminal());
  results::write_result(*file, session.loaded(), session.assembler(), result, context);
  print_result(options, session, result);
  return options.error && interrupt_flag() ? kInterrupted : exit_code(result.solution.status);
}

int plan_command(const Options& options) {
  Session session(options);
  if (const int code = session.open(); code != kDone) return code;
  results::PlanExtras extras = session.plan_extras();
  const runs::MemoryForecast memory = runs::foresee_memory(session.scene());
  extras.memory = memory.total();
  extras.factor_memory = memory.factor;
  extras.stability_memory = memory.stability;
  std::puts(options.json ? results::plan_json(session.loaded().scene, session.plan(), extras).c_str()
                         : (results::plan_text(session.plan(), extras) +
                            memory_text(memory, runs::memory_within_reach()))
                               .c_str());
  return kDone;
}

}  // namespace netloft::program
