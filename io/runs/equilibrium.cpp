// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/equilibrium.hpp"

#include "io/runs/diagnosis.hpp"
#include "io/runs/hold_force.hpp"
#include "io/runs/settle.hpp"
#include "io/scenes/reading/halves.hpp"
#include "io/scenes/reading/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace netloft::runs {

namespace {

constexpr int kFromElsewhere = 100;  // limit of iterations from a start that the caller gives
// Largest force in a loose hold (one that only keeps the gear from drifting), as a fraction of the largest
// load on a node. The residuals that a search leaves at thousands of nodes are below its tolerance, and their
// sum, which such a hold bears, is below this limit.
constexpr double kLoadOfLoose = 1e-3;

/// Tells the caller how much processor time a search may take and, when this object is destroyed, that the
/// limit has ended.
class AllowedTime {
 public:
  AllowedTime(const Watch& watch, double seconds) : watch_(watch) { announce(seconds); }
  ~AllowedTime() { announce(std::numeric_limits<double>::infinity()); }
  AllowedTime(const AllowedTime&) = delete;
  AllowedTime& operator=(const AllowedTime&) = delete;

 private:
  void announce(double seconds) const {
    if (watch_.on_budget) watch_.on_budget(seconds);
  }
  const Watch& watch_;
};

/// Options of a search with the solver that the scene names.
SearchOptions search_options(PreparedScene& scene, const Limits& limits, const Watch& watch) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  SearchOptions options;
  options.solver = {&scene.registry().solver(analysis.solver), analysis.solver_parameters};
  options.limits = limits;
  options.limits.interrupt = watch.interrupt;
  options.given = analysis.given;
  options.kept = watch.kept;
  options.work = analysis.work;
  options.on_iteration = watch.on_iteration;
  options.on_stage = watch.on_stage;
  return options;
}

StrategyUse strategy_of(PreparedScene& scene) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  return {&scene.registry().strategy(analysis.strategy), analysis.strategy_parameters};
}

void reject(Solution& s, std::string at_fault, std::string reason) {
  s.status = SolveStatus::not_converged;
  s.stability = Stability::unknown;
  s.at_fault = std::move(at_fault);
  s.reason = std::move(reason);
}

/// Rejects equilibria of a half gear that has crossed its plane of symmetry, because the whole gear has no
/// such equilibrium. Nodes that the user holds beyond the plane do not count. Also rejects equilibria of a
/// whole gear whose boards have crossed.
void reject_crossed(const scenes::LoadedScene& loaded, const Assembler& assembler, Solution& s) {
  const bool is_half = loaded.gear && loaded.gear->times == 2;
  for (const scenes::Crossing& crossing : scenes::find_crossings(loaded, assembler.node_positions(s.x)))
    if (!crossing.is_held)
      reject(s, loaded.scene.parts[crossing.part].name,
             crossing.sentence +
                 (is_half ? ". A whole gear has no such equilibrium; start from another shape, or set "
                            "gear.extent = \"whole\""
                          : ". No gear is meant to have this shape; start each board on its own side"));
}

/// Rejects equilibria in which a loose hold, which should only keep the gear from drifting, bears load.
/// Without the hold, such a gear would not be in equilibrium.
void reject_held_up(const scenes::LoadedScene& loaded, const Assembler& assembler, Solution& s) {
  for (const scenes::Hold& hold : loaded.holds) {
    if (!hold.is_loose) continue;
    const auto f = force_of(hold, assembler, s.residual);
    const double force = std::hypot(f[0], f[1], f[2]);
    if (!(force > kLoadOfLoose * s.balance.scale)) continue;
    reject(s, loaded.scene.node_name(hold.nodes.front()),
           fmt::format(
               "the loose hold \"{}\" bears {:.4g} N, while the largest load on a node is {:.4g} N: the gear "
               "drifts without it. Hold the gear where it is towed or moored, or leave out `loose`",
               hold.name, force, s.balance.scale));
  }
}

/// Rejects equilibria of the model that the real gear cannot have.
void reject_what_is_none(const scenes::LoadedScene& loaded, const Assembler& assembler, Solution& s) {
  if (!is_stationary(s)) return;
  reject_crossed(loaded, assembler, s);
  reject_held_up(loaded, assembler, s);
}

