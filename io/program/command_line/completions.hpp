// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>

#include <string>

namespace netloft::program {

/// Scripts, made from the table of commands, with which a shell completes commands, options, values that are
/// one of a few words, and files by their endings.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

}  // namespace netloft::program
