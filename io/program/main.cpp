// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/command_line.hpp"
#include "io/program/command_line/program.hpp"

namespace {

int start(int argc, char** argv) {
  using namespace netloft::program;
  Chosen chosen{{argv, argv + argc}};
  CLI::App app{"Netloft finds the shape and the forces of trawl gears.", "netloft"};
  app.set_version_flag("--version", std::string("netloft " NETLOFT_VERSION));
  add_commands(app, chosen);
  return run_program(app, argc, argv, [&] { return chosen.run(); });
}

}  // namespace

int main(int argc, char** argv) { return start(argc, argv); }
