// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/command.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/terminal.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/scenes/reading/analysis.hpp"
#include "tests/stability/suite/matrix.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;
using namespace runs;
using namespace program;

namespace {

/// The columns that --strategy and --solver name, or those of the suite if the options name none.
std::vector<Column> named_columns(const Suite& suite, const SuiteOptions& options) {
  std::vector<Column> columns;
  for (const auto& strategy : options.strategies) columns.push_back({"", strategy});
  for (const auto& solver : options.solvers) columns.push_back(column_of(solver));
  return columns.empty() ? suite.columns : columns;
}

/// The settings that the suite has for a solver of this name.
std::vector<std::string> overrides_in(const Suite& suite, const std::string& solver) {
  const auto same = std::find_if(suite.columns.begin(), suite.columns.end(), [&](const auto& column) {
    return component_of(column.solver) == component_of(solver);
  });
  return solver.empty() || same == suite.columns.end() ? std::vector<std::string>{} : same->overrides;
}

std::vector<Column> wanted_columns(const Suite& suite, const SuiteOptions& o) {
  auto columns = named_columns(suite, o);
  for (auto& column : columns) {
    if (!o.solvers.empty()) column.overrides = overrides_in(suite, column.solver);
    leave_out(o.without, column);
    column.overrides.insert(column.overrides.end(), o.set.begin(), o.set.end());
  }
  return columns;
}

bool is_asked_for(const SuiteOptions& o) { return !o.solvers.empty() || !o.strategies.empty(); }

/// Whether the components of a column exist. Throws UsageError if the column cannot be understood. If a
/// component does not exist and the user has `asked_for` the column, the exception of the registry is passed
/// on.
bool is_there(const Column& column, Registry& registry, bool asked_for) {
  try {
    overrides_of(column);
    const std::string solver = component_of(column.solver);
    if (!solver.empty() && !scenes::is_integrator(registry, solver)) registry.solver(solver);
    if (!column.strategy.empty()) registry.strategy(component_of(column.strategy));
    return true;
  } catch (const std::invalid_argument& e) {
    throw program::UsageError{e.what()};
  } catch (const PluginRefused& e) {
    if (asked_for) throw;
    return false;
  }
}

std::vector<Column> find_columns(const Suite& suite, const SuiteOptions& options, Registry& registry,
                                 program::Terminal& terminal) {
  std::vector<Column> columns;
  for (auto& column : wanted_columns(suite, options)) {
    if (is_there(column, registry, is_asked_for(options)))
      columns.push_back(std::move(column));
    else
      terminal.say("there is no " + column.head() + ": left out");
  }
  if (columns.empty())
    throw program::UsageError{
        "this program has none of the solvers of the suite; name one with --solver or --strategy"};
  return columns;
}

/// Prints the matrix and writes the page, unless the suite was interrupted. Returns `code`, or kOther if the
/// page cannot be written.
int print_matrix(const MatrixTitle& title, const SuiteOptions& options, const std::vector<Row>& rows,
                 program::Terminal& terminal, int code) {
  print_line(options.json ? matrix_json(title, rows) : matrix_text(title, rows));
  const std::string& page = options.output;
  if (page.empty() || code == program::kInterrupted) return code;
  return program::write_last(terminal, code, [&] { formats::write_keeping(page, matrix_html(title, rows)); });
}

/// Whether the first column solved all cases correctly.
bool first_is_right(const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(),
                     [](const Row& row) { return is_right(row.cells.front().verdict.where); });
}

/// Writes the incomplete matrix if a plugin does not return.
class MatrixSoFar {
 public:
  MatrixSoFar(const MatrixTitle& title, const SuiteOptions& options, program::Terminal& terminal)
      : title_(title), options_(options), terminal_(terminal) {}

  void add(const Row& row) {
    terminal_.say(row_text(row));
    rows_.push_back(row);
  }
  int end(const program::Overdue& overdue) const {
    terminal_.say("netloft: " + overdue.sentence + "; the suite ends here, after " +
                  std::to_string(rows_.size()) + " of its cases");
    return print_matrix(title_, options_, rows_, terminal_,
                        overdue.interrupted ? program::kInterrupted : program::kNotConverged);
  }

 private:
  const MatrixTitle& title_;
  const SuiteOptions& options_;
  program::Terminal& terminal_;
  std::vector<Row> rows_;
};

RunOptions run_options(const SuiteOptions& o, MatrixSoFar& matrix, program::Watchdog& watchdog) {
  RunOptions run;
  run.sizes = o.sizes.empty() ? std::vector<std::string>{"small", "medium"} : o.sizes;
  run.pattern = o.pattern;
  run.seconds = o.seconds;
  run.work = o.work;
  run.update = o.update_references;
  run.threads = o.threads;
  run.watch = {.interrupt = &program::interrupt_flag(),
               .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  run.on_row = [&](const Row& row) { matrix.add(row); };
  return run;
}

std::string what_is_left(const SuiteOptions& o, std::size_t cases) {
  return "the suite ends here, after " + std::to_string(cases) + " of its cases" +
         (o.update_references ? "; no reference is renewed" : "") +
         (o.output.empty() ? "" : "; not written: " + o.output);
}

}  // namespace

int run_hard_cases(const SuiteOptions& o) {
  program::Terminal terminal(o);
  Registry registry;
  program::find_plugins(o, registry);
  formats::Diagnostics diagnostics;
  if (o.update_references && (!o.set.empty() || !o.flow.empty()))
    throw program::UsageError{
        "--update-references stores answers of unchanged cases only; leave out --set and --flow"};
  program::require_ending("-o", o.output, {".html", ".htm"});
  program::require_place(o.output, {});
  const std::filesystem::path folder = o.suite;
  Suite suite = read_suite(folder, o.seed, diagnostics);
  if (!o.flow.empty()) keep_nets_in_current(suite, o.flow == "on");
  if (diagnostics.errors())
    return program::report_unready(diagnostics, PreparedScene::State::wrong_input, terminal);
  const auto columns = find_columns(suite, o, registry, terminal);
  bool refused = false;
  for (const auto& column : columns) refused |= check_settings(column, registry, diagnostics);
  if (diagnostics.errors())
    return program::report_unready(
        diagnostics, refused ? PreparedScene::State::refused : PreparedScene::State::wrong_input, terminal);
  References references(suite.folder / "references.json");
  program::catch_interrupts();
  const MatrixTitle title{folder.string(), o.seed};
  MatrixSoFar matrix(title, o, terminal);
  program::Watchdog watchdog(terminal, [&](const program::Overdue& overdue) { return matrix.end(overdue); });
  const RunOptions how = run_options(o, matrix, watchdog);
  if (const auto refused = refuse_settings(suite, columns, references, registry, how))
    return program::report_unready(*refused, PreparedScene::State::wrong_input, terminal);
  const auto rows = run_suite(suite, columns, references, registry, how);
  if (rows.empty() && !program::interrupt_flag())
    throw program::UsageError{"no case of " + folder.string() + " has these names and sizes"};
  if (o.update_references && !program::interrupt_flag()) references.save();

  const int code = first_is_right(rows) ? program::kDone : program::kNotConverged;
  if (program::interrupt_flag())
    return print_matrix(title, o, rows, terminal,
                        program::end_interrupted(terminal, what_is_left(o, rows.size())));
  return print_matrix(title, o, rows, terminal, code);
}

}  // namespace netloft::hard_cases
