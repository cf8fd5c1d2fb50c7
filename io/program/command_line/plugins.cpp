// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for components and their authors.
#include "io/program/command_line/groups.hpp"
#include "io/program/command_line/shared.hpp"
#include "io/program/session/prefix.hpp"

namespace netloft::program {

void add_component_commands(CLI::App& app, Options& o) {
  add_plugin_options(*app.add_subcommand("list", "list all elements and solvers"), o);
  auto* describe = app.add_subcommand(
      "describe", "parameters, terms and outputs of a component, or of the tables water, analysis and gear");
  describe->add_option("TYPE", o.target, "such as rope/bar, newton, water")->required();
  add_plugin_options(*describe, o);
  add_plugin_options(*app.add_subcommand("schema", "JSON schema of scene files, for editors"), o);
}

void add_test_command(CLI::App& app, Options& o) {
  auto* test = app.add_subcommand(
      "test", "check the elements, laws and solvers of a plugin: derivatives, balance, lanes, manners");
  test->add_option("PLUGIN", o.target, "plugin file (.so), plugin name or element type")->required();
  test->add_option("--seconds", o.seconds, "processor time for the checks of one component; else 60")
      ->check(numbers_between(0.001, 1e6));
  add_plugin_options(*test, o);
}

void add_author_commands(CLI::App& app, Options& o) {
  auto* make =
      app.add_subcommand("new", "write a plugin to begin with: it builds, passes its tests and runs");
  make->add_option("KIND", o.kind, "what the plugin holds")
      ->required()
      ->check(CLI::IsMember({"element", "law", "solver", "integrator", "strategy"}));
  make->add_option("NAME", o.target, "its name, such as otter_board; also that of the folder")->required();
  app.add_flag_callback(
      "--cflags", [] { throw CLI::CallForVersion(compiler_flags(), 0); },
      "flags that compile a plugin: c++ $(netloft --cflags) otter.cpp -o otter.so");
}

}  // namespace netloft::program
