// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/completions.hpp"

#include "io/program/command_line/option_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace netloft::program {

namespace {

/// Calls visit(command) for the program and, recursively, for all its subcommands.
template <class Visit>
void for_commands(const CLI::App& app, Visit&& visit) {
  visit(app);
  for (const CLI::App* command : app.get_subcommands({})) for_commands(*command, visit);
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

constexpr const char* kBash = R"sh(# Completion of netloft in bash, made by `netloft --completions bash`.
_netloft_words() { COMPREPLY+=($(compgen -W "$1" -- "$word")); }

_netloft_folders() {
  compopt -o filenames 2>/dev/null
  local IFS=$'\n'
  COMPREPLY+=($(compgen -d -- "$word"))
}

# Files with one of these endings, and the folders in which they may lie.
_netloft_files() {
  _netloft_folders
  local IFS=$'\n' ending
  for ending; do COMPREPLY+=($(compgen -f -X "!*.$ending" -- "$word")); done
}

_netloft() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=netloft i
  [[ $word != = ]] || word=
  [[ $before != = ]] || before=${COMP_WORDS[COMP_CWORD - 2]}
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
)sh";

/// The line of a bash script that completes the value of an option; empty if nothing is known of the value.
std::string bash_value(const OptionRow& row) {
  if (!row.choices.empty()) return fmt::format("_netloft_words '{}'", fmt::join(row.choices, " "));
  if (!row.endings.empty()) return fmt::format("_netloft_files {}", fmt::join(row.endings, " "));
  if (row.is_any_file) return "_netloft_folders; COMPREPLY+=($(compgen -f -- \"$word\"))";
  return row.is_folder ? "_netloft_folders" : "";
}

/// The branch of the bash script for a command. It completes the value of the option before the word,
/// options, commands, and arguments.
std::string bash_case(const CLI::App& command) {
  std::string values, arguments, flags;
  for (const OptionRow& row : rows_of(command)) {
    const std::string value = bash_value(row);
    if (row.flags.empty()) {
      if (!value.empty()) arguments += "      " + value + "\n";
      continue;
    }
    flags += fmt::format(" {}", fmt::join(row.flags, " "));
    if (!row.value.empty())
      values += fmt::format("        {}) {}{}return ;;\n", fmt::join(row.flags, " | "), value,
                            value.empty() ? "" : "; ");
  }
  if (const auto names = names_of_commands(command); !names.empty())
    arguments += fmt::format("      _netloft_words '{}'\n", fmt::join(names, " "));
  return fmt::format("    '{}')\n", full_name(command)) +
         (values.empty() ? "" : "      case $before in\n" + values + "      esac\n") +
         fmt::format("      if [[ $word == -* ]]; then _netloft_words '{}'; return; fi\n{}      ;;\n",
                     flags.empty() ? flags : flags.substr(1), arguments);
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string commands, cases;
  for_commands(app, [&](const CLI::App& command) {
    if (command.get_parent())
      commands += fmt::format("{}'{}'", commands.empty() ? "" : " | ", full_name(command));
    cases += bash_case(command);
  });
  return kBash + fmt::format("      {}) command+=\" ${{COMP_WORDS[i]}}\" ;;\n", commands) +
         "    esac\n  done\n  case $command in\n" + cases + "  esac\n}\n\ncomplete -F _netloft netloft";
}

namespace {

/// A text for a specification of _arguments, in single quotes.
std::string zsh_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'')
      safe += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      safe += std::string("\\") + c;
    else
      safe += c;
  }
  return safe;
}

/// How zsh completes a value.
std::string zsh_value(const OptionRow& row) {
  if (!row.choices.empty()) return fmt::format("({})", fmt::join(row.choices, " "));
  if (!row.endings.empty()) return fmt::format("_files -g \"*.({})\"", fmt::join(row.endings, "|"));
  return row.is_any_file ? "_files" : row.is_folder ? "_files -/" : " ";
}

std::string zsh_argument(const OptionRow& row) {
  const char* number = row.is_repeated ? "*" : row.is_required ? "" : ":";
  return fmt::format("'{}:{}:{}'", number, zsh_text(row.argument), zsh_value(row));
}

/// The specification of an option or argument for _arguments. The value of an option in letters may also
/// follow an equals sign.
std::string zsh_row(const OptionRow& row) {
  if (row.flags.empty()) return zsh_argument(row);
  std::vector<std::string> flags = row.flags;
  for (std::string& flag : flags)
    if (!row.value.empty() && flag.starts_with("--")) flag += "=";
  const std::string value = row.value.empty() ? "" : ":" + zsh_text(row.value) + ":" + zsh_value(row);
  const std::string doc = fmt::format("'[{}]{}'", zsh_text(row.doc), value);
  if (flags.size() == 1) return (row.is_repeated ? "'*'" : "") + flags.front() + doc;
  const std::string before = row.is_repeated ? "*" : fmt::format("({})", fmt::join(row.flags, " "));
  return fmt::format("'{}'{{{}}}{}", before, fmt::join(flags, ","), doc);
}

std::string zsh_name(const CLI::App& command) {
  std::string name = "_" + full_name(command);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// A function of zsh for a command. If the command has subcommands, the function calls their functions.
std::string zsh_function(const CLI::App& command) {
  std::string specs, commands;
  for (const OptionRow& row : rows_of(command)) specs += " \\\n    " + zsh_row(row);
  for (const CLI::App* own : command.get_subcommands({}))
    commands += fmt::format("      '{}:{}'\n", own->get_name(), zsh_text(own->get_description()));
  if (commands.empty()) return fmt::format("{}() {{\n  _arguments{}\n}}\n\n", zsh_name(command), specs);
  return fmt::format(
      "{0}() {{\n  local curcontext=$curcontext state line ret=1\n  typeset -A opt_args\n  _arguments -C{1} "
      "\\\n    ': :->command' '*:: :->rest' && ret=0\n  case $state in\n    command)\n      local -a "
      "commands=(\n{2}      )\n      _describe command commands && ret=0 ;;\n    rest) _call_function ret "
      "{0}_$words[1] ;;\n  esac\n  return ret\n}}\n\n",
      zsh_name(command), specs, commands);
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string text =
      "#compdef netloft\n# Completion of netloft in zsh, made by `netloft --completions zsh`.\n\n";
  for_commands(app, [&](const CLI::App& command) { text += zsh_function(command); });
  return text + "_netloft \"$@\"";
}

}  // namespace netloft::program
