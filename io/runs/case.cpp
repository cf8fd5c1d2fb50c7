// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/case.hpp"

#include "framework/balance/work.hpp"
#include "framework/judging/correction.hpp"
#include "framework/motion/settling.hpp"
#include "framework/search/settings.hpp"
#include "io/runs/diagnosis.hpp"
#include "io/runs/idle_choices.hpp"
#include "io/runs/inertia.hpp"
#include "io/runs/material_damping.hpp"
#include "io/runs/meshes.hpp"
#include "io/runs/stretch_damping.hpp"
#include "io/scenes/reading/halves.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/read_scene.hpp"
#include "solvers/factorisation/kept_analyses.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace netloft::runs {

namespace {

/// Throws SceneError for what a motion cannot move.
void require_inertia(const scenes::LoadedScene& loaded, const ScenePlan& plan, Registry& registry,
                     Assembler& assembler) {
  const bool is_explicit = registry.integrator(loaded.analysis.dynamics.integrator).is_explicit();
  auto faults = find_missing_inertia(loaded.scene, plan, registry, assembler, is_explicit);
  if (!faults.empty()) throw SceneError(std::move(faults));
}

constexpr int kFromElsewhere = 100;  // iterations from a point that a user names, before it is given up

}  // namespace

Case::Case(CaseSource source, Registry& registry, MakeFactorisation make)
    : source_(std::move(source)),
      registry_(registry),
      make_(make ? std::move(make) : keep_analyses(make_factorisation_with(source_.threads))) {}

Case::~Case() = default;

Case::State Case::open(const std::function<void(scenes::LoadedScene&)>& change) {
  if (const State state = read(); state != State::ready) return state;
  if (change) change(loaded_);
  return assemble();
}

Case::State Case::read() {
  Timed timed(reading_seconds_);
  bool refused = false;
  loaded_ = scenes::read_scene(source_.file, source_.overrides, registry_, diagnostics_, refused);
  if (!diagnostics_.errors()) return State::ready;
  return refused ? State::refused : State::wrong_input;
}

Case::State Case::assemble() {
  Timed timed(setup_seconds_);
  try {
    const scenes::Analysis& analysis = loaded_.analysis;
    const bool moves = analysis.kind == AnalysisKind::dynamics || analysis.settles;
    if (moves && analysis.dynamics.stiffness_damping > 0)
      damp_stretch(loaded_.scene, registry_, analysis.dynamics.stiffness_damping);
    material_damping_ = choose_material_damping(loaded_.scene, analysis, registry_);
    plan_ = make_scene_plan(loaded_.scene, registry_, analysis.tangent,
                            moves ? AnalysisKind::dynamics : AnalysisKind::statics);
    if (!moves && plan_.conservative) take_out_losses(loaded_.scene, registry_);
    if (moves && registry_.integrator(analysis.dynamics.integrator).asks_mean_forces())
      ask_mean_forces(plan_, analysis.dynamics.integrator);
    warn_of_idle_choices(loaded_, plan_, diagnostics_);
    plan_.not_loaded = unused_plugins(plan_, registry_);
    if (!analysis.settles) std::erase(plan_.not_loaded, registry_.solver(analysis.solver).origin->name);
    if (!moves) std::erase(plan_.not_loaded, registry_.strategy(analysis.strategy).origin->name);
    if (moves) std::erase(plan_.not_loaded, registry_.integrator(analysis.dynamics.integrator).origin->name);
    assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, source_.threads);
    meshes_ = std::make_unique<Meshes>(source_, loaded_, registry_);
    if (moves) require_inertia(loaded_, plan_, registry_, *assembler_);
  } catch (const SceneError& error) {
    for (const auto& fault : error.faults) diagnostics_.error(loaded_.place_of(fault.part), fault.message);
    return State::wrong_input;
  }
  return State::ready;
}

namespace {

/// Says how long may be solved, and in the end that this is over.
class AllowedTime {
 public:
  AllowedTime(const Watch& watch, double seconds) : watch_(watch) { say(seconds); }
  ~AllowedTime() { say(std::numeric_limits<double>::infinity()); }
  AllowedTime(const AllowedTime&) = delete;
  AllowedTime& operator=(const AllowedTime&) = delete;

