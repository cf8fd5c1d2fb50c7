// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/manual.hpp"

#include "io/program/command_line/option_rows.hpp"

#include <fmt/format.h>

namespace netloft::program {

namespace {

/// Escapes a text, so that man(7) does not read any of it as a command.
std::string plain(const std::string& text) {
  std::string safe = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) safe += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return safe;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

/// The first line of a row: the names of an option and its value, or the name of an argument.
std::string head_of(const OptionRow& row) {
  if (row.flags.empty())
    return italic(row.argument) + (row.value.empty() ? "" : " (" + plain(row.value) + ")");
  std::string head;
  for (const std::string& flag : row.flags) head += (head.empty() ? "" : ", ") + bold(flag);
  return head + (row.value.empty() ? "" : " " + italic(row.value));
}

std::string rows_text(const CLI::App& command) {
  std::string text, group = "Options";
  for (const OptionRow& row : rows_of(command)) {
    if (row.flags == std::vector<std::string>{"-h", "--help"} && command.get_parent()) continue;
    if (row.group != group && !row.group.empty()) text += ".PP\n" + plain(row.group) + ":\n";
    group = row.group;
    text += ".TP\n" + head_of(row) + "\n" + plain(row.doc) + "\n";
  }
  return text;
}

/// The command with its arguments: "netloft draw [options] GEAR".
std::string usage_of(const CLI::App& command) {
  std::string text = bold(full_name(command)) + " [options]";
  for (const OptionRow& row : rows_of(command))
    if (row.flags.empty())
      text += row.is_required ? " " + italic(row.argument) : " [" + italic(row.argument) + "]";
  return text;
}

std::string command_text(const CLI::App& command) {
  std::string text;
  if (const auto actions = command.get_subcommands({}); !actions.empty()) {
    for (const CLI::App* action : actions) text += command_text(*action);
    return text;
  }
  return ".SS " + plain(full_name(command)) + "\n" + usage_of(command) + "\n.PP\n" +
         plain(command.get_description()) + "\n" + rows_text(command);
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".\\\" Made by `{0} --manual`.\n.TH {1} 1 \"\" \"{2}\"\n.SH NAME\n{0} \\- {3}\n.SH SYNOPSIS\n"
      "{4} \\fIcommand\\fR [options] [arguments]\n.SH OPTIONS\n",
      app.get_name(), "NETLOFT", plain(app.version()), plain(app.get_description()), bold(app.get_name()));
  text += rows_text(app);
  std::string heading;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_group() != heading) text += ".SH " + plain(heading = command->get_group()) + "\n";
    text += command_text(*command);
  }
  return text +
         ".SH SEE ALSO\nThe pages in \\fIshare/doc/netloft\\fR, and the scenes and gears in\n"
         "\\fIshare/netloft/gear\\-library\\fR, beside the folder of the program.";
}

}  // namespace netloft::program
