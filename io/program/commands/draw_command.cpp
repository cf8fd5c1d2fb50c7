// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/journal.hpp"
#include "io/gears/drawing/drawing.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "io/program/commands/draw_polars.hpp"
#include "io/program/session/commands.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/terminal.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace netloft::program {

namespace {

/// A result by its name, or by the first bytes of the file.
bool is_result(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".hdf" || formats::is_journal(path)) return true;
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;  // reading a pipe waits for ever
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> start{};
  return file.read(start.data(), start.size()) && std::string_view(start.data(), 4) == "\x89HDF";
}

std::string output_of(const Options& options) {
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.target).stem().string() + ".svg";
}

std::vector<std::string> files_of(const gears::NetPlan& plan) {
  std::vector<std::string> paths;
  for (const auto& file : plan.files) paths.push_back(file.path);
  return paths;
}

/// Says what is wrong with a file; the code to end with where that is an error.
int say(const formats::Diagnostics& diagnostics, const Options& options, Terminal& terminal) {
  if (diagnostics.errors() + diagnostics.warnings() > 0) terminal.say(diagnostics.render(terminal.color()));
  if (diagnostics.errors() == 0) return kDone;
  if (options.json) std::puts(errors_json(diagnostics, kWrongInput).c_str());
  return kWrongInput;
}

int draw_polars_command(const Options& options) {
  Terminal terminal(options.color);
  formats::Diagnostics diagnostics;
  const std::string output = output_of(options);
  const std::string picture = draw_polars(options.target, output.ends_with(".html"), diagnostics);
  if (const int code = say(diagnostics, options, terminal); code != kDone) return code;
  replace_file(output, picture, {options.target}, {".svg", ".html"});
  terminal.say("written to " + output);
  return kDone;
}

std::string draw_divided(const gears::NetPlan& plan, std::size_t nodes) {
  const gears::Gear gear = gears::make_gear(plan, gears::Extent::whole);
  gears::Fineness fineness;
  fineness.nodes = nodes;
  try {
    return gears::draw_mesh(plan, gear, gears::divide(gear, fineness));
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace

int draw_command(const Options& options) {
  if (is_result(options.target)) {
    refuse_idle(options, {"--set", "--plugins", "--mesh", "--nodes"}, options.target + " is a result");
    return draw_result_command(options);
  }
  const std::vector<std::string> of_results = {"--view", "--field", "--state",    "--width",     "--fit",
                                               "--dark", "--log",   "--elements", "--dimensions"};
  if (holds_polars(options.target)) {
    auto idle = of_results;
    idle.insert(idle.end(), {"--set", "--plugins", "--mesh", "--nodes"});
    refuse_idle(options, idle, options.target + " holds polars");
    return draw_polars_command(options);
  }
  refuse_idle(options, of_results, options.target + " is a net plan");
  Terminal terminal(options.color);
  formats::Diagnostics diagnostics;
  gears::NetPlan plan = gears::read_plan(options.target, options.set, diagnostics);
  if (diagnostics.errors() == 0) gears::check_plan(plan, diagnostics);
  if (const int code = say(diagnostics, options, terminal); code != kDone) return code;
  const std::string output = output_of(options);
  replace_file(output, options.mesh ? draw_divided(plan, options.mesh_nodes) : gears::draw_plan(plan),
               files_of(plan), {".svg"});
  terminal.say("written to " + output);
  return kDone;
}

}  // namespace netloft::program
