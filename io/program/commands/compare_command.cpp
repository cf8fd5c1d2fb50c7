// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/nearest.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/numerics.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/studies/compare/report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netloft::program {

namespace {

/// An option whose value is a range of powers of ten: --tolerance or --accuracy.
struct Decades {
  std::string option, what, example;
};
const Decades kTolerances{"--tolerance", "tolerance", "1e-10:1e-2"};
const Decades kAccuracies{"--accuracy", "accuracy", "1e-3:1e-1"};

double read_one(const std::string& word, const std::string& all, const Decades& d) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end || !(value >= 1e-16 && value <= 1))
    throw UsageError{d.option + " " + all + ": \"" + word + "\" is no " + d.what +
                     "; write LO:HI with numbers from 1e-16 to 1, such as " + d.example};
  return value;
}

/// One value per power of ten, from the loosest to the tightest.
std::vector<double> read_decades(const std::string& range, const Decades& d) {
  const auto colon = range.find(':');
  const double low = read_one(range.substr(0, colon), range, d);
  const double high = colon == std::string::npos ? low : read_one(range.substr(colon + 1), range, d);
  if (low > high)
    throw UsageError{d.option + " " + range + " is reversed: the smaller number comes first, as in " +
                     d.example};
  const int steps = static_cast<int>(std::round(std::log10(high / low)));
  std::vector<double> tolerances;
  for (int i = 0; i < steps; ++i) tolerances.push_back(high * std::pow(10.0, -i));
  tolerances.push_back(low);
  return tolerances;
}

std::vector<studies::Method> read_methods(const std::vector<std::string>& words) {
  if (words.empty()) throw UsageError{"--solver, --strategy or --integrator: name at least one to compare"};
  std::vector<studies::Method> methods;
  for (const auto& word : words) {
    if (std::count(words.begin(), words.end(), word) > 1)
      throw UsageError{word + " is given twice; a method is compared once"};
    methods.push_back({word});
  }
  return methods;
}

/// Whether the methods are integrators. Throws UsageError for a mixture with solvers or strategies, because
/// motions and equilibria have no common table.
bool compares_motions(const std::vector<studies::Method>& methods) {
  const auto integrators = std::count_if(methods.begin(), methods.end(),
                                         [](const studies::Method& m) { return m.kind() == "integrator"; });
  if (integrators != 0 && integrators != static_cast<std::ptrdiff_t>(methods.size()))
    throw UsageError{
        "--integrator compares motions, --solver and --strategy compare equilibria; give one kind only"};
  return integrators > 0;
}

studies::ComparisonTask read_task(const CompareOptions& o) {
  studies::ComparisonTask task;
  task.methods = read_methods(o.methods);
  task.is_of_motions = compares_motions(task.methods);
  task.tolerances = task.is_of_motions
                        ? read_decades(o.accuracy.empty() ? kAccuracies.example : o.accuracy, kAccuracies)
                        : read_decades(o.tolerance, kTolerances);
  task.repeats = o.repeats;
  task.reference = o.reference;
  if (task.is_of_motions && !o.cells.empty())
    throw UsageError{"--cells gives the meshes of equilibria; motions are compared on one mesh"};
  if (!task.is_of_motions && !o.accuracy.empty())
    throw UsageError{"--accuracy is that of motions; solvers and strategies take --tolerance"};
  if (!o.cells.empty()) task.cells = studies::read_cell_list(o.cells);
  return task;
}

void check_kind(const scenes::LoadedScene& loaded, bool is_of_motions) {
  const bool moves = loaded.analysis.kind == AnalysisKind::dynamics;
  if (moves && !is_of_motions)
    throw UsageError{
        "--solver and --strategy find an equilibrium, but this scene is a motion: compare --integrator, or "
        "set analysis.kind = \"static\""};
  if (!moves && is_of_motions)
    throw UsageError{"--integrator is for motions, but this scene is static: compare --solver or --strategy"};
  if (is_of_motions && !loaded.analysis.dynamics.start_file.empty())
    throw UsageError{
        "compare begins motions at the start of the scene, but analysis.start names a result; leave it out"};
}

/// Prepares the scene with every method and on every mesh before the first trial, so that all errors are
/// reported at the start.
class Inspection {
 public:
  Inspection(const CompareOptions& options, Registry& registry, Terminal& terminal)
      : options_(options), registry_(registry), terminal_(terminal) {}