 private:
  void say(double seconds) const {
    if (watch_.on_budget) watch_.on_budget(seconds);
  }
  const Watch& watch_;
};

/// Half a gear that has passed through its mirror image balances as no whole gear does: such an equilibrium
/// of the scene is none of the gear. What is held beyond the plane was meant to be there.
void object_to_crossings(const scenes::LoadedScene& loaded, const Assembler& assembler, Solution& s) {
  if (!is_stationary(s) || !loaded.gear || loaded.gear->times != 2) return;
  for (const scenes::Crossing& crossing : scenes::find_crossings(loaded, assembler.node_positions(s.x)))
    if (!crossing.is_held) {
      s.status = SolveStatus::not_converged;
      s.at_fault = loaded.scene.parts[crossing.part].name;
      s.reason = crossing.sentence + ". No whole gear lies so; start it elsewhere, or solve it as a whole";
    }
}

}  // namespace

Solution Case::solve(const Watch& watch, const std::vector<double>& from) {
  const AllowedTime allowed(watch, loaded_.analysis.limits.seconds);
  Solution s = loaded_.analysis.settles
                   ? settle(watch, from)
                   : netloft::find_equilibrium(variants(), search_options(loaded_.analysis.limits, watch),
                                               strategy(), from);
  adopt(s);
  object_to_crossings(loaded_, *assembler_, s);
  if (s.status != SolveStatus::converged) s.diagnostics = diagnose(loaded_.scene, *assembler_, s);
  return s;
}

Solution Case::continue_from(const std::vector<double>& u, int iterations, const Watch& watch) {
  if (loaded_.analysis.settles) return solve(watch, u);  // by a motion, which begins there at rest
  const AllowedTime allowed(watch, loaded_.analysis.limits.seconds);
  Limits limits = loaded_.analysis.limits;
  limits.iterations = std::min(limits.iterations, iterations);
  const StrategyUse alone{&registry_.strategy(scenes::kStrategyOfNamedSolver), {}};
  Solution s = netloft::find_equilibrium(variants(), search_options(limits, watch), alone, u);
  adopt(s);
  object_to_crossings(loaded_, *assembler_, s);
  return s;
}

/// A solution of the scene with other factors is of that scene from now on.
void Case::adopt(const Solution& s) {
  if (s.factors.empty()) return;
  set_factors(loaded_.scene, s.factors);
  for (const Setting& setting : loaded_.scene.settings) note_length(setting);
  assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, source_.threads);
  if (s.status == SolveStatus::converged) assembler_->remember(s.x);
}

/// The bill of materials lists the rope that was found.
void Case::note_length(const Setting& setting) {
  if (!loaded_.gear) return;
  for (scenes::BillItem& item : loaded_.gear->bill)
    if (setting.part == item.name || setting.part == "starboard-" + item.name)
      item.length = amount_of(loaded_.scene, setting);
}

Solution Case::solve_from(const std::vector<double>& u, const Watch& watch) {
  if (loaded_.analysis.settles) return solve(watch, u);  // by a motion, which begins there at rest
  const auto is_answer = [](const Solution& s) {
    return s.status == SolveStatus::converged || s.status == SolveStatus::interrupted;
  };
  Solution found = continue_from(u, kFromElsewhere, watch);
  const auto solve_after_it = [&](const std::vector<double>& from) {
    Solution next = solve(watch, from);
    next.cost.add_before(found.cost);
    found = std::move(next);
  };
  if (found.status == SolveStatus::unstable) solve_after_it(std::vector(found.u));
  if (!is_answer(found)) solve_after_it({});
  return found;
}

