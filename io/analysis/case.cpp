// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/case.hpp"

#include "framework/continuation/journey.hpp"
#include "framework/problem/settling.hpp"
#include "io/analysis/coarser.hpp"
#include "io/analysis/cone_use.hpp"
#include "io/analysis/diagnosis.hpp"
#include "io/analysis/stretch_damping.hpp"
#include "io/analysis/tension_cones.hpp"
#include "io/analysis/tension_stages.hpp"
#include "io/scene/read_scene.hpp"
#include "solvers/factorisation/factorisation.hpp"
#include "solvers/factorisation/kept_analyses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace netloft::io {

namespace {

// Below so many unknowns a coarser mesh costs as much as it saves; it need not be solved better than this.
constexpr std::size_t kSmall = 200;
constexpr double kCoarseTolerance = 1e-3;
// Newton's first damping from a coarser mesh, times unknowns, and at most: what linear elements leave falls
// with their area. Hanging panels of 224, 256, 288, 320 cells across took 24, 27, 42, 35 factorisations on
// their own mesh with 0.1 throughout, and 24, 22, 26, 27 so.
constexpr double kDampingNearby = 110, kMostDampingNearby = 0.1;

/// "tension only" → "tension only, elements x 2" → "tension only, elements x 4": how much longer they are.
std::string on_coarser(const std::string& leg) {
  constexpr std::string_view kLonger = ", elements x ";
  const auto at = leg.rfind(kLonger);
  if (at == leg.npos) return leg + std::string(kLonger) + "2";
  return leg.substr(0, at + kLonger.size()) + std::to_string(2 * std::stoi(leg.substr(at + kLonger.size())));
}

/// Moves the free nodes; what is held starts where it is held.
void set_start(Scene& scene, const std::vector<double>& positions) {
  for (std::size_t d = 0; d < positions.size(); ++d)
    if (scene.held[d / 3] == 0) scene.positions[d] = positions[d];
}

}  // namespace

Case::Case(CaseSource source, Registry& registry)
    : source_(std::move(source)), registry_(registry), make_(keep_analyses(make_factorisation)) {}

Case::State Case::open(const std::function<void(LoadedScene&)>& change) {
  if (const State state = read(); state != State::ready) return state;
  if (change) change(loaded_);
  return assemble();
}

Case::State Case::read() {
  Timed timed(reading_seconds_);
  bool refused = false;
  loaded_ = read_scene(source_.file, source_.overrides, registry_, diagnostics_, refused);
  if (!diagnostics_.errors()) return State::ready;
  return refused ? State::refused : State::wrong_input;
}

Case::State Case::assemble() {
  Timed timed(setup_seconds_);
  try {
    const Analysis& analysis = loaded_.analysis;
    const bool moves = analysis.kind == AnalysisKind::dynamics || analysis.settles;
    if (moves && analysis.dynamics.stiffness_damping > 0)
      damp_stretch(loaded_.scene, registry_, analysis.dynamics.stiffness_damping);
    plan_ = make_plan(loaded_.scene, registry_, analysis.tangent,
                      moves ? AnalysisKind::dynamics : AnalysisKind::statics);
    plan_.not_loaded = unused_plugins(plan_, registry_);
    if (!analysis.settles) std::erase(plan_.not_loaded, registry_.solver(analysis.solver).origin->name);
    if (moves) std::erase(plan_.not_loaded, registry_.integrator(analysis.dynamics.integrator).origin->name);
    assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, source_.threads);
  } catch (const SceneError& error) {
    for (const auto& fault : error.faults) diagnostics_.error(loaded_.place_of(fault.part), fault.message);
    return State::wrong_input;
  }
  return State::ready;
}

Solution Case::solve(const Watch& watch) {
  Solution s = loaded_.analysis.settles                                       ? settle(watch)
               : loaded_.analysis.continuation || loaded_.analysis.looks != 0 ? solve_by_journey(watch)
                                                                              : solve_plainly(watch);
  if (s.status != SolveStatus::converged) s.signs = diagnose(loaded_.scene, *assembler_, s);
  return s;
}

