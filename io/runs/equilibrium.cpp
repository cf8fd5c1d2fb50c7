// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/equilibrium.hpp"

#include "io/runs/diagnosis.hpp"
#include "io/runs/search_setup.hpp"
#include "io/runs/settle.hpp"
#include "io/scenes/reading/keys.hpp"

#include <algorithm>
#include <limits>

namespace netloft::runs {

namespace {

constexpr int kFromElsewhere = 100;  // iterations from a point that a user names

/// Announces the time that a search may take, and at its end that there is no limit any more.
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

void adopt_and_check(PreparedScene& scene, Solution& s) {
  scene.adopt(s);
  reject_crossed_halves(scene.loaded(), scene.assembler(), s);
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

// A settling motion begins at `u`, at rest.
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
  return netloft::why_unfit(scene.registry().solver(analysis.solver), traits_of(scene.assembler()));
}

std::string explain_strategy(PreparedScene& scene) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  if (analysis.settles) return "";
  return netloft::explain_strategy(scene.variants(), search_options(scene, analysis.limits, {}),
                                   strategy_of(scene));
}

}  // namespace netloft::runs
