// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <vector>

namespace netloft::program {

/// All commands with their options, which are read into `o`.
void add_commands(CLI::App& app, Options& o);

/// A first word that is no command, or a second one that is none of the first's, as a sentence with the
/// command it may stand for; else empty. `before`: "study ".
std::string unknown_command(const CLI::App& app, std::span<const std::string> words,
                            const std::string& before = "");

/// What was left over of a command line that could not be read: its first option that the command does not
/// have, as a sentence with the option it may stand for; else empty.
std::string unknown_option(const CLI::App& app);

/// Long names of the options that were given to the command, and to one below it.
std::vector<std::string> given_options(const CLI::App& app);

}  // namespace netloft::program