// What a scene leaves open (Scene::settings) would have to move as well.
std::optional<std::vector<double>> Case::tangent_towards(Case& near, const std::vector<double>& x,
                                                         Statistics& spent) {
  if (loaded_.analysis.settles || !loaded_.scene.settings.empty()) return std::nullopt;
  StaticProblem here(*assembler_, make_, {}), there(*near.assembler_, make_, {});
  const std::vector<double> u = assembler_->displacements_to(x), v = near.assembler_->displacements_to(x);
  std::vector<double> at, r, r_near, du(u.size());
  double energy = 0;
  if (!here.recompute(u, at, r, energy) || !there.recompute(v, at, r_near, energy)) return std::nullopt;
  for (std::size_t i = 0; i < r.size(); ++i) r_near[i] -= r[i];
  const bool is_found = find_correction(here, u, r_near, du);  // (1)
  spent.add(here.statistics());
  spent.add(there.statistics());
  if (!is_found) return std::nullopt;
  for (std::size_t i = 0; i < v.size(); ++i) du[i] += v[i];
  std::vector<double> dx = there.positions(du);
  for (std::size_t i = 0; i < x.size(); ++i) dx[i] -= x[i];
  return dx;
}

bool Case::has_topology_of(Case& other) {
  return assembler().numbering().dofs() == other.assembler().numbering().dofs() &&
         assembler().pattern() == other.assembler().pattern();
}

Solution Case::judge(std::span<const double> u, Assembler& assembler) const {
  Limits limits = loaded_.analysis.limits;
  limits.judging.ask_growth = false;
  Solution s;
  static_cast<Assessment&>(s) = assess_static({loaded_.scene, assembler, make_}, u, limits);
  s.u.assign(u.begin(), u.end());
  return s;
}

std::unique_ptr<Assembler> Case::make_another_assembler() const {
  return std::make_unique<Assembler>(loaded_.scene, plan_, 1);
}

std::optional<std::string> Case::why_unfit() {
  if (loaded_.analysis.settles || loaded_.analysis.kind != AnalysisKind::statics) return {};
  return netloft::why_unfit(registry_.solver(loaded_.analysis.solver), traits_of(*assembler_));
}

std::string Case::explain_strategy() {
  if (loaded_.analysis.settles) return "";
  return netloft::explain_strategy(variants(), search_options(loaded_.analysis.limits, {}), strategy());
}

VariantSource Case::variants() {
  return {&loaded_.scene, assembler_.get(),         &registry_,     meshes_.get(),
          make_,          loaded_.analysis.tangent, source_.threads};
}

SearchOptions Case::search_options(const Limits& limits, const Watch& watch) {
  SearchOptions options;
  options.solver = {&registry_.solver(loaded_.analysis.solver), loaded_.analysis.solver_parameters};
  options.limits = limits;
  options.limits.interrupt = watch.interrupt;
  options.given = loaded_.analysis.given;
  options.kept = watch.kept;
  options.work = loaded_.analysis.work;
  options.on_iteration = watch.on_iteration;
  options.on_stage = watch.on_stage;
  return options;
}

StrategyUse Case::strategy() {
  return {&registry_.strategy(loaded_.analysis.strategy), loaded_.analysis.strategy_parameters};
}

