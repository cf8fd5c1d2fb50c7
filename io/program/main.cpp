// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/command_line.hpp"
#include "io/program/command_line/program.hpp"
#include "io/program/session/commands.hpp"

#include <algorithm>
#include <string_view>

namespace netloft::program {
namespace {

/// `solves`: it may want more memory than the machine has room for, and says so before it begins.
struct Command {
  std::string_view name;
  int (*run)(const Options&);
  bool solves = false;
};

constexpr Command kCommands[] = {
    {"run", run_command, true},
    {"plan", plan_command},
    {"list", list_command},
    {"describe", describe_command},
    {"schema", schema_command},
    {"compare", compare_command, true},
    {"diff", diff_command},
    {"refine", refine_command, true},
    {"scope", scope_command, true},
    {"study", study_command, true},
    {"calibrate", calibrate_command, true},
    {"new", new_command},
    {"catalogue", catalogue_command},
    {"check", check_command},
    {"draw", draw_command},
    {"report", report_command},
    {"view", view_command},
    {"export", export_command},
    {"import", import_command},
    {"test", test_command, true},
};

int run(const CLI::App& app, Options& o) {
  o.command = app.get_subcommands().front()->get_name();
  o.given = given_options(app);
  const Command& command = *std::ranges::find(kCommands, o.command, &Command::name);
  if (command.solves) require_memory_to_solve();
  return command.run(o);
}

int start(int argc, char** argv) {
  Options o;
  CLI::App app{"Netloft finds the shape and the forces of trawl gears.", "netloft"};
  app.set_version_flag("--version", std::string("netloft " NETLOFT_VERSION));
  add_commands(app, o);
  return run_program(app, o, argc, argv, [&] { return run(app, o); });
}

}  // namespace
}  // namespace netloft::program

int main(int argc, char** argv) { return netloft::program::start(argc, argv); }
