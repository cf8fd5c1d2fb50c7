// SPDX-License-Identifier: BSD-3-Clause
//
// Gives each command a struct of its own, which parsing fills with the options.
#pragma once
#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace netloft::program {

/// The command selected on the command line, with its options, ready to run.
struct Chosen {
  std::vector<std::string> words;  // the command line as given
  std::function<int()> run = {};
};

/// A command, and the struct for its options.
template <class Options>
struct Command {
  CLI::App& app;
  Options& options;
};

/// Adds a command that calls `run` with its options. `check` is called first and may throw a UsageError about
/// options.
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

/// Throws UsageError if a given option belongs neither to `groups` nor to the general group. Groups have
/// names such as "For a result"; `why` is the reason, such as "a.toml is a net plan".
void require_group(const CLI::App& command, const std::vector<std::string>& groups, const std::string& why);

// The commands, in the groups of `netloft --help`.
void add_gear_commands(CLI::App& app, Chosen& chosen);     // check, draw, import, catalogue
void add_scene_commands(CLI::App& app, Chosen& chosen);    // commands run, plan
void add_result_commands(CLI::App& app, Chosen& chosen);   // report, view, diff, export
void add_study_commands(CLI::App& app, Chosen& chosen);    // scope, study, calibrate
void add_numeric_commands(CLI::App& app, Chosen& chosen);  // commands compare, refine
void add_plugin_commands(CLI::App& app, Chosen& chosen);   // list, describe, schema, test, new, --cflags

}  // namespace netloft::program
