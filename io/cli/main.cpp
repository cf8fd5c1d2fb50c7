// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/command_line/command_line.hpp"
#include "io/cli/command_line/program.hpp"
#include "io/cli/commands.hpp"
#include "io/cli/launched.hpp"
#include "solvers/factorisation/large_blocks.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace netloft::io {
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
    {"reference", reference_command},
    {"catalogue", catalogue_command},
    {"check", check_command},
    {"draw", draw_command},
    {"report", report_command},
    {"view", view_command},
    {"export", export_command},
    {"import", import_command},
    {"test", test_command, true},
};

constexpr const char* kDescription = "Netloft finds the shape and the forces of trawl gears.";

/// A rank other than 0. Where the command line is none of a `run`, rank 0 says so.
int serve(int argc, char** argv, const Launch& launch) {
  guard_streams();
  Options o;
  CLI::App app{kDescription, "netloft"};
  add_commands(app, o);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError&) {
    return kDone;
  }
  if (app.get_subcommands().front()->get_name() != "run") return kDone;
  try {
    put_large_blocks_into(o.out_of_core);
  } catch (const std::runtime_error& e) {
    return fail(o, e.what(), kOther);
  }
  serve_ranks(o, launch);
  return kDone;
}

int run(const CLI::App& app, Options& o) {
  o.command = app.get_subcommands().front()->get_name();
  o.given = given_options(app);
  const Command& command = *std::ranges::find(kCommands, o.command, &Command::name);
  if (command.solves) require_memory_to_solve();
  const auto ranks = start_ranks(o, launch_of_environment());
  o.ranks = ranks.get();
  put_large_blocks_into(o.out_of_core);
  return command.run(o);
}

int start(int argc, char** argv) {
  Options o;
  CLI::App app{kDescription, "netloft"};
  app.set_version_flag("--version", std::string("netloft " NETLOFT_VERSION));
  add_commands(app, o);
  return run_program(app, o, argc, argv, [&] { return run(app, o); });
}

}  // namespace
}  // namespace netloft::io

int main(int argc, char** argv) {
  if (const auto launch = netloft::launch_of_environment(); launch.rank > 0)
    return netloft::io::serve(argc, argv, launch);
  return netloft::io::start(argc, argv);
}
