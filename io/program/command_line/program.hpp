// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>

#include <functional>

namespace netloft::program {

/// The frame of main(): reads the command line with `app`, calls `work`, and reports exceptions and command
/// line errors on standard error and, with --json, as an object on standard output. An interruption ends the
/// program, unless `work` handles interruptions itself. Returns the exit code.
int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& work);

}  // namespace netloft::program
