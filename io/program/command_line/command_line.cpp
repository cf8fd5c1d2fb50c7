// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/command_line.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/program/command_line/completions.hpp"
#include "io/program/command_line/manual.hpp"
#include "io/program/command_line/option_rows.hpp"
#include "io/program/session/options.hpp"

#include <algorithm>

namespace netloft::program {

namespace {

using AddCommands = void (*)(CLI::App&, Chosen&);

/// Adds commands under their own heading in `netloft --help`.
void add_group(CLI::App& app, Chosen& chosen, const char* heading, AddCommands add) {
  const std::size_t before = app.get_subcommands({}).size();
  add(app, chosen);
  const auto commands = app.get_subcommands({});
  for (std::size_t i = before; i < commands.size(); ++i) commands[i]->group(heading);
}

}  // namespace

namespace {

/// Adds options that print the manual page and the completions, which the installation stores. The help does
/// not list them.
void add_documents(CLI::App& app) {
  app.add_flag_callback("--manual", [&app] { throw CLI::CallForVersion(manual_page(app), 0); })->group("");
  const auto print_for = [&app](const std::string& shell) {
    throw CLI::CallForVersion(shell == "bash" ? bash_completion(app) : zsh_completion(app), 0);
  };
  app.add_option_function<std::string>("--completions", print_for)
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->group("");
}

}  // namespace

void add_commands(CLI::App& app, Chosen& chosen) {
  add_group(app, chosen, "Gears", add_gear_commands);
  add_group(app, chosen, "Scenes", add_scene_commands);
  add_group(app, chosen, "Results", add_result_commands);
  add_group(app, chosen, "Studies", add_study_commands);
  add_group(app, chosen, "Numerics", add_numeric_commands);
  add_group(app, chosen, "Plugins", add_plugin_commands);
  add_documents(app);
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

/// The innermost command on the command line: "study run".
const CLI::App& innermost(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : innermost(*commands.front());
}

const CLI::App& top_of(const CLI::App& app) { return app.get_parent() ? top_of(*app.get_parent()) : app; }

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The first command that has the option: "netloft run"; empty if there is none.
std::string command_with(const CLI::App& app, const std::string& option) {
  const auto names = names_of_options(app);
  if (std::ranges::find(names, option) != names.end()) return full_name(app);
  for (const CLI::App* command : app.get_subcommands({}))
    if (const std::string found = command_with(*command, option); !found.empty()) return found;
  return {};
}

}  // namespace

std::string unknown_option(const CLI::App& app) {
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with('-')) continue;
    const CLI::App& command = innermost(app);
    const std::string name = word.substr(0, word.find('='));
    const auto near = nearest(name, names_of_options(command));
    const std::string other = near ? "" : command_with(top_of(command), name);
    return "there is no option " + name +
           (near            ? "; did you mean " + *near + "?"
            : other.empty() ? "; `" + full_name(command) + " --help` lists them"
                            : " of `" + full_name(command) + "`; `" + other + "` has it");
  }
  return {};
}

void require_group(const CLI::App& command, const std::vector<std::string>& groups, const std::string& why) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string own = option->get_group();
    if (option->count() == 0 || own == "Options" || std::ranges::find(groups, own) != groups.end()) continue;
    throw UsageError{option->get_name() + " is f" + own.substr(1) + "; " + why};
  }
}

}  // namespace netloft::program
