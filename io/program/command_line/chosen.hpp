// SPDX-License-Identifier: BSD-3-Clause
//
// How a command gets its options: a struct of its own, filled from its own table.
#pragma once
#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace netloft::program {

/// The command that the command line names, with its options, ready to run.
struct Chosen {
  std::vector<std::string> words;  // the command line as given
  std::function<int()> run = {};
};

/// A command and the struct that its options are read into.
template <class Options>
struct Command {
  CLI::App& app;
  Options& options;
};

/// Adds a command that runs `run` with its options. `check` may refuse options before that, with a
/// UsageError.
template <class Options>
Command<Options> add_command(CLI::App& parent, Chosen& chosen, const char* name, const char* doc,
                             int (*run)(const Options&),
                             void (*check)(const Options&, const CLI::App&) = nullptr) {
  CLI::App* app = parent.add_subcommand(name, doc);
  const auto options = std::make_shared<Options>();
  app->callback([&chosen, app, options, run, check] {
    chosen.run = [app, options, run, check] {
      if (check) check(*options, *app);
      return run(*options);
    };
  });
  return {*app, *options};
}

/// Throws UsageError if an option of another group than `group` and the general one is given. Groups are
/// named after what they are for ("For a result"), and `why` says what is there: "a.toml is a net plan".
void require_group(const CLI::App& command, const std::string& group, const std::string& why);

// The commands, in the groups of `netloft --help`.
void add_gear_commands(CLI::App& app, Chosen& chosen);     // check, draw, import, catalogue
void add_scene_commands(CLI::App& app, Chosen& chosen);    // run, plan
void add_result_commands(CLI::App& app, Chosen& chosen);   // report, view, diff, export
void add_study_commands(CLI::App& app, Chosen& chosen);    // scope, study, calibrate
void add_numeric_commands(CLI::App& app, Chosen& chosen);  // compare, refine
void add_plugin_commands(CLI::App& app, Chosen& chosen);   // list, describe, schema, test, new, --cflags

}  // namespace netloft::program