Solution Case::solve_plainly(const Watch& watch) {
  const SolverType& solver = registry_.solver(loaded_.analysis.solver);
  std::vector<std::string> faults;
  const ParameterBlock parameters(solver.parameters, solver.solver.parameter_bytes,
                                  loaded_.analysis.solver_parameters, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  Limits limits = loaded_.analysis.limits;
  limits.interrupt = watch.interrupt;
  return solve_static(loaded_.scene, *assembler_, solver, parameters.data(), limits, make_,
                      watch.on_iteration);
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
constexpr double kStepsFiner = 0.1;  // tolerance of steps over that of the equilibrium they are to find

}  // namespace

Solution Case::settle(const Watch& watch) {
  const Dynamics& d = loaded_.analysis.dynamics;
  const IntegratorType& integrator = registry_.integrator(d.integrator);
  const SolverType& solver = registry_.solver(kStepSolver);
  const auto scheme =
      block_of(integrator.parameters, integrator.integrator.parameter_bytes, d.integrator_parameters);
  const auto steps = block_of(solver.parameters, solver.solver.parameter_bytes, {});
  Settling settling{
      assembler_.get(), &loaded_.scene, {&integrator, scheme.data()}, {&solver, steps.data()}, make_,
      kStepLimits,      d.march};
  settling.limits.interrupt = watch.interrupt;
  settling.limits.tolerance =
      std::min(kStepLimits.tolerance, kStepsFiner * loaded_.analysis.limits.tolerance);
  Limits limits = loaded_.analysis.limits;
  limits.interrupt = watch.interrupt;
  settling.limits.seconds = limits.seconds;
  return solve_static(loaded_.scene, *assembler_, settling.as_solver(), &settling, limits, make_,
                      watch.on_iteration);
}

MarchResult Case::march(const MarchWatch& watch, const std::atomic<bool>* interrupt, const MarchState* from) {
  const Analysis& a = loaded_.analysis;
  const IntegratorType& integrator = registry_.integrator(a.dynamics.integrator);
  const SolverType& solver = registry_.solver(a.solver);
  const auto scheme = block_of(integrator.parameters, integrator.integrator.parameter_bytes,
                               a.dynamics.integrator_parameters);
  const auto steps = block_of(solver.parameters, solver.solver.parameter_bytes, a.solver_parameters);
  Limits limits = a.limits;
  limits.interrupt = interrupt;
  std::optional<MarchState> at_rest;
  if (!from && a.dynamics.from_equilibrium) {
    const Solution s = find_equilibrium(interrupt, Limits{}.tolerance);
    if (s.status != SolveStatus::converged) {
      MarchResult none;
      none.reason = "there is no equilibrium to start from: " + s.reason, none.u = s.u;
      return none;
    }
    from = &at_rest.emplace(state_at_rest(*assembler_, s.u));
  }
  return netloft::march(loaded_.scene, *assembler_, {&integrator, scheme.data()}, {&solver, steps.data()},
                        make_, limits, a.dynamics.march, watch, from);
}

/// Where everything is at rest at t = 0, as a start; of tension only or of coarser meshes first.
Solution Case::find_equilibrium(const std::atomic<bool>* interrupt, double tolerance) {
  const SolverType& newton = registry_.solver("newton");
  const auto parameters = block_of(newton.parameters, newton.solver.parameter_bytes, {});
  Limits limits;
  limits.tolerance = tolerance;
  limits.interrupt = interrupt, limits.seconds = loaded_.analysis.limits.seconds;
  std::vector<Leg> before;
  std::optional<std::vector<double>> start;
  const double begun = wall_seconds();
  const auto solve_from = [&](const std::vector<double>& there) {
    Limits left = limits;
    left.seconds = std::max(0.0, limits.seconds - (wall_seconds() - begun));
    return solve_static(loaded_.scene, *assembler_, newton, parameters.data(), left, make_, {}, there);
  };
  if (use_of_cones(loaded_.scene, registry_, *assembler_) == ConeUse::first)
    start = start_in_cones({.interrupt = interrupt}, {}, limits, before);
  if (start)
    if (const Solution s = solve_from(*start); s.status == SolveStatus::converged) return s;
  return solve_from(
      start_from_coarser([&](Case& coarse) { return coarse.find_equilibrium(interrupt, kCoarseTolerance); },
                         limits.seconds, before));
}

/// What solves from where a coarser mesh came to rest, if not the same: less is left to go than from a
/// sketch. With drag, steps want the damping that they ask for.
std::optional<SolverUse> Case::nearby(SolverUse solver) const {
  const bool is_newton = solver.type->type == "newton/newton";
  if (!is_newton || loaded_.analysis.in_stages || !assembler_->pattern().symmetric) return {};
  const double damping = kDampingNearby / static_cast<double>(plan_.unknowns);
  solver.parameters.try_emplace("damping", std::min(kMostDampingNearby, damping));
  return solver;
}

Solution Case::solve_by_journey(const Watch& watch) {
  JourneyOptions options;
  options.solver = {&registry_.solver(loaded_.analysis.solver), loaded_.analysis.solver_parameters};
  options.nearby = nearby(options.solver);
  options.limits = loaded_.analysis.limits, options.limits.interrupt = watch.interrupt;
  options.make = make_, options.tangent = loaded_.analysis.tangent;
  options.threads = source_.threads, options.on_iteration = watch.on_iteration;
  options.detours = watch.detours && loaded_.analysis.continuation;
  options.looks = watch.detours ? loaded_.analysis.looks : std::max(0, loaded_.analysis.looks);
  std::vector<Leg> before;
  std::optional<std::vector<double>> start;
  const double begun = wall_seconds();
  const auto left = [&] {
    Limits limits = options.limits;
    limits.seconds = std::max(0.0, limits.seconds - (wall_seconds() - begun));
    return limits;
  };
  const auto from_coarser = [&](double seconds, std::vector<Leg>& legs) {
    return start_from_coarser([&](Case& coarse) { return coarse.solve(watch); }, seconds, legs);
  };
  const ConeUse cones = options.detours && !loaded_.analysis.in_stages
                            ? use_of_cones(loaded_.scene, registry_, *assembler_)
                            : ConeUse::never;
  if (loaded_.analysis.in_stages)
    start = start_in_stages(watch, before);
  else if (cones == ConeUse::first)
    start = start_in_cones(watch, {}, options.limits, before);
  if (cones == ConeUse::first && start)
    options.own_start = {"without cones", true, [&](const auto&, double seconds, auto& legs) {
                           return from_coarser(seconds, legs);  // none: from its sketch
                         }};
  else if (cones == ConeUse::as_a_way)
    options.own_start = {"from tension only, in cones", false,
                         [&](const auto& from, double seconds, auto& legs) {
                           Limits limits = options.limits;
                           limits.seconds = seconds;
                           return start_in_cones(watch, from, limits, legs);
                         }};
  if (!start && loaded_.analysis.continuation) start = from_coarser(left().seconds, before);
  options.limits = left();
  Journey journey(loaded_.scene, *assembler_, registry_, options);
  for (const Leg& leg : before) journey.book(leg);
  return journey.arrive(start.value_or(std::vector<double>{}));
}

bool Case::begins_in_cones() const {
  return loaded_.analysis.continuation && !loaded_.analysis.in_stages &&
         use_of_cones(loaded_.scene, registry_, *assembler_) == ConeUse::first;
}

std::optional<std::vector<double>> Case::start_in_cones(const Watch& watch, const std::vector<double>& from,
                                                        const Limits& limits, std::vector<Leg>& legs) {
  Scene scene = loaded_.scene;
  if (!from.empty()) {
    std::vector<double> x = assembler_->start();
    assembler_->place(from, x);
    set_start(scene, positions(x));
  }
  const double wall = wall_seconds(), cpu = cpu_seconds(), load = load_of(*assembler_);
  TensionCones cones(scene, registry_, make_, source_.threads);
  legs.push_back(cones.solve({.tension = load,
                              .iterations = std::min(ConeOptions{}.iterations, limits.iterations),
                              .seconds = limits.seconds,
                              .interrupt = watch.interrupt,
                              .on_iteration = watch.on_iteration}));
  Books& books = legs.back().books;
  books.total_seconds = wall_seconds() - wall, books.total_cpu_seconds = cpu_seconds() - cpu;
  if (!cones.is_near()) return {};
  return assembler_->displacements(cones.positions());
}

/// Grid sequencing: where the same gear in half as many cells across and along comes to rest, it being solved
/// likewise. Empty if there is no such gear, or it is small enough to be solved at once, or did not arrive.
std::vector<double> Case::start_from_coarser(const std::function<Solution(Case&)>& solve, double seconds,
                                             std::vector<Leg>& legs) {
  const auto halved = halved_cells(loaded_);
  if (halved.empty() || plan_.unknowns < kSmall) return {};
  CaseSource source = source_;
  source.overrides.insert(source.overrides.end(), halved.begin(), halved.end());
  source.overrides.push_back("analysis.tolerance=" +
                             std::to_string(std::max(kCoarseTolerance, loaded_.analysis.limits.tolerance)));
  source.overrides.push_back("analysis.looks=0");
  Case coarser(source, registry_);
  const auto start_likewise = [&](LoadedScene& coarse) {
    coarse.analysis.limits.seconds = seconds;
    if (const auto start = carried_over(loaded_, loaded_.scene.positions, coarse))
      set_start(coarse.scene, *start);
  };
  if (coarser.open(start_likewise) != State::ready) return {};
  const Solution s = solve(coarser);
  if (s.legs.empty())
    legs.push_back(
        {on_coarser("as it is"), loaded_.analysis.solver, s.u.size(), s.status, s.reason, s.books});
  else
    for (Leg leg : s.legs) leg.name = on_coarser(leg.name), legs.push_back(leg);
  if (s.status != SolveStatus::converged) return {};
  const auto carried = carried_over(coarser.loaded_, coarser.positions(s.x), loaded_);
  return carried ? assembler_->displacements(*carried) : std::vector<double>{};
}

/// From soft to stiff, tensions being unknowns of their own. Empty where nodes are on bodies or slide in
/// frames, which that does not know, or where it strayed.
std::vector<double> Case::start_in_stages(const Watch& watch, std::vector<Leg>& legs) {
  const Scene& scene = loaded_.scene;
  if (!scene.bodies.empty() || !scene.frames.empty()) return {};
  const Limits& limits = loaded_.analysis.limits;
  const StagedSolution staged = solve_in_stages(
      scene, registry_, make_, source_.threads,
      {.tolerance = limits.tolerance, .seconds = limits.seconds, .interrupt = watch.interrupt});
  legs.insert(legs.end(), staged.legs.begin(), staged.legs.end());
  const bool is_somewhere = std::all_of(begin(staged.positions), end(staged.positions),
                                        [](double coordinate) { return std::isfinite(coordinate); });
  return is_somewhere ? assembler_->displacements(staged.positions) : std::vector<double>{};
}

std::vector<double> Case::positions(std::span<const double> x) const {
  std::vector<double> all(loaded_.scene.positions.size());
  for (std::uint32_t node = 0; node < loaded_.scene.node_count(); ++node)
    for (int axis = 0; axis < 3; ++axis)
      all[3 * std::size_t{node} + static_cast<std::size_t>(axis)] =
          x[static_cast<std::size_t>(assembler_->numbering().index(node, axis))];
  return all;
}

}  // namespace netloft::io
