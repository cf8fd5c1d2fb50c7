// SPDX-License-Identifier: BSD-3-Clause
//
// The table of options as other texts need it: the manual page and the completions of shells.
#pragma once
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace netloft::program {

/// An option or an argument of a command.
struct OptionRow {
  std::vector<std::string> flags;  // "-o", "--output"; empty for an argument
  std::string argument;            // the name of an argument, "GEAR"; empty for an option
  std::string value;               // the type of the value, "FILE.svg|FILE.png"; empty for a flag
  std::string doc, group;
  bool is_required = false, is_repeated = false;
  // The value as its type describes it:
  std::vector<std::string> choices, endings;  // words; endings of files, without the dot
  bool is_any_file = false, is_folder = false;
};

/// The visible options and arguments of a command, in the order of its help. If an option is also an
/// argument, it has two rows.
std::vector<OptionRow> rows_of(const CLI::App& command);

/// The name of a command, with the names of its parents: "netloft study run".
std::string full_name(const CLI::App& command);

}  // namespace netloft::program
