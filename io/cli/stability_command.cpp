// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/commands.hpp"
#include "io/cli/error_json.hpp"
#include "io/cli/session.hpp"
#include "io/cli/terminal.hpp"
#include "io/scene/dynamics.hpp"
#include "io/stability/matrix.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace netloft::io {

namespace {

/// The columns that --solver names, with what the suite gives a solver of that name; else the suite's.
std::vector<StabilityColumn> wanted_columns(const StabilitySuite& suite, const StabilityOptions& options) {
  if (options.solvers.empty()) return suite.columns;
  std::vector<StabilityColumn> columns;
  for (const auto& word : options.solvers) {
    const std::string name = word.substr(0, word.find(':'));
    const auto same = std::find_if(suite.columns.begin(), suite.columns.end(), [&](const auto& column) {
      return column.word.substr(0, column.word.find(':')) == name;
    });
    columns.push_back(
        {word, same == suite.columns.end() ? std::vector<std::string>{} : same->overrides, {}, ""});
  }
  return columns;
}

/// Throws UsageError for a solver that was asked for by name and is not there, or cannot be understood.
bool is_there(const StabilityColumn& column, Registry& registry, bool asked_for) {
  try {
    solver_overrides(column.word);
    const std::string name = column.word.substr(0, column.word.find(':'));
    if (name != "auto" && !is_integrator(registry, name)) registry.solver(name);
    return true;
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  } catch (const PluginRefused& e) {
    if (asked_for) throw;
    return false;
  }
}

std::vector<StabilityColumn> find_columns(const StabilitySuite& suite, const StabilityOptions& options,
                                          Registry& registry, Terminal& terminal) {
  std::vector<StabilityColumn> columns;
  for (auto& column : wanted_columns(suite, options)) {
    if (is_there(column, registry, !options.solvers.empty()))
      columns.push_back(std::move(column));
    else
      terminal.say("there is no solver " + column.word + ": left out");
  }
  if (columns.empty()) throw UsageError{"there is none of the suite's solvers; name one with --solver"};
  return columns;
}

void write_page(const std::string& file, const std::string& page) {
  std::ofstream out(file);
  if (!(out << page) || !out.flush()) throw std::runtime_error(file + ": cannot be written");
}

/// Whether the first column got all of it right.
bool first_is_right(const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(),
                     [](const Row& row) { return is_right(row.cells.front().verdict.where); });
}

RunOptions run_options(const Options& options, Terminal& terminal) {
  const StabilityOptions& o = options.stability;
  RunOptions run;
  run.sizes = o.sizes.empty() ? std::vector<std::string>{"small", "medium"} : o.sizes;
  run.pattern = o.pattern, run.seconds = o.seconds, run.update = o.update_references;
  run.threads = std::max(1, options.threads);
  run.interrupt = &interrupt_flag();
  run.on_row = [&](const Row& row) { terminal.say(row_text(row)); };
  return run;
}

}  // namespace

int stability_command(const Options& options) {
  const StabilityOptions& o = options.stability;
  Terminal terminal(options.color);
  Registry registry;
  find_plugins(options, registry);
  Diagnostics diagnostics;
  const StabilitySuite suite = read_suite(o.suite, o.draw, diagnostics);
  if (diagnostics.errors()) {
    terminal.say(diagnostics.render(terminal.color()));
    if (options.json) std::puts(errors_json(diagnostics, kWrongInput).c_str());
    return kWrongInput;
  }
  const auto columns = find_columns(suite, o, registry, terminal);
  References references(suite.folder / "references.json");
  catch_interrupts();
  const auto rows = run_suite(suite, columns, references, registry, run_options(options, terminal));
  if (rows.empty() && !interrupt_flag())
    throw UsageError{"no case of " + o.suite + " has these names and sizes"};
  if (o.update_references && !interrupt_flag()) references.save();

  const MatrixTitle title{o.suite, o.draw};
  if (!o.html.empty()) write_page(o.html, matrix_html(title, rows));
  std::puts((options.json ? matrix_json(title, rows) : matrix_text(title, rows)).c_str());
  if (interrupt_flag()) return kInterrupted;
  return first_is_right(rows) ? kDone : kNotConverged;
}

}  // namespace netloft::io
