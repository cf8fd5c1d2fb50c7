// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/session.hpp"

#include "io/cli/error_json.hpp"
#include "io/scene/read_scene.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>
#include <thread>

namespace netloft::io {

namespace {

/// Letters, digits, '_' and '-', and between them one slash.
bool is_component_name(const std::string& name) {
  const auto is_word = [](std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
      return std::isalnum(c) || c == '_' || c == '-';
    });
  };
  const auto slash = name.find('/');
  return is_word(std::string_view(name).substr(0, slash)) &&
         (slash == std::string::npos || is_word(std::string_view(name).substr(slash + 1)));
}

}  // namespace

int threads_for(const Options& options) {
  if (options.threads > 0) return options.threads;
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

Session::Session(const Options& options) : options_(options), terminal_(options.color) {
  find_plugins(options, registry_);
}

/// --set, and --solver as what it stands for: "newton:method=classic" is analysis.solver and
/// analysis.newton.method.
std::vector<std::string> Session::overrides() const {
  std::vector<std::string> all = options_.set;
  if (options_.solver.empty()) return all;
  const auto refuse = [&](const std::string& why) {
    throw UsageError{"--solver " + options_.solver + ": " + why +
                     "; write NAME or NAME:key=value,key=value, such as newton:method=classic"};
  };
  const auto colon = options_.solver.find(':');
  const std::string name = options_.solver.substr(0, colon);
  if (!is_component_name(name)) refuse("\"" + name + "\" is no name of a solver");
  all.push_back("analysis.solver=\"" + name + "\"");
  if (colon == std::string::npos) return all;
  if (colon + 1 == options_.solver.size()) refuse("nothing follows the colon");
  std::istringstream pairs(options_.solver.substr(colon + 1));
  for (std::string pair; std::getline(pairs, pair, ',');) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size())
      refuse("\"" + pair + "\" is not key=value");
    all.push_back("analysis." + name.substr(0, name.find('/')) + "." + pair);
  }
  return all;
}

int Session::open() {
  if (const int code = read(); code != kDone) return code;
  return assemble();
}

int Session::read() {
  Timed timed(reading_seconds_);
  bool refused = false;
  loaded_ = read_scene(options_.target, overrides(), registry_, diagnostics_, refused);
  if (diagnostics_.errors()) return report(refused ? kRefused : kWrongInput);
  return kDone;
}

int Session::assemble() {
  Timed timed(setup_seconds_);
  try {
    plan_ = make_plan(loaded_.scene, registry_, loaded_.analysis.tangent);
    std::erase(plan_.not_loaded, registry_.solver(loaded_.analysis.solver).origin->name);
    assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, threads_for(options_));
  } catch (const SceneError& error) {
    add_faults(error);
    return report(kWrongInput);
  }
  if (diagnostics_.warnings()) terminal_.say(diagnostics_.render(terminal_.color()));
  return kDone;
}

void Session::add_faults(const SceneError& error) {
  for (const auto& fault : error.faults) diagnostics_.error(loaded_.place_of(fault.part), fault.message);
}

int Session::report(int code) {
  terminal_.say(diagnostics_.render(terminal_.color()));
  if (options_.json) std::puts(errors_json(diagnostics_, code).c_str());
  return code;
}

PlanExtras Session::plan_extras() const {
  const auto factorisation = make_factorisation(plan_.symmetric);
  return {loaded_.analysis.solver, factorisation->description(), assembler_->pattern().entries(),
          threads_for(options_), assembler_->threads_used()};
}

}  // namespace netloft::io
