// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/command_line/chosen.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::program {

/// Adds all commands with their options, in groups. Parsing sets `chosen.run`.
void add_commands(CLI::App& app, Chosen& chosen);

/// A sentence about the first word, or the second word after `study`, if there is no such command, with the
/// most similar command. Empty if the command is known. `before` is "study " for actions of `study`.
std::string unknown_command(const CLI::App& app, std::span<const std::string> words,
                            const std::string& before = "");

/// A sentence about the first unknown option on a command line that cannot be read, with the most similar
/// option or a command that has this option. Empty if the command has all options.
std::string unknown_option(const CLI::App& app);

}  // namespace netloft::program
