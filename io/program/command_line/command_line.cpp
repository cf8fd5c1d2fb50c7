// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/command_line.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/program/command_line/groups.hpp"

namespace netloft::program {

void add_commands(CLI::App& app, Options& o) {
  add_run_command(app, o);
  add_plan_command(app, o);
  add_component_commands(app, o);
  add_test_command(app, o);
  add_author_commands(app, o);
  add_gear_commands(app, o);
  add_compare_command(app, o);
  add_diff_command(app, o);
  add_result_commands(app, o);
  add_refine_command(app, o);
  add_scope_command(app, o);
  add_import_command(app, o);
  add_study_command(app, o);
  add_calibrate_command(app, o);
  app.require_subcommand(1);
}

std::string unknown_command(const CLI::App& app, std::span<const std::string> words,
                            const std::string& before) {
  const auto commands = app.get_subcommands({});
  if (words.empty() || words[0].starts_with('-') || commands.empty()) return {};
  std::vector<std::string> names;
  for (const auto* command : commands) {
    names.push_back(command->get_name());
    if (names.back() == words[0]) return unknown_command(*command, words.subspan(1), words[0] + " ");
  }
  const auto near = nearest(words[0], names);
  return "there is no command \"" + before + words[0] +
         (near ? "\"; did you mean \"" + before + *near + "\"?"
               : "\"; `netloft " + before + "--help` lists them");
}

namespace {

/// The command that was named last: "study run".
const CLI::App& innermost(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : innermost(*commands.front());
}

/// "netloft study run"
std::string full_name(const CLI::App& app) {
  return app.get_parent() ? full_name(*app.get_parent()) + " " + app.get_name() : app.get_name();
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

}  // namespace

std::string unknown_option(const CLI::App& app) {
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with('-')) continue;
    const CLI::App& command = innermost(app);
    const std::string name = word.substr(0, word.find('='));
    const auto near = nearest(name, names_of_options(command));
    return "there is no option " + name +
           (near ? "; did you mean " + *near + "?" : "; `" + full_name(command) + " --help` lists them");
  }
  return {};
}

std::vector<std::string> given_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options())
      if (option->count() > 0) names.push_back(option->get_name());
    for (auto& name : given_options(*command)) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace netloft::program
