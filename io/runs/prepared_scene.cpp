// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/prepared_scene.hpp"

#include "framework/balance/work.hpp"
#include "framework/search/settings.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/runs/idle_choices.hpp"
#include "io/runs/inertia.hpp"
#include "io/runs/material_damping.hpp"
#include "io/runs/meshes.hpp"
#include "io/runs/stretch_damping.hpp"
#include "solvers/factorisation/kept_analyses.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

namespace netloft::runs {

namespace {

bool moves(const scenes::Analysis& analysis) {
  return analysis.kind == AnalysisKind::dynamics || analysis.settles;
}

/// Throws SceneError for bodies and nodes without the inertia that a motion needs.
void require_inertia(const scenes::LoadedScene& loaded, const ScenePlan& plan, Registry& registry,
                     Assembler& assembler) {
  const bool is_explicit = registry.integrator(loaded.analysis.dynamics.integrator).is_explicit();
  auto faults = find_missing_inertia(loaded.scene, plan, registry, assembler, is_explicit);
  if (!faults.empty()) throw SceneError(std::move(faults));
}

}  // namespace

PreparedScene::PreparedScene(CaseSource source, Registry& registry, MakeFactorisation make)
    : source_(std::move(source)),
      registry_(registry),
      make_(make ? std::move(make) : keep_analyses(make_factorisation_with(source_.threads))) {}

PreparedScene::~PreparedScene() = default;

PreparedScene::State PreparedScene::prepare(const std::function<void(scenes::LoadedScene&)>& change) {
  const std::string file = source_.scene.file().string();
  const formats::LongWork work({"reading", file});
  if (const State state = read(); state != State::ready) return state;
  if (change) change(loaded_);
  formats::report({"assembling", loaded_.scene.name, loaded_.scene.node_count(), "nodes"});
  return assemble();
}

PreparedScene::State PreparedScene::prepare_like(const PreparedScene& other) {
  if (const State state = read(&other); state != State::ready) return state;
  return assemble(&other);
}

PreparedScene::State PreparedScene::read(const PreparedScene* like) {
  Timed timed(seconds_.reading);
  bool refused = false;
  loaded_ = source_.scene.instance(source_.changes, registry_, diagnostics_, refused,
                                   like && like->loaded_.gear ? like->loaded_.gear->division : nullptr);
  if (!diagnostics_.errors()) return State::ready;
  return refused ? State::refused : State::wrong_input;
}

PreparedScene::State PreparedScene::assemble(const PreparedScene* like) {
  Timed timed(seconds_.setup);
  try {
    plan_terms();
    warn_of_idle_choices(loaded_, plan_, diagnostics_);
    plan_.not_loaded = unused();
    assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, source_.threads,
                                             like ? like->assembler_.get() : nullptr);
    meshes_ = std::make_unique<Meshes>(source_, loaded_, registry_);
    if (moves(loaded_.analysis)) require_inertia(loaded_, plan_, registry_, *assembler_);
  } catch (const SceneError& error) {
    for (const auto& fault : error.faults) diagnostics_.error(loaded_.place_of(fault.part), fault.message);
    return State::wrong_input;
  }
  return State::ready;
}

/// Sets the damping that the analysis uses, and then decides which forces (terms) it evaluates.
void PreparedScene::plan_terms() {
  const scenes::Analysis& analysis = loaded_.analysis;
  const scenes::Dynamics& dynamics = analysis.dynamics;
  const bool is_motion = moves(analysis);
  if (is_motion && dynamics.stiffness_damping > 0)
    damp_stretch(loaded_.scene, registry_, dynamics.stiffness_damping);
  material_damping_ = choose_material_damping(loaded_.scene, analysis, registry_);
  plan_ = make_scene_plan(loaded_.scene, registry_, analysis.tangent,
                          is_motion ? AnalysisKind::dynamics : AnalysisKind::statics);
  if (!is_motion && plan_.conservative) take_out_losses(loaded_.scene, registry_);
  if (is_motion && registry_.integrator(dynamics.integrator).asks_mean_forces())
    use_mean_forces(plan_, dynamics.integrator);
}

/// Plugins that provide neither elements of this scene nor its solver, integrator or strategy.
std::vector<std::string> PreparedScene::unused() const {
  const scenes::Analysis& analysis = loaded_.analysis;
  std::vector<std::string> names = unused_plugins(plan_, registry_);
  if (!analysis.settles) std::erase(names, registry_.solver(analysis.solver).origin->name);
  if (moves(analysis))
    std::erase(names, registry_.integrator(analysis.dynamics.integrator).origin->name);
  else
    std::erase(names, registry_.strategy(analysis.strategy).origin->name);
  return names;
}

VariantSource PreparedScene::variants() {
  return {&loaded_.scene, assembler_.get(),         &registry_,     meshes_.get(),
          make_,          loaded_.analysis.tangent, source_.threads};
}

void PreparedScene::adopt(const Solution& s) {
  if (s.factors.empty()) return;
  set_factors(loaded_.scene, s.factors);
  for (const Setting& setting : loaded_.scene.settings) set_length_in_bill(setting);
  assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, source_.threads);
  if (s.status == SolveStatus::converged) assembler_->remember(s.x);
}

/// Sets the length of a rope in the bill of materials to the value that the search found.
void PreparedScene::set_length_in_bill(const Setting& setting) {
  if (!loaded_.gear) return;
  for (scenes::BillItem& item : loaded_.gear->bill)
    if (setting.part == item.name || setting.part == "starboard-" + item.name)
      item.length = amount_of(loaded_.scene, setting);
}

}  // namespace netloft::runs
