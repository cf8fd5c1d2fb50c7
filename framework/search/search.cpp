// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/search.hpp"

#include "framework/registry/plugin_call.hpp"
#include "framework/search/named_component.hpp"
#include "framework/search/running_search.hpp"
#include "framework/search/settings.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace netloft {

namespace {

constexpr std::size_t kLongestPlan = 4096;  // room for the plan of a strategy [bytes]

ParameterBlock block_of(const StrategyUse& use) {
  std::vector<std::string> faults;
  ParameterBlock block(use.type->parameters, use.type->strategy.parameter_bytes, use.parameters, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return block;
}

/// The result if a strategy solved no stage of the scene: an assessment of the initial positions, with the
/// reason. Callers need positions, even if nothing was solved.
Solution at_start(SearchHost& host, const netloft_search& search, Solution none) {
  std::vector<double> u(search.unknowns, 0.0);
  if (search.start) u.assign(search.start, search.start + search.unknowns);
  netloft_stage stage{};
  stage.size = sizeof stage;
  stage.variant = as_written();
  stage.name = "the start";
  stage.u = u.data();
  stage.tolerance = host.options().limits.tolerance;
  stage.work = host.options().work;
  Solution start = host.assess(stage);
  start.cost = std::move(none.cost);
  if (search.unknowns == 0) return start;  // if nothing can move, the start is the only point
  start.status = none.status == SolveStatus::interrupted ? none.status : SolveStatus::not_converged;
  start.reason = std::move(none.reason);
  start.does_not_settle = none.does_not_settle;
  return start;
}

/// Finds the equilibrium of a scene whose settings are fixed.
Solution find_as_set(const VariantSource& source, const SearchOptions& options, const StrategyUse& strategy,
                     const std::vector<double>& start) {
  SearchHost host(source, options);
  const ParameterBlock parameters = block_of(strategy);
  RunningSearch search(host, as_written(), options.limits.tolerance, options.work,
                       start.empty() ? nullptr : start.data());
  search.run(*strategy.type, parameters.data());
  Solution best = host.finish(search.explained());
  if (!search.has_any()) best = at_start(host, search.interface(), std::move(best));
  return best;
}

/// Solves one stage of the scene itself from u, with the solver of the search options.
Solution solve_near(const VariantSource& source, const SearchOptions& options, std::vector<double> u) {
  constexpr std::uint32_t kNear = 100;  // limit of iterations, the same as for an initial guess by the user
  SearchHost host(source, options);
  netloft_stage stage{};
  stage.size = sizeof stage;
  stage.variant = as_written();
  stage.name = "next setting";
  stage.u = u.data();
  stage.tolerance = options.limits.tolerance;
  stage.work = options.work;
  stage.iterations = kNear;
  return host.finish(host.solve(stage, options.solver));
}

/// The scene whose settings are multiplied by variable factors; finds the equilibrium for given factors.
class SetScenes {
 public:
  SetScenes(const VariantSource& source, const SearchOptions& options, const StrategyUse& strategy)
      : source_(source), left_(options), strategy_(strategy), begun_(cpu_seconds()) {}

  SetEquilibrium find(std::span<const double> factors, const std::vector<double>& start) {
    Scene scene = *source_.scene;
    set_factors(scene, factors);
    const ScenePlan plan = make_scene_plan(scene, *source_.registry, source_.tangent);
    Assembler assembler(scene, plan, source_.threads);
    assembler.set_memory(source_.assembler->memory());
    VariantSource source = source_;
    source.scene = &scene;
    source.assembler = &assembler;
    SetEquilibrium found{solve(source, start), {}};
    if (is_stationary(found.solution))
      for (const Setting& setting : scene.settings) {
        const auto force = assembler.reaction(setting.node, found.solution.residual);
        found.reactions.push_back(std::hypot(force[0], force[1], force[2]));
      }
    return found;
  }

 private:
  /// Finds an equilibrium. The strategy finds the first equilibrium; the solver alone finds later ones,
  /// starting from the previous equilibrium. If the solver fails, the strategy is used.
  Solution solve(const VariantSource& source, const std::vector<double>& start) {
    Solution near;
    if (has_one_ && !start.empty()) near = spend(solve_near(source, left_, start));
    if (near.status == SolveStatus::converged || near.status == SolveStatus::interrupted) return near;
    Solution found = spend(find_as_set(source, left_, strategy_, start));
    has_one_ |= is_stationary(found);
    found.cost.add_before(near.cost);
    return found;
  }

  Solution spend(Solution s) {
    left_.work = std::max(0.0, left_.work - s.cost.work);
    const double now = cpu_seconds();
    left_.limits.seconds = std::max(0.0, left_.limits.seconds - (now - begun_));
    begun_ = now;
    return s;
  }

  const VariantSource& source_;
  SearchOptions left_;  // options with the remaining work and time
  const StrategyUse& strategy_;
  double begun_;
  bool has_one_ = false;
};

}  // namespace

Solution find_equilibrium(const VariantSource& source, const SearchOptions& options,
                          const StrategyUse& strategy, const std::vector<double>& start) {
  if (!source.scene->settings.empty()) {
    SetScenes scenes(source, options, strategy);
    return find_settings(
        *source.scene, [&](auto factors, const auto& near_to) { return scenes.find(factors, near_to); },
        start);
  }
  Solution best = find_as_set(source, options, strategy, start);
  if (best.status == SolveStatus::converged) source.assembler->remember(best.x);
  return best;
}

std::optional<std::string> why_unfit(const VariantSource& source, const SearchOptions& options,
                                     const StrategyUse& strategy) {
  SearchHost host(source, options);
  const RunningSearch search(host, as_written(), options.limits.tolerance, options.work, nullptr);
  auto all = strategies_named_by(*strategy.type, strategy.parameters, *source.registry, options.given);
  all.insert(all.begin(), strategy.type);
  for (const StrategyType* type : all)
    if (auto why = search.why_unfit(*type)) return why;
  return {};
}

std::string explain_strategy(const VariantSource& source, const SearchOptions& options,
                             const StrategyUse& strategy) {
  if (!strategy.type->strategy.explain) return "";
  SearchHost host(source, options);
  const ParameterBlock parameters = block_of(strategy);
  RunningSearch search(host, as_written(), options.limits.tolerance, options.work, nullptr);
  std::string text(kLongestPlan, '\0');
  netloft_search& own = search.interface();
  netloft_search seen = own;
  const int status = call_plugin(
      {strategy.type->type.c_str(), "explain", nullptr, CallFrame::Kind::method}, int{NETLOFT_ERROR}, [&] {
        return strategy.type->strategy.explain(parameters.data(), &seen, text.data(),
                                               static_cast<std::uint32_t>(text.size()));
      });
  const std::string who = "the strategy " + strategy.type->type;
  if (take_broken_rule({own.message, own.message_size}) || status != NETLOFT_OK) {
    const std::string why = own.message;
    throw std::runtime_error(who + " failed to explain what it does" + (why.empty() ? "" : ": " + why));
  }
  const auto end = text.find('\0');
  if (end == std::string::npos)
    throw std::runtime_error(who + " explains what it does with more than " + std::to_string(kLongestPlan) +
                             " characters");
  text.resize(end);
  return text;
}

}  // namespace netloft
