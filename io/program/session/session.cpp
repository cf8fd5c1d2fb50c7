// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/session.hpp"

#include "io/program/session/error_json.hpp"
#include "io/runs/equilibrium.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

namespace netloft::program {

std::vector<std::string> paths_of(const scenes::LoadedScene& loaded) {
  std::vector<std::string> paths;
  for (const auto& file : loaded.files) paths.push_back(file.path);
  return paths;
}

int threads_for(const Options& options) {
  if (options.threads > 0) return options.threads;
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

runs::CaseSource source_of(const Options& options) {
  runs::CaseSource source{options.target, options.set, threads_for(options)};
  const auto add = [&](const char* key, const std::string& specification) {
    if (specification.empty()) return;
    for (auto& word : runs::overrides_of(key, specification)) source.overrides.push_back(std::move(word));
  };
  try {
    add("strategy", options.strategy);
    add("solver", options.solver);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
  return source;
}

Session::Session(const Options& options)
    : options_(options), terminal_(options.color, options.json), scene_(source_of(options), registry_) {
  find_plugins(options, registry_);
}

int Session::open() {
  const runs::PreparedScene::State state = scene_.prepare();
  const formats::Diagnostics& diagnostics = scene_.diagnostics();
  if (state != runs::PreparedScene::State::ready)
    return tell_why_not(diagnostics, state, options_, terminal_);
  if (diagnostics.warnings()) terminal_.say(diagnostics.render(terminal_.color()));
  return kDone;
}

int tell_why_not(const formats::Diagnostics& diagnostics, runs::PreparedScene::State state,
                 const Options& options, Terminal& terminal) {
  terminal.say(diagnostics.render(terminal.color()));
  const int code = state == runs::PreparedScene::State::refused ? kRefused : kWrongInput;
  if (options.json) std::puts(errors_json(diagnostics, code).c_str());
  return code;
}

results::PlanExtras Session::plan_extras() {
  const auto factorisation =
      scene_.factorisations()(plan().symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  return {loaded().analysis.solver,
          factorisation->description(),
          assembler().pattern().entries(),
          threads_for(options_),
          assembler().threads_used(),
          loaded().analysis.strategy,
          runs::explain_strategy(scene_),
          plan().kind == AnalysisKind::dynamics ? scene_.material_damping() : "",
          0,
          0,
          0};
}

}  // namespace netloft::program
