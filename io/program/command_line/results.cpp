// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that show results.
#include "io/program/commands/results.hpp"

#include "io/program/command_line/chosen.hpp"
#include "io/program/command_line/shared.hpp"

#include <filesystem>

namespace netloft::program {

namespace {

// groups of options
constexpr const char *kForGltf = "For a .glb file", *kForTables = "For a .csv file";

void add_report_command(CLI::App& app, Chosen& chosen) {
  auto [report, o] = add_command(app, chosen, "report", "print the report of a result again", report_command);
  report.add_option("RESULT", o.result, "result file")->required()->type_name("FILE.hdf");
  auto* json = report.add_flag("--json", o.json, "one JSON object on standard output");
  auto* csv = report.add_flag("--csv", o.csv, "comma-separated values on standard output")->excludes(json);
  as_word(report.add_option("-o,--output", o.output,
                            "write the report as a page in one file, without scripts, instead"),
          "FILE.html")
      ->excludes(csv);
}

/// Rejects options for another file format. The file extension of the output determines which group of
/// options is allowed.
void refuse_options_of_other_files(const ExportOptions& o, const CLI::App& command) {
  const std::string ending = std::filesystem::path(o.output).extension().string();
  require_group(command, {"For a " + ending + " file"}, o.output + " is a file of another kind");
}

void add_export_command(CLI::App& app, Chosen& chosen) {
  auto [convert, o] = add_command(app, chosen, "export", "write a result for other programs", export_command,
                                  refuse_options_of_other_files);
  convert.add_option("RESULT", o.result, "result file")->required()->type_name("FILE.hdf");
  convert
      .add_option("FILE,-o,--output", o.output,
                  "its ending names the format: .glb is binary glTF, .csv a table, .mesh, .obj and .vtk "
                  "meshes for scenes")
      ->required()
      ->type_name("FILE.glb|FILE.csv|FILE.mesh|FILE.obj|FILE.vtk");
  add_state_option(convert, o.state);
  add_json_option(convert, o);
  as_word(convert.add_option("--field", o.field,
                             "quantity that is shown by colours, or the word part; default: tension"),
          "NAME")
      ->group(kForGltf);
  convert.add_option("--table", o.table, "nodes or elements; default: nodes")
      ->check(CLI::IsMember({"nodes", "elements"}))
      ->group(kForTables);
}

void add_view_command(CLI::App& app, Chosen& chosen) {
  auto [view, o] = add_command(
      app, chosen, "view",
      "write a page that shows results: two are drawn in one picture, more than two have a slider",
      view_command);
  view.add_option("RESULT", o.results, "result files")->required()->type_name("FILE.hdf");
  as_word(view.add_option("-o,--output", o.output,
                          "page; default: the first result's name with .html, in this folder"),
          "FILE.html");
  view.add_option("--states", o.states, "most outputs of a motion that the page keeps; default: 100")
      ->check(CLI::Range(2, 100000));
  add_json_option(view, o);
}

void add_diff_command(CLI::App& app, Chosen& chosen) {
  auto [diff, o] = add_command(
      app, chosen, "diff", "print what changed between two results, and between their inputs", diff_command);
  diff.add_option("BEFORE", o.before, "result file")->required()->type_name("FILE.hdf");
  diff.add_option("AFTER", o.after, "result file that is compared with it")
      ->required()
      ->type_name("FILE.hdf");
  diff.add_flag("--all", o.all,
                "all numbers and all changes of the inputs, not only the most important ones");
  add_json_option(diff, o);
}

}  // namespace

void add_result_commands(CLI::App& app, Chosen& chosen) {
  add_report_command(app, chosen);
  add_view_command(app, chosen);
  add_diff_command(app, chosen);
  add_export_command(app, chosen);
}

}  // namespace netloft::program
