// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for components and their authors.
#include "io/program/commands/plugins.hpp"

#include "io/program/command_line/chosen.hpp"
#include "io/program/command_line/shared.hpp"
#include "io/program/session/prefix.hpp"

namespace netloft::program {

namespace {

void add_component_commands(CLI::App& app, Chosen& chosen) {
  auto [list, list_options] = add_command(app, chosen, "list", "list all elements and solvers", list_command);
  add_plugin_options(list, list_options);
  auto [describe, o] =
      add_command(app, chosen, "describe",
                  "parameters, terms and outputs of a component, or of the tables water, analysis and gear",
                  describe_command);
  describe.add_option("TYPE", o.type, "such as rope/bar, newton, water")->required();
  add_plugin_options(describe, o);
  auto [schema, schema_options] =
      add_command(app, chosen, "schema", "JSON schema of scene files, for editors", schema_command);
  add_plugin_options(schema, schema_options);
}

void add_test_command(CLI::App& app, Chosen& chosen) {
  auto [test, o] = add_command(
      app, chosen, "test",
      "check the elements, laws and solvers of a plugin: derivatives, balance, vector lanes, conventions",
      test_command);
  test.add_option("PLUGIN", o.plugin, "plugin file, plugin name or element type")
      ->required()
      ->type_name("FILE.so|NAME");
  test.add_option("--seconds", o.seconds, "processor time for the checks of one component; default: 60")
      ->check(numbers_between(0.001, 1e6));
  test.add_flag("--verbose", o.verbose, "also list the checks that do not apply");
  add_plugin_options(test, o);
}

void add_new_command(CLI::App& app, Chosen& chosen) {
  auto [make, o] =
      add_command(app, chosen, "new",
                  "write an example of a gear or a plugin as a beginning: it works as it is", new_command);
  make.add_option("KIND", o.kind, "a trawl of two or four panels, or the kind of plugin")
      ->required()
      ->check(CLI::IsMember(
          {"two-panel", "four-panel", "element", "flow", "law", "solver", "integrator", "strategy"}));
  make.add_option("NAME", o.name, "its name, such as otter_board")->required();
  as_word(make.add_option("-o,--output", o.output, "folder; default: the name, in this folder"), "FOLDER");
}

}  // namespace

void add_plugin_commands(CLI::App& app, Chosen& chosen) {
  add_component_commands(app, chosen);
  add_test_command(app, chosen);
  add_new_command(app, chosen);
  app.add_flag_callback(
      "--cflags", [] { throw CLI::CallForVersion(compiler_flags(), 0); },
      "flags that compile a plugin: c++ $(netloft --cflags) otter.cpp -o otter.so");
}

}  // namespace netloft::program
