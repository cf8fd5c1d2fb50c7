// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/command_line/chosen.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::program {

/// Adds all commands with their options, in groups. Parsing sets `chosen.run`.
void add_commands(CLI::App& app, Chosen& chosen);

/// A sentence that there is no command of this name, with the most similar command; empty if the command is
/// known. The name is the first word; for actions of `study`, it is the second word, and `before` is "study
/// ".
std::string unknown_command(const CLI::App& app, std::span<const std::string> words,
                            const std::string& before = "");

/// A sentence about the first unknown option on a command line, with the most similar option or a command
/// that has this option. Empty if all options are known.
std::string unknown_option(const CLI::App& app);

}  // namespace netloft::program
