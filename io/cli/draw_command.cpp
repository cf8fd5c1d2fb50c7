// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/commands.hpp"
#include "io/cli/error_json.hpp"
#include "io/cli/terminal.hpp"
#include "io/files/whole_file.hpp"
#include "io/gear/check.hpp"
#include "io/gear/drawing.hpp"
#include "io/gear/read_plan.hpp"

#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace netloft::io {

namespace {

std::string output_of(const Options& options) {
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.target).stem().string() + ".svg";
}

/// A picture replaces a file, never a folder, a device or the plan itself.
void check_output(const std::string& output, const NetPlan& plan) {
  std::error_code none;
  if (std::filesystem::exists(output, none) && !std::filesystem::is_regular_file(output, none))
    throw UsageError{output + " is no file that may be replaced"};
  for (const auto& file : plan.files)
    if (std::filesystem::equivalent(output, file.path, none))
      throw UsageError{output + " is the plan itself; name another file with -o"};
}

std::string draw_divided(const NetPlan& plan, std::size_t nodes) {
  const Gear gear = make_gear(plan, Extent::whole);
  Fineness fineness;
  fineness.nodes = nodes;
  try {
    return draw_mesh(plan, gear, divide(gear, fineness));
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace

int draw_command(const Options& options) {
  Terminal terminal(options.color);
  Diagnostics diagnostics;
  NetPlan plan = read_plan(options.target, options.set, diagnostics);
  if (diagnostics.errors() == 0) check_plan(plan, diagnostics);
  if (diagnostics.errors() + diagnostics.warnings() > 0) terminal.say(diagnostics.render(terminal.color()));
  if (diagnostics.errors()) {
    if (options.json) std::puts(errors_json(diagnostics, kWrongInput).c_str());
    return kWrongInput;
  }
  const std::string output = output_of(options);
  check_output(output, plan);
  write_whole(output, options.mesh ? draw_divided(plan, options.mesh_nodes) : draw_plan(plan));
  terminal.say("written to " + output);
  return kDone;
}

}  // namespace netloft::io
