// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/command_line/chosen.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::program {

/// Adds all commands with their options, in groups. Parsing sets `chosen.run`.
void add_commands(CLI::App& app, Chosen& chosen);

/// Names a first word that is no command, or a second one that is no action of the first, and the command it
/// may stand for. Empty if there is none. `before` is "study " for actions of `study`.
std::string unknown_command(const CLI::App& app, std::span<const std::string> words,
                            const std::string& before = "");

/// Names the first option of an unreadable command line that the command does not have, and the option that
/// may be meant or the command that has it. Empty if there is none.
std::string unknown_option(const CLI::App& app);

}  // namespace netloft::program
