// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/program.hpp"
#include "io/program/session/memory_room.hpp"
#include "tests/stability/suite/command.hpp"

int main(int argc, char** argv) {
  using namespace netloft;
  hard_cases::SuiteOptions options;
  CLI::App app{"Runs strategies and solvers on the suite of hard cases, and prints their results.",
               "hard_cases"};
  hard_cases::add_options(app, options);
  return program::run_program(app, argc, argv, [&] {
    program::require_memory_to_solve();
    return hard_cases::run_hard_cases(options);
  });
}
