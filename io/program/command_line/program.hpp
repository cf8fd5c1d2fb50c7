// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>

#include <functional>

namespace netloft::program {

/// All that the main() of a program does besides its work: reads the command line with `app`, calls `work`,
/// and says what it throws, or what is wrong with the command line, on standard error and, with --json, as an
/// object on standard output. Until `work` catches interruptions, one ends the program. Returns the exit
/// code.
int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& work);

}  // namespace netloft::program