void adopt_and_check(PreparedScene& scene, Solution& s) {
  scene.adopt(s);
  reject_what_is_none(scene.loaded(), scene.assembler(), s);
}

}  // namespace

Solution find_equilibrium(PreparedScene& scene, const Watch& watch, const std::vector<double>& from) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  const AllowedTime allowed(watch, analysis.limits.seconds);
  Solution s = analysis.settles ? settle(scene, watch, from)
                                : netloft::find_equilibrium(scene.variants(),
                                                            search_options(scene, analysis.limits, watch),
                                                            strategy_of(scene), from);
  adopt_and_check(scene, s);
  if (s.status != SolveStatus::converged)
    s.diagnostics = diagnose(scene.loaded().scene, scene.assembler(), s);
  return s;
}

// Starts a damped motion at rest from `u` if such a motion, instead of a solver, finds the equilibrium of the
// scene.
Solution continue_equilibrium(PreparedScene& scene, const std::vector<double>& u, int iterations,
                              const Watch& watch) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  if (analysis.settles) return find_equilibrium(scene, watch, u);
  const AllowedTime allowed(watch, analysis.limits.seconds);
  Limits limits = analysis.limits;
  limits.iterations = std::min(limits.iterations, iterations);
  const StrategyUse alone{&scene.registry().strategy(scenes::kStrategyOfNamedSolver), {}};
  Solution s = netloft::find_equilibrium(scene.variants(), search_options(scene, limits, watch), alone, u);
  adopt_and_check(scene, s);
  return s;
}

Solution find_equilibrium_near(PreparedScene& scene, const std::vector<double>& u, const Watch& watch) {
  if (scene.loaded().analysis.settles) return find_equilibrium(scene, watch, u);
  const auto is_answer = [](const Solution& s) {
    return s.status == SolveStatus::converged || s.status == SolveStatus::interrupted;
  };
  Solution found = continue_equilibrium(scene, u, kFromElsewhere, watch);
  const auto go_on_from = [&](const std::vector<double>& from) {
    Solution next = find_equilibrium(scene, watch, from);
    next.cost.add_before(found.cost);
    found = std::move(next);
  };
  if (found.status == SolveStatus::unstable) go_on_from(std::vector(found.u));
  if (!is_answer(found)) go_on_from({});
  return found;
}

Solution find_start_of_motion(PreparedScene& scene, const Watch& watch) {
  const scenes::LoadedScene& loaded = scene.loaded();
  const ScenePlan plan = make_scene_plan(loaded.scene, scene.registry());
  Assembler assembler(loaded.scene, plan, scene.source().threads);
  assert(assembler.pattern().size == scene.assembler().pattern().size);
  VariantSource source = scene.variants();
  source.assembler = &assembler;
  source.tangent = TangentChoice::exact;
  Limits limits;
  limits.seconds = loaded.analysis.limits.seconds;
  limits.judging.accept_oscillation = loaded.analysis.limits.judging.accept_oscillation;
  SearchOptions options =
      search_options(scene, limits, {.interrupt = watch.interrupt, .on_iteration = watch.on_iteration});
  options.solver = {&scene.registry().solver(scenes::kSolver), {}};
  Solution found = netloft::find_equilibrium(source, options, strategy_of(scene));
  reject_what_is_none(loaded, assembler, found);
  return found;
}

Solution assess_point(const PreparedScene& scene, std::span<const double> u, Assembler& assembler) {
  Limits limits = scene.loaded().analysis.limits;
  limits.judging.examine_growth = false;
  Solution s;
  static_cast<Assessment&>(s) =
      assess_static({scene.loaded().scene, assembler, scene.factorisations()}, u, limits);
  s.u.assign(u.begin(), u.end());
  return s;
}

std::optional<std::string> why_unfit(PreparedScene& scene) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  if (analysis.settles || analysis.kind != AnalysisKind::statics) return {};
  if (auto why = netloft::why_unfit(scene.registry().solver(analysis.solver), traits_of(scene.assembler())))
    return why;
  return netloft::why_unfit(scene.variants(), search_options(scene, analysis.limits, {}), strategy_of(scene));
}

std::string explain_strategy(PreparedScene& scene) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  if (analysis.settles) return "";
  return netloft::explain_strategy(scene.variants(), search_options(scene, analysis.limits, {}),
                                   strategy_of(scene));
}

}  // namespace netloft::runs