  int check(const runs::CaseSource& source, studies::ComparisonTask& task) {
    is_of_motions_ = task.is_of_motions;
    if (is_of_motions_) set_absent(task);
    std::vector<studies::Method> words;
    for (const studies::Method& method : task.methods)
      if (!task.absent.contains(method.specification)) words.push_back(method);
    if (!task.reference.empty()) words.push_back({(is_of_motions_ ? "integrator " : "") + task.reference});
    for (const auto& method : words)
      if (const int code = open(studies::source_for(source, method, task.tolerances.front())); code != kDone)
        return code;
    return task.cells ? check_meshes(source, task) : kDone;
  }

 private:
  /// Marks integrators whose plugin is not installed, so that their rows in the table state this reason. A
  /// name that is similar to the name of a plugin is still an error, and so is a comparison without any
  /// installed integrator.
  void set_absent(studies::ComparisonTask& task) {
    const std::vector<std::string> there = registry_.available();
    for (const studies::Method& method : task.methods) {
      const std::string plugin = studies::plugin_of(method);
      if (std::ranges::find(there, plugin) == there.end() && !nearest(plugin, there))
        task.absent[method.specification] = "there is no plugin \"" + plugin + "\" here";
    }
    if (task.absent.size() == task.methods.size()) task.absent.clear();
  }

  int check_meshes(const runs::CaseSource& source, const studies::ComparisonTask& task) {
    runs::PreparedScene own(source, registry_);
    own.prepare();
    for (const auto& level : studies::mesh_levels(own.loaded(), *task.cells)) {
      runs::CaseSource mesh = studies::source_for(source, task.methods.front(), task.tolerances.front());
      formats::append(mesh.changes, level.changes);
      if (const int code = open(mesh); code != kDone) return code;
    }
    return kDone;
  }

  int open(const runs::CaseSource& source) {
    runs::PreparedScene one(source, registry_);
    const runs::PreparedScene::State state = one.prepare();
    if (state == runs::PreparedScene::State::ready) {
      check_kind(one.loaded(), is_of_motions_);
      if (!one.loaded().scene.settings.empty())
        throw UsageError{
            "compare needs known lengths of warp, but this scene finds them by ship.warp.tension; give "
            "ship.warp.length alone"};
      for (const std::string& file : options_.outputs) require_place(file, paths_of(one.loaded()));
      return kDone;
    }
    return report_unready(one.diagnostics(), state, terminal_);
  }

  const CompareOptions& options_;
  Registry& registry_;
  Terminal& terminal_;
  bool is_of_motions_ = false;
};

/// The content of an output file, in the format that its ending names.
std::string content_of(const std::string& file, const studies::Comparison& result) {
  if (file.ends_with(".csv")) return studies::comparison_csv(result);
  const formats::LinePlot plot = studies::comparison_plot(result);
  return file.ends_with(".html") ? formats::draw_html(plot) : formats::draw_svg(plot);
}

void write_files(const studies::Comparison& result, const CompareOptions& o) {
  for (const std::string& file : o.outputs) formats::write_keeping(file, content_of(file, result));
}

/// The files that were requested but are not written, because the comparison was interrupted.
std::string unwritten(const CompareOptions& o) {
  std::string text;
  for (const std::string& file : o.outputs) text += (text.empty() ? "; not written: " : ", ") + file;
  return text;
}

int run_comparison(const CompareOptions& options) {
  require_memory_to_solve();
  studies::ComparisonTask task = read_task(options);
  for (const std::string& file : options.outputs) require_ending("-o", file, {".svg", ".html", ".csv"});
  Terminal terminal(options);
  Registry registry;
  find_scene_plugins(options, registry);
  runs::CaseSource source = source_of(options);
  if (options.threads == 0) source.threads = 1;  // one thread, so that CPU seconds equal seconds of wall time
  if (const int code = Inspection(options, registry, terminal).check(source, task); code != kDone)
    return code;
  catch_interrupts();
  Watchdog watchdog(terminal, ending_with_a_sentence(terminal, "the comparison ends here without a table"));
  const double tightest = task.tolerances.back();
  const runs::Watch watch{.interrupt = &interrupt_flag(),
                          .on_iteration = [&](const IterationRecord& r) { terminal.progress(r, tightest); },
                          .on_step =
                              [&](const StepRecord& step, const std::string& run) {
                                terminal.progress_in_time(step.t, step.end, step.seconds, run);
                              },
                          .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  const studies::Comparison result = studies::compare(source, registry, task, watch);
  terminal.clear();
  print_line(options.json ? studies::comparison_json(result) : studies::comparison_text(result));
  if (result.is_interrupted)
    return end_interrupted(terminal, "the table has the solves that were finished" + unwritten(options));
  const bool is_well = result.any_converged() && !result.any_failed();
  return write_last(terminal, is_well ? kDone : kNotConverged, [&] { write_files(result, options); });
}

}  // namespace

int compare_command(const CompareOptions& options) {
  try {
    return run_comparison(options);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace netloft::program
