// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/sensitivity.hpp"

#include "framework/balance/scales.hpp"
#include "framework/judging/correction.hpp"
#include "io/formats/text/likely_path.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/results/figures/key_figures.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"
#include "io/studies/sweep/branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace netloft::studies {

namespace {

/// Step h of (2) in sensitivity.hpp, as a fraction of the number. On two trawls with 300 nodes, derivatives
/// with steps of 1e-6 and 1e-7 differ by at most 2e-4 of the largest effect on a figure. With steps of 1e-7
/// and 1e-8, rounding makes them differ by 2e-3. With 1e-5, stiff ropes become slack at one end of the step.
constexpr double kShortStep = 1e-6;
/// The long step as a multiple of h.
constexpr double kLongStep = 1000;
/// A fold is confirmed if a correction with K has at least this fraction of the length of the step before it.
/// The first step goes twice the distance s to the expected fold. Near a fold, d²x = dx/2s, so that the
/// correction is ½ (2s)² d²x = s dx, half of the first step; later corrections grow, because there is no
/// equilibrium. The limit is half of this ratio.
constexpr double kTurnOfFold = 0.25;
/// Effects below this fraction of the largest effect on a figure may be rounding errors, and are ignored.
constexpr double kNoEffect = 1e-6;

std::vector<results::NamedScalar> joined(std::initializer_list<std::vector<results::NamedScalar>> lists) {
  std::vector<results::NamedScalar> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// The scenes at p − h and p + h, or the reason why there are none. If p is at an end of its range, the scene
/// at p replaces the scene outside the range.
struct Neighbours {
  std::shared_ptr<runs::PreparedScene> below = nullptr, above = nullptr;
  double distance = 0;  // difference of the number between both
  double fraction = 0;  // difference between `above` and the scene itself, divided by `distance`
  std::string why_not = {};
};

class Sensitivity {
 public:
  Sensitivity(runs::PreparedScene& scene, const Solution& solution, const SensitivityRequest& request)
      : scene_(scene),
        x_(solution.x),
        x_low_(solution.x_low),
        tangent_(scene, solution.x),
        request_(request),
        extent_(Scales(scene.assembler()).gear_size()) {
    if (request.with_reach) switches_ = switches_at(scene.loaded().scene, scene.assembler(), x_);
  }

  SwitchSides sides() const { return sides_of(switches_); }

  NumberEffect effect_of(const SceneNumber& number) {
    NumberEffect effect{.number = number, .why_not = {}, .per_unit = {}, .by_long_step = {}};
    const double h = kShortStep * (number.value != 0 ? std::abs(number.value) : 1);
    const Neighbours near = neighbours(number, h);
    effect.why_not = near.why_not;
    if (!effect.why_not.empty()) return effect;
    const auto change = tangent_.between(*near.below, *near.above, near.fraction);
    if (!change) {
      effect.why_not = "the tangent at the equilibrium cannot be factorised";
      return effect;
    }
    if (request_.with_reach) find_reach(near, *change, effect);
    if (!effect.why_not.empty()) return effect;
    if (request_.with_motion)
      for (const double dx : *change) effect.motion.push_back(dx / near.distance);
    effect.per_unit = divided(numbers_beside(*near.above, *change, near.fraction),
                              numbers_beside(*near.below, *change, near.fraction - 1), near.distance);  // (2)
    if (request_.with_long_step) effect.by_long_step = by_long_step(number, h, *change, near.distance);
    return effect;
  }

 private:
  using Figures = std::vector<results::NamedScalar>;

  /// Derivatives of all figures: the differences of the figures, divided by the change of the number. NaN for
  /// a figure that one of the two scenes lacks.
  std::vector<double> divided(const Figures& above, const Figures& below, double by) const {
    std::vector<double> ratios;
    for (const results::NamedScalar& figure : request_.figures) {
      const auto *a = results::find_scalar(above, figure.name), *b = results::find_scalar(below, figure.name);
      ratios.push_back(a && b ? (a->value - b->value) / by : results::NamedScalar::kUnknown);
    }
    return ratios;
  }

  /// The equilibrium moved by a multiple of a change.
  std::vector<double> moved(const std::vector<double>& change, double times) const {
    return runs::moved({x_, {}}, change, times).x;
  }

  static Figures numbers_at(runs::PreparedScene& scene, Solution there) {
    const auto numbers = results::numbers_at(scene.loaded(), scene.assembler(), std::move(there));
    return numbers ? joined({numbers->scalars, numbers->figures, numbers->reactions}) : Figures{};
  }

  /// Finds the members and nodes that switch within the typical change of a number. If its typical change
  /// reaches a fold, the number gets no derivatives.
  void find_reach(const Neighbours& near, const std::vector<double>& change, NumberEffect& effect) {
    const double typical = typical_change(effect.number);
    if (!(typical > 0)) return;
    const auto beside = [&](runs::PreparedScene& scene, double times) {
      return switches_at(scene.loaded().scene, scene.assembler(), moved(change, times));
    };
    effect.switches = switch_changes(scene_.loaded().scene, switches_, beside(*near.above, near.fraction),
                                     beside(*near.below, near.fraction - 1), near.distance, typical);
    const auto growth = tangent_.growth(*near.below, *near.above, near.fraction, change);
    const double away = near.distance / (2 * growth.value_or(0));  // (4) of tangent.hpp
    if (!(std::abs(away) <= typical)) return;
    if (goes_on(effect.number.to(effect.number.value + 2 * away), moved(change, 2 * away / near.distance)))
      return;
    effect.fold_at = effect.number.value + away;
    effect.why_not = why_not_near_fold(effect);
  }

  /// Whether the equilibrium exists in a changed scene, near the expected positions y. It does not if the
  /// solver fails from y or ends noticeably far from y, by the rule with which Branch detects a fold. Returns
  /// true if the scene with these changes is not valid.
  bool goes_on(const std::vector<formats::Change>& changes, const std::vector<double>& y) {
    std::string why_not;
    const auto beyond = open(changes, why_not);
    if (!why_not.empty()) return true;
    const auto apart = [&](const std::vector<double>& a, const std::vector<double>& b) {
      return largest_node_distance(scene_.loaded().scene, scene_.assembler().numbering(), a, b);
    };
    const BranchOptions rules;
    std::vector<double> z = y;
    for (double last = apart(y, x_); last > 0;) {
      const auto next = tangent_.corrected(*beyond, z);
      const double step = next ? apart(*next, z) : INFINITY;
      if (step <= kTurnOfFold * apart(y, x_)) return true;
      if (!(step < last)) break;
      z = *next, last = step;
    }
    const Solution there = runs::continue_equilibrium(*beyond, beyond->assembler().displacements_to(y),
                                                      rules.iterations, {.interrupt = request_.interrupt});
    if (there.status == SolveStatus::interrupted) throw formats::Interrupted{};
    if (there.status != SolveStatus::converged) return false;
    const double off = apart(there.x, y);
    return off <= apart(y, x_) || off <= rules.noticed * extent_;
  }

  static std::string why_not_near_fold(const NumberEffect& effect) {
    const SceneNumber& number = effect.number;
    const std::string unit = number.unit.empty() ? "" : " " + number.unit;
    return fmt::format(
        "the equilibrium ends in a fold near {:.5g}{}, less than {} away; `netloft study` shows what follows",
        effect.fold_at, unit, number.deviation > 0 ? "a standard deviation" : "one percent");
  }

  /// The numbers of a scene at moved(change, times). All digits of the change are used, because differences
  /// of tensions in stiff ropes need them.
  Figures numbers_beside(runs::PreparedScene& scene, const std::vector<double>& change, double times) const {
    runs::ExactPlace place = runs::moved({x_, x_low_}, change, times);
    Solution there;
    there.x = std::move(place.x), there.x_low = std::move(place.x_low);
    return numbers_at(scene, std::move(there));
  }

  /// The derivatives with the long step. Positions are extrapolated with the change of the short step, and
  /// then corrected.
  std::vector<double> by_long_step(const SceneNumber& number, double h, const std::vector<double>& change,
                                   double distance) {
    const Neighbours far = neighbours(number, kLongStep * h);
    if (!far.why_not.empty()) return divided({}, {}, 1);
    const auto figures_at = [&](runs::PreparedScene& scene, double fraction) {
      const auto x = tangent_.corrected(scene, moved(change, fraction * far.distance / distance));
      if (!x) return Figures{};
      Solution there;
      there.x = *x;
      return numbers_at(scene, std::move(there));
    };
    return divided(figures_at(*far.above, far.fraction), figures_at(*far.below, far.fraction - 1),
                   far.distance);
  }

  Neighbours neighbours(const SceneNumber& number, double h) const {
    Neighbours near{.distance = 2 * h, .fraction = 0.5};
    std::string why_not_below;
    near.below = open(number.to(number.value - h), why_not_below);
    near.above = open(number.to(number.value + h), near.why_not);
    if (why_not_below.empty() == near.why_not.empty()) return near;
    const std::shared_ptr<runs::PreparedScene> itself(&scene_, [](runs::PreparedScene*) {});
    near.distance = h;
    near.fraction = near.why_not.empty() ? 1 : 0;
    (near.why_not.empty() ? near.below : near.above) = itself;
    near.why_not.clear();
    return near;
  }

  std::shared_ptr<runs::PreparedScene> open(const std::vector<formats::Change>& changes,
                                            std::string& why_not) const {
    runs::CaseSource source = scene_.source();
    formats::append(source.changes, changes);
    source.threads = 1;  // starting threads takes longer than threads save in one evaluation
    auto near =
        std::make_shared<runs::PreparedScene>(std::move(source), scene_.registry(), scene_.factorisations());
    if (near->prepare_like(scene_) != runs::PreparedScene::State::ready)
      why_not = first_error(near->diagnostics());
    else if (!runs::have_same_topology(scene_, *near))
      why_not = "the mesh changes with it";
    return near;
  }

  static std::string first_error(const formats::Diagnostics& diagnostics) {
    for (const formats::Diagnostic& said : diagnostics.messages())
      if (said.severity == formats::Severity::error) return said.message;
    return "a plugin refuses it";
  }

  runs::PreparedScene& scene_;
  std::vector<double> x_, x_low_;
  runs::Tangent tangent_;
  const SensitivityRequest& request_;
  double extent_;      // size of the gear at its start [m]
  Switches switches_;  // switches at the equilibrium; empty without `with_reach`
};

/// The name in the result of a run of a figure of a study, such as "gear/mouth/headline_height".
std::string name_in_result(const std::string& figure) {
  for (const std::string_view group : {"results/", "gear/"})
    if (figure.starts_with(group)) return figure.substr(group.size());
  return figure;
}

bool is_in_group(const std::string& name, const std::string& group) {
  return name == group || (name.starts_with(group) && name[group.size()] == '/');
}

}  // namespace

std::optional<std::string> why_no_derivatives(const scenes::LoadedScene& loaded) {
  if (loaded.analysis.kind == AnalysisKind::dynamics)
    return "derivatives are those of an equilibrium, but this scene is a motion; add --set "
           "analysis.kind=static";
  if (!loaded.scene.settings.empty())
    return "derivatives change one number of the scene and hold all others constant, but this scene finds a "
           "length by itself; leave out ship.warp.tension";
  return std::nullopt;
}

std::optional<std::string> why_no_derivatives(const Solution& solution) {
  if (solution.status == SolveStatus::converged) return std::nullopt;
  return fmt::format("there are no derivatives, because the scene ended {}: {}", name_of(solution.status),
                     solution.reason);
}

Sensitivities find_sensitivities(runs::PreparedScene& scene, const Solution& solution,
                                 const SensitivityRequest& request) {
  Sensitivity at(scene, solution, request);
  Sensitivities found{.figures = request.figures, .effects = {}, .sides = at.sides()};
  try {
    for (const SceneNumber& number : request.numbers) {
      if (request.interrupt && request.interrupt->load()) throw formats::Interrupted{};
      found.effects.push_back(at.effect_of(number));
      if (request.on_number) request.on_number(found.effects.size(), number.path);
    }
  } catch (const formats::Interrupted&) {  // interrupted while a scene was being read, or between two numbers
    found.is_interrupted = true;
  }
  return found;
}

FigureSlopes slopes_of(runs::PreparedScene& scene, const Solution& solution,
                       const std::vector<std::string>& figures, const std::vector<SceneNumber>& numbers,
                       const std::atomic<bool>* interrupt) {
  SensitivityRequest request{.figures = {}, .numbers = numbers, .interrupt = interrupt};
  for (const std::string& figure : figures) request.figures.emplace_back().name = name_in_result(figure);
  const Sensitivities found = find_sensitivities(scene, solution, request);
  if (found.is_interrupted) return {};
  FigureSlopes slopes{std::vector<std::vector<double>>(figures.size()), {}};
  for (const NumberEffect& effect : found.effects) {
    if (!effect.why_not.empty()) return {{}, effect.number.path + ": " + effect.why_not};
    for (std::size_t f = 0; f < figures.size(); ++f) {
      if (!std::isfinite(effect.per_unit[f])) return {{}, figures[f] + " has no derivatives there"};
      slopes.rows[f].push_back(effect.per_unit[f]);
    }
  }
  return slopes;
}

std::vector<results::NamedScalar> all_figures(const results::Result& result) {
  return joined({result.scalars, result.figures, results::reactions_of(result.hold_forces)});
}

std::vector<std::size_t> chosen_figures(const results::Result& result,
                                        const std::vector<std::string>& names) {
  std::vector<std::string> wanted = names, all;
  if (wanted.empty())
    for (const results::NamedScalar* figure : results::key_figures(result)) wanted.push_back(figure->name);
  for (const auto& figure : all_figures(result)) all.push_back(figure.name);
  std::vector<std::size_t> chosen;
  for (const std::string& name : wanted) {
    const std::size_t before = chosen.size();
    for (std::size_t f = 0; f < all.size(); ++f)
      if (is_in_group(all[f], name) && std::ranges::find(chosen, f) == chosen.end()) chosen.push_back(f);
    if (chosen.size() > before || std::ranges::any_of(all, [&](auto& one) { return is_in_group(one, name); }))
      continue;
    const auto near = formats::likely_path(name, all);
    throw std::invalid_argument(
        "there is no figure \"" + name + "\"; " +
        (near ? "did you mean \"" + *near + "\"?" : "`netloft report` lists them all"));
  }
  return chosen;
}

double effect_of_percent(const NumberEffect& effect, std::size_t f) {
  return 0.01 * std::abs(effect.number.value) * effect.per_unit[f];
}

double typical_change(const SceneNumber& number) {
  return number.deviation > 0 ? number.deviation : 0.01 * std::abs(number.value);
}

double typical_effect(const NumberEffect& effect, std::size_t f) {
  return typical_change(effect.number) * effect.per_unit[f];
}

std::vector<const NumberEffect*> ranked_effects(const Sensitivities& found, std::size_t f) {
  const auto size_of = [f](const NumberEffect* effect) { return std::abs(typical_effect(*effect, f)); };
  std::vector<const NumberEffect*> effects;
  for (const NumberEffect& effect : found.effects)
    if (effect.why_not.empty() && size_of(&effect) > 0) effects.push_back(&effect);
  std::ranges::stable_sort(effects, std::ranges::greater{}, size_of);
  while (!effects.empty() && size_of(effects.back()) < kNoEffect * size_of(effects.front()))
    effects.pop_back();
  return effects;
}

double propagated_deviation(const Sensitivities& found, std::size_t f) {
  double sum = 0;
  for (const NumberEffect& effect : found.effects)
    if (effect.number.deviation > 0 && effect.why_not.empty())
      sum += typical_effect(effect, f) * typical_effect(effect, f);
  return std::sqrt(sum);
}

bool depends_on_step(const Sensitivities& found, const NumberEffect& effect, std::size_t f) {
  if (effect.by_long_step.empty()) return false;
  const double size = 0.01 * std::abs(effect.number.value);
  double largest = 0;
  for (const NumberEffect& other : found.effects)
    if (other.why_not.empty()) largest = std::fmax(largest, std::abs(effect_of_percent(other, f)));
  return !(size * std::abs(effect.by_long_step[f] - effect.per_unit[f]) <= kSameDerivative * largest);
}

}  // namespace netloft::studies
