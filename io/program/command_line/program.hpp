// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace netloft::program {

/// All of main() but what a program is for: reads the command line with `app` into `o` and its like, calls
/// `work`, and says what it throws, or what is wrong with the command line, on standard error, with --json
/// also as an object on standard output. Returns the exit code.
int run_program(CLI::App& app, Options& o, int argc, char** argv, const std::function<int()>& work);

/// Throws std::runtime_error with a sentence if there is no room for what solving wants at the least.
void require_memory_to_solve();

/// A file that is opened must not become a stream that was closed: what is printed would land in it. Nor is a
/// limit on the size of files a reason to die without a word.
void guard_streams();

/// Says it as run_program() does, and returns the code.
int fail(const Options& o, const std::string& message, int code);

}  // namespace netloft::program
