// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/session.hpp"

#include "io/program/session/error_json.hpp"
#include "io/program/session/print.hpp"
#include "io/runs/equilibrium.hpp"

#include <algorithm>
#include <stdexcept>
#include <thread>

namespace netloft::program {

std::vector<std::string> paths_of(const scenes::LoadedScene& loaded) {
  std::vector<std::string> paths;
  for (const auto& file : loaded.files) paths.push_back(file.path);
  return paths;
}

int threads_for(int threads) {
  return threads > 0 ? threads : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

void refuse_undone(const std::vector<std::string>& set) {
  const auto changes = formats::read_changes(set);
  for (std::size_t later = 1; later < changes.size(); ++later)
    for (std::size_t i = 0; i < later; ++i)
      if (formats::undoes(changes[later], changes[i])) {
        if (changes[later].steps != changes[i].steps)
          throw UsageError{"--set " + set[later] + " undoes --set " + set[i] + "; leave out one of them"};
        print_error("netloft: --set " + set[later] + " replaces --set " + set[i]);
      }
}

runs::CaseSource source_of(const SceneOptions& options) {
  refuse_undone(options.set);
  return {options.scene, options.set, threads_for(options.threads)};
}

runs::CaseSource source_of(const MethodOptions& options) {
  runs::CaseSource source = source_of(static_cast<const SceneOptions&>(options));
  const auto add = [&](const char* key, const std::string& specification) {
    if (specification.empty()) return;
    const auto chosen = runs::choose_method(key, specification);
    for (const formats::Change& change : chosen)
      for (const std::string& set : options.set)
        if (formats::undoes(change, formats::read_change(set)))
          throw UsageError{std::string("--") + key + " " + specification + " undoes --set " + set +
                           "; leave out one of them"};
    formats::append(source.changes, chosen);
  };
  try {
    add("strategy", options.strategy);
    add("solver", options.solver);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
  return source;
}

Session::Session(const MethodOptions& options) : Session(options, source_of(options)) {}

Session::Session(const MethodOptions& options, runs::CaseSource source)
    : terminal_(options), names_strategy_(!options.strategy.empty()), scene_(std::move(source), registry_) {
  find_scene_plugins(options, registry_);
}

int Session::open() {
  const runs::PreparedScene::State state = scene_.prepare();
  const formats::Diagnostics& diagnostics = scene_.diagnostics();
  if (state != runs::PreparedScene::State::ready) return report_unready(diagnostics, state, terminal_);
  const scenes::Analysis& analysis = scene_.loaded().analysis;
  if (names_strategy_ && analysis.kind == AnalysisKind::dynamics && !analysis.dynamics.from_equilibrium)
    throw UsageError{
        "--strategy finds equilibria, and this motion does not begin at an equilibrium; with --set "
        "analysis.start=equilibrium it does"};
  if (diagnostics.warnings()) terminal_.say(diagnostics);
  return kDone;
}

int report_unready(const formats::Diagnostics& diagnostics, runs::PreparedScene::State state,
                   Terminal& terminal) {
  terminal.say(diagnostics);
  const int code = state == runs::PreparedScene::State::refused ? kRefused : kWrongInput;
  if (terminal.json()) print_line(errors_json(diagnostics, code));
  return code;
}

results::PlanExtras plan_extras(runs::PreparedScene& scene) {
  const ScenePlan& plan = scene.plan();
  const scenes::Analysis& analysis = scene.loaded().analysis;
  const auto factorisation =
      scene.factorisations()(plan.symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  return {analysis.solver,
          factorisation->description(),
          scene.assembler().pattern().entries(),
          scene.source().threads,
          scene.assembler().threads_used(),
          analysis.strategy,
          runs::explain_strategy(scene),
          plan.kind == AnalysisKind::dynamics ? scene.material_damping() : "",
          0,
          0,
          0};
}

}  // namespace netloft::program
