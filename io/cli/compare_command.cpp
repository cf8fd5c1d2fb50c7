// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/replaced_file.hpp"
#include "io/cli/session.hpp"
#include "io/cli/watchdog.hpp"
#include "io/compare/report.hpp"
#include "io/files/whole_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace netloft::io {

namespace {

double read_tolerance(const std::string& word, const std::string& all) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end || !(value >= 1e-16 && value <= 1))
    throw UsageError{"--tolerance " + all + ": \"" + word +
                     "\" is no tolerance; write LO:HI with numbers from 1e-16 to 1, such as 1e-10:1e-2"};
  return value;
}

/// A tolerance per decade from the loosest to the tightest.
std::vector<double> read_tolerances(const std::string& range) {
  const auto colon = range.find(':');
  const double low = read_tolerance(range.substr(0, colon), range);
  const double high = colon == std::string::npos ? low : read_tolerance(range.substr(colon + 1), range);
  if (low > high)
    throw UsageError{"--tolerance " + range + " is reversed: the tighter one comes first, as in 1e-10:1e-2"};
  const int steps = static_cast<int>(std::round(std::log10(high / low)));
  std::vector<double> tolerances;
  for (int i = 0; i < steps; ++i) tolerances.push_back(high * std::pow(10.0, -i));
  tolerances.push_back(low);
  return tolerances;
}

std::vector<Method> read_methods(const std::vector<std::string>& words) {
  if (words.empty()) throw UsageError{"--solver or --strategy: name at least one to compare"};
  std::vector<Method> methods;
  for (const auto& word : words) {
    if (std::count(words.begin(), words.end(), word) > 1)
      throw UsageError{word + " is given twice; a method is compared once"};
    methods.push_back({word});
  }
  return methods;
}

ComparisonTask read_task(const CompareOptions& o) {
  ComparisonTask task;
  task.methods = read_methods(o.methods), task.tolerances = read_tolerances(o.tolerance);
  task.repeats = o.repeats, task.reference = o.reference;
  if (!o.cells.empty()) task.cells = read_cell_list(o.cells);
  return task;
}

void check_kind(const LoadedScene& loaded) {
  if (loaded.analysis.kind == AnalysisKind::dynamics)
    throw UsageError{
        "compare measures how solvers find an equilibrium, and this scene goes through time: run it with "
        "kind = "
        "\"static\", or compare two motions with `netloft diff`"};
}

/// Opens the scene once with every method, and on every mesh, so that all that is wrong is said at first.
class Inspection {
 public:
  Inspection(const Options& options, Registry& registry, Terminal& terminal)
      : options_(options), registry_(registry), terminal_(terminal) {}

  int check(const CaseSource& source, const ComparisonTask& task) {
    std::vector<Method> words = task.methods;
    if (!task.reference.empty()) words.push_back({task.reference});
    for (const auto& method : words)
      if (const int code = open(source_for(source, method, task.tolerances.front())); code != kDone)
        return code;
    return task.cells ? check_meshes(source, task) : kDone;
  }

 private:
  int check_meshes(const CaseSource& source, const ComparisonTask& task) {
    Case own(source, registry_);
    own.open();
    for (const auto& level : mesh_levels(own.loaded(), *task.cells)) {
      CaseSource mesh = source_for(source, task.methods.front(), task.tolerances.front());
      mesh.overrides.insert(mesh.overrides.end(), level.overrides.begin(), level.overrides.end());
      if (const int code = open(mesh); code != kDone) return code;
    }
    return kDone;
  }

  int open(const CaseSource& source) {
    Case one(source, registry_);
    const Case::State state = one.open();
    if (state == Case::State::ready) {
      check_kind(one.loaded());
      if (!one.loaded().scene.settings.empty())
        throw UsageError{
            "compare wants a scene in which nothing is left open, and this one looks for a length of "
            "warp; ship.warp.length without ship.warp.tension gives it"};
      for (const std::string& file : {options_.compare.csv, options_.compare.plot})
        require_place(file, paths_of(one.loaded()));
      return kDone;
    }
    return tell_why_not(one.diagnostics(), state, options_, terminal_);
  }

  const Options& options_;
  Registry& registry_;
  Terminal& terminal_;
};

void write_files(const Comparison& result, const CompareOptions& o) {
  if (!o.csv.empty()) write_whole(o.csv, comparison_csv(result));
  if (o.plot.empty()) return;
  const LinePlot plot = comparison_plot(result);
  write_whole(o.plot, o.plot.ends_with(".html") ? draw_html(plot) : draw_svg(plot));
}

/// Files that were asked for are made of a whole comparison alone.
std::string unwritten(const CompareOptions& o) {
  std::string text;
  for (const std::string& file : {o.csv, o.plot})
    if (!file.empty()) text += (text.empty() ? "; not written: " : ", ") + file;
  return text;
}

int run(const Options& options) {
  const ComparisonTask task = read_task(options.compare);
  require_ending("--csv", options.compare.csv, {".csv"});
  require_ending("--plot", options.compare.plot, {".svg", ".html"});
  catch_interrupts();
  Terminal terminal(options.color, options.json);
  Registry registry;
  find_plugins(options, registry);
  Watchdog watchdog(ending_with_a_sentence(terminal, "the comparison ends here without a table"));
  CaseSource source = source_of(options);
  if (options.threads == 0) source.threads = 1;  // so that CPU seconds are seconds
  if (const int code = Inspection(options, registry, terminal).check(source, task); code != kDone)
    return code;
  const double tightest = task.tolerances.back();
  const Watch watch{.interrupt = &interrupt_flag(),
                    .on_iteration = [&](const IterationRecord& r) { terminal.progress(r, tightest); },
                    .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  const Comparison result = compare(source, registry, task, watch);
  terminal.clear();
  std::puts(options.json ? comparison_json(result).c_str() : comparison_text(result).c_str());
  if (result.is_interrupted)
    return end_interrupted(terminal, "the table is of what was done before" + unwritten(options.compare));
  return write_last(terminal, result.any_converged() ? kDone : kNotConverged,
                    [&] { write_files(result, options.compare); });
}

}  // namespace

int compare_command(const Options& options) {
  try {
    return run(options);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace netloft::io