namespace {

/// A table of parameters as a plugin wants it. What a scene was read with is right; else
/// std::invalid_argument.
ParameterBlock block_of(std::span<const netloft_parameter> table, std::size_t bytes, const Values& values) {
  std::vector<std::string> faults;
  ParameterBlock block(table, bytes, values, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return block;
}

constexpr const char* kStepSolver =
    "chord";  // of the implicit steps of an integrator that is itself a solver
constexpr Limits kStepLimits{1e-8, 25, std::numeric_limits<double>::infinity(), nullptr};
constexpr double kLeastUnit = 1e8;   // of work in time [operations]: some 5 ms, an iteration of 1000 nodes
constexpr double kStepsFiner = 0.1;  // tolerance of steps over that of the equilibrium they are to find

WorkModel work_of_steps(const Assembler& assembler, const MakeFactorisation& make) {
  WorkModel model = make_work_model(assembler, make);
  model.unit = std::max(model.unit, kLeastUnit);
  return model;
}

}  // namespace

Solution Case::settle(const Watch& watch, const std::vector<double>& from) {
  const scenes::Dynamics& d = loaded_.analysis.dynamics;
  const IntegratorType& integrator = registry_.integrator(d.integrator);
  const SolverType& solver = registry_.solver(kStepSolver);
  const auto scheme =
      block_of(integrator.parameters, integrator.integrator.parameter_bytes, d.integrator_parameters);
  const auto steps = block_of(solver.parameters, solver.solver.parameter_bytes, {});
  const AssembledScene scene{loaded_.scene, *assembler_, make_};
  Settling settling{scene, {{&integrator, scheme.data()}, {&solver, steps.data()}}, kStepLimits, d.march};
  settling.limits.interrupt = watch.interrupt;
  settling.limits.tolerance =
      std::min(kStepLimits.tolerance, kStepsFiner * loaded_.analysis.limits.tolerance);
  Limits limits = loaded_.analysis.limits;
  limits.interrupt = watch.interrupt;
  settling.limits.seconds = limits.seconds;
  const WorkModel model = work_of_steps(*assembler_, make_);
  settling.limits.model = &model;
  settling.limits.work = loaded_.analysis.work;
  const SolverType as_solver = settling.as_solver();
  Solution s = solve_static(scene, {&as_solver, &settling}, limits, {from}, {watch.on_iteration, watch.kept});
  if (s.status == SolveStatus::converged) assembler_->remember(s.x);
  return s;
}

MarchResult Case::march(const MarchWatch& watch, const Watch& who, const MarchState* from, double work) {
  const scenes::Analysis& a = loaded_.analysis;
  const IntegratorType& integrator = registry_.integrator(a.dynamics.integrator);
  const SolverType& solver = registry_.solver(a.solver);
  const auto scheme = block_of(integrator.parameters, integrator.integrator.parameter_bytes,
                               a.dynamics.integrator_parameters);
  const auto steps = block_of(solver.parameters, solver.solver.parameter_bytes, a.solver_parameters);
  Limits limits = a.limits;
  limits.interrupt = who.interrupt;
  std::optional<WorkModel> model;
  if (std::isfinite(work)) {
    model = work_of_steps(*assembler_, make_);
    limits.model = &*model;
    limits.work = work;
  }
  assert(from || a.dynamics.start_file.empty());  // who marches reads the result
  std::optional<MarchState> at_rest;
  std::string remark;
  if (!from && a.dynamics.from_equilibrium) {
    Solution s;
    const std::vector<double> u = find_start(who, s);
    if (s.status == SolveStatus::unstable)
      remark = "; it began at an equilibrium that is not stable: " + s.reason;
    else if (s.status != SolveStatus::converged) {
      MarchResult none;
      none.reason = "there is no equilibrium to start from: " + s.reason;
      none.u = u;
      return none;
    }
    from = &at_rest.emplace(state_at_rest(*assembler_, u));
    at_rest->winches = Winches::state_at_rest(s.factors);
  }
  MarchResult result = netloft::march({loaded_.scene, *assembler_, make_},
                                      {{&integrator, scheme.data()}, {&solver, steps.data()}}, limits,
                                      a.dynamics.march, watch, from);
  result.reason += remark;
  return result;
}

/// As a static analysis of the same scene: forces, tangent, tolerance, solver. A motion may leave out parts
/// of the tangent and still swing about what statics find with all of it. Both number their unknowns alike.
std::vector<double> Case::find_start(const Watch& who, Solution& found) {
  const ScenePlan plan = make_scene_plan(loaded_.scene, registry_);
  Assembler assembler(loaded_.scene, plan, source_.threads);
  assert(assembler.pattern().size == assembler_->pattern().size);
  VariantSource source = variants();
  source.assembler = &assembler;
  source.tangent = TangentChoice::exact;
  Limits limits;
  limits.seconds = loaded_.analysis.limits.seconds;
  limits.judging.accept_swinging = loaded_.analysis.limits.judging.accept_swinging;
  SearchOptions options =
      search_options(limits, {.interrupt = who.interrupt, .on_iteration = who.on_iteration});
  options.solver = {&registry_.solver(scenes::kSolver), {}};
  found = netloft::find_equilibrium(source, options, strategy());
  object_to_crossings(loaded_, assembler, found);
  if (found.status == SolveStatus::converged || found.status == SolveStatus::unstable) remember(found.u);
  return found.u;
}

void Case::remember(std::span<const double> u) {
  std::vector<double> x(assembler_->start());
  assembler_->place(u, x);
  assembler_->remember(x);
}

}  // namespace netloft::runs
