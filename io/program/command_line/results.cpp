// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that show results.
#include "io/program/command_line/groups.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

void add_report_command(CLI::App& app, Options& o) {
  auto* report = app.add_subcommand("report", "print the report of a result again");
  report->add_option("RESULT", o.target, "result file (.hdf)")->required();
  auto* html = report->add_flag("--html", o.html, "as a page in one file, without scripts");
  auto* json = report->add_flag("--json", o.json, "one JSON object on standard output");
  report->add_flag("--csv", o.csv, "comma-separated values on standard output")
      ->excludes(html)
      ->excludes(json);
  as_word(
      report->add_option("-o,--output", o.output, "page; else the result's name with .html, in this folder"),
      "FILE.html")
      ->needs(html);
}

void add_export_command(CLI::App& app, Options& o) {
  auto* convert = app.add_subcommand("export", "write a result for other programs");
  convert->add_option("RESULT", o.target, "result file (.hdf)")->required();
  convert
      ->add_option(
          "FILE", o.output,
          "its ending says what: .glb is binary glTF, .csv a table, .mesh, .obj and .vtk meshes for scenes")
      ->required();
  convert->add_option("--table", o.kind, "of a .csv: nodes or elements; else nodes")
      ->check(CLI::IsMember({"nodes", "elements"}));
  as_word(
      convert->add_option("--field", o.picture.field, "of a .glb: what is coloured, or part; else tension"),
      "NAME");
  add_state_option(*convert, o);
  add_json_option(*convert, o);
}

void add_view_command(CLI::App& app, Options& o) {
  auto* view = app.add_subcommand(
      "view", "write a page to look at results with: two are laid over one another, more are a sweep");
  view->add_option("RESULT", o.targets, "result files (.hdf)")->required();
  as_word(view->add_option("-o,--output", o.output,
                           "page; else the first result's name with .html, in this folder"),
          "FILE.html");
  view->add_option("--states", o.picture.states, "of a motion with more outputs, as many are kept; else 100")
      ->check(CLI::Range(2, 100000));
  add_json_option(*view, o);
}

}  // namespace

void add_result_commands(CLI::App& app, Options& o) {
  add_report_command(app, o);
  add_export_command(app, o);
  add_view_command(app, o);
}

void add_diff_command(CLI::App& app, Options& o) {
  auto* command =
      app.add_subcommand("diff", "say what changed between two results, and in what they were made of");
  command->add_option("BEFORE", o.target, "result file (.hdf)")->required();
  command->add_option("AFTER", o.other, "another one")->required();
  add_json_option(*command, o);
}

}  // namespace netloft::program
