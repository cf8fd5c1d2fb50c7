// SPDX-License-Identifier: BSD-3-Clause
// Compares the derivatives of `netloft sensitivity` with differences between pairs of equilibria on the same
// mesh topology, and the cost of the derivatives with that of a run. Prints derivatives.md.
//
//   bench_derivatives [NUMBERS [SEED]]    number of values drawn for each scene (6; 0: only the cost), seed
//   (1)
#include "io/studies/sensitivity/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "framework/balance/statistics.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"
#include "tests/folders.hpp"

namespace netloft::studies {
namespace {

constexpr double kStep = 1e-4;  // step of the central differences, as a fraction of the number
constexpr double kSame = 1e-4;  // two equilibria agree within this fraction of the largest effect on the
                                // figure
constexpr std::size_t kFrozenPairs = 25;  // number of pairs in each scene between which no member or contact
                                          // switches

/// The scenes, and whether each has a net plan, whose number of nodes can be chosen.
constexpr std::pair<const char*, bool> kScenes[] = {
    {"hanging-rope", false},      {"dead-weight-panel", false}, {"codend-from-plan", true},
    {"83-112-flume-2.0kn", true}, {"83-112-flume-4.0kn", true}, {"83-112-at-sea-66m", true},
    {"gov-like-31m", true},       {"gov-like-111m", true},      {"pelagic-with-doors", true},
    {"pair-trawl", true},         {"two-panel", true},          {"four-panel", true}};

Registry& plugins() {
  static Registry registry = [] {
    Registry shipped;
    shipped.add_folder(test::plugin_folder());
    return shipped;
  }();
  return registry;
}

/// A scene of the library and its equilibrium.
struct AtRest {
  AtRest(const std::string& name, const std::vector<std::string>& set)
      : scene({test::source_folder() + "/gear-library/scenes/" + name + ".toml", set, 1}, plugins()) {
    if (scene.prepare() != runs::PreparedScene::State::ready) return;
    solution = runs::find_equilibrium(scene);
    if (solution.status == SolveStatus::converged)
      result = results::make_result(scene.loaded(), scene.assembler(), solution);
  }
  bool is_there() const { return solution.status == SolveStatus::converged; }
  runs::PreparedScene scene;
  Solution solution;
  results::Result result;
};

/// The figures of the equilibrium in which `number` has the given `value`, on the mesh topology of `at`;
/// empty if there is no equilibrium.
std::vector<results::NamedScalar> figures_beside(const AtRest& at, const SceneNumber& number, double value) {
  runs::CaseSource source = at.scene.source();
  formats::append(source.changes, number.to(value));
  runs::PreparedScene beside(std::move(source), plugins());
  if (beside.prepare_like(at.scene) != runs::PreparedScene::State::ready) return {};
  const Solution s = runs::find_equilibrium(beside);
  if (s.status != SolveStatus::converged) return {};
  return all_figures(results::make_result(beside.loaded(), beside.assembler(), s));
}

struct Pairs {
  int all = 0, good = 0, marked = 0, lost = 0;
  double worst = 0;       // largest difference in a pair that is not marked
  std::string worst_one;  // its number
};

void print(const std::string& scene, const Pairs& p) {
  std::printf("| %s | %d | %d | %d | %.0e %s | %d |\n", scene.c_str(), p.all, p.good, p.marked, p.worst,
              p.worst > kSame ? p.worst_one.c_str() : "", p.lost);
  std::fflush(stdout);
}

/// Numbers that have an effect on some of the chosen figures.
std::vector<std::size_t> effective(const Sensitivities& found, const std::vector<std::size_t>& figures) {
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < found.effects.size(); ++n) {
    const NumberEffect& effect = found.effects[n];
    const auto depends = [&](std::size_t f) { return effect_of_percent(effect, f) != 0; };
    if (effect.why_not.empty() && std::ranges::any_of(figures, depends)) numbers.push_back(n);
  }
  return numbers;
}

double largest_effect(const Sensitivities& found, std::size_t f) {
  double largest = 0;
  for (const NumberEffect& effect : found.effects)
    if (effect.why_not.empty()) largest = std::fmax(largest, std::abs(effect_of_percent(effect, f)));
  return largest;
}

/// Compares the derivatives of the chosen figures with respect to one number, and adds the results to
/// `pairs`.
void compare(const AtRest& at, const Sensitivities& found, const NumberEffect& effect,
             const std::vector<std::size_t>& figures, Pairs& pairs) {
  const double p = effect.number.value, h = kStep * std::abs(p);
  const auto above = figures_beside(at, effect.number, p + h),
             below = figures_beside(at, effect.number, p - h);
  for (const std::size_t f : figures) {
    const double largest = largest_effect(found, f);
    if (largest == 0) continue;  // the figure depends on nothing
    if (above.empty() || below.empty()) {
      ++pairs.lost;
      continue;
    }
    const double by_equilibria = (above[f].value - below[f].value) / (2 * h);
    const double error = 0.01 * std::abs(p) * std::abs(by_equilibria - effect.per_unit[f]) / largest;
    const bool is_marked = depends_on_step(found, effect, f);
    ++pairs.all;
    pairs.good += error <= kSame;
    pairs.marked += error > kSame && is_marked;
    if (!is_marked && error > pairs.worst) pairs.worst = error, pairs.worst_one = effect.number.path;
  }
}

/// Compares the derivatives of a scene's key figures with respect to `count` of its numbers.
Pairs compare(const char* name, bool has_plan, std::size_t count, unsigned seed) {
  Pairs pairs;
  std::vector<std::string> set{"analysis.tolerance=1e-10"};
  if (has_plan) set.push_back("gear.nodes=300");
  AtRest at(name, set);
  if (!at.is_there()) return pairs;
  const auto figures = chosen_figures(at.result, {});
  const Sensitivities found = find_sensitivities(
      at.scene, at.solution,
      {.figures = all_figures(at.result), .numbers = chosen_numbers(at.scene, {}), .with_long_step = true});
  auto numbers = effective(found, figures);
  std::ranges::shuffle(numbers, std::mt19937(seed));
  numbers.resize(std::min(count, numbers.size()));
  for (const std::size_t n : numbers) compare(at, found, found.effects[n], figures, pairs);
  return pairs;
}

// ---------------------------------------------------------------- nothing switches

/// Steps of the finite differences, as fractions of the number. A difference counts only if no member or
/// contact switches between its equilibria.
constexpr double kFrozenSteps[] = {1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6};

/// Errors of the derivatives, found by finite differences of equilibria, as fractions of the largest effect
/// on the figure.
struct Errors {
  struct One {
    double error = 0, known_to = 0;  // known_to: the error of the equilibria
    std::string pair = {};           // figure and number
  };
  std::vector<One> all;
  int lost = 0;  // pairs for which something switches at all steps, or an equilibrium is missing
  void add(double error, double known_to, const std::string& pair) { all.push_back({error, known_to, pair}); }
  const One& at(double fraction) {
    static const One none;
    if (all.empty()) return none;
    std::ranges::sort(all, {}, &One::error);
    return all[static_cast<std::size_t>(fraction * static_cast<double>(all.size() - 1))];
  }
};

std::vector<bool> sides(const Switches& at) {
  std::vector<bool> below;
  for (const auto* kind : {&at.members, &at.nodes})
    for (const double distance : kind->distance) below.push_back(distance < 0);
  return below;
}

/// The value of figure `f` at the equilibrium for a changed number; NaN if there is no equilibrium, or if
/// other members are taut or other nodes touch the ground than in `at`.
double figure_nearby(AtRest& at, const SceneNumber& number, double value, std::size_t f) {
  runs::CaseSource source = at.scene.source();
  formats::append(source.changes, number.to(value));
  runs::PreparedScene beside(std::move(source), plugins());
  if (beside.prepare_like(at.scene) != runs::PreparedScene::State::ready) return NAN;
  constexpr int kIterations = 30;  // Newton's iteration needs 3 to 6
  const Solution s =
      runs::continue_equilibrium(beside, beside.assembler().displacements_to(at.solution.x), kIterations);
  const auto sides_of = [](runs::PreparedScene& scene, const std::vector<double>& x) {
    return sides(switches_at(scene.loaded().scene, scene.assembler(), x));
  };
  if (s.status != SolveStatus::converged || sides_of(beside, s.x) != sides_of(at.scene, at.solution.x))
    return NAN;
  return all_figures(results::make_result(beside.loaded(), beside.assembler(), s))[f].value;
}

/// The central difference of figure `f` over four equilibria, of fourth order in the step `h`; NaN if one of
/// the four values is NaN.
double by_frozen_equilibria(AtRest& at, const SceneNumber& number, std::size_t f, double h) {
  const auto change = [&](int k) {
    return figure_nearby(at, number, number.value + k * h, f) -
           figure_nearby(at, number, number.value - k * h, f);
  };
  return (8 * change(1) - change(2)) / (12 * h);
}

/// The derivative from the two successive steps whose results differ least: longer steps have a larger
/// truncation error, shorter steps a larger rounding error. `error` is the difference of the two results.
struct Known {
  double slope = NAN, error = INFINITY;
};
Known by_frozen_equilibria(AtRest& at, const SceneNumber& number, std::size_t f) {
  Known best;
  double last = NAN;
  for (const double step : kFrozenSteps) {
    const double slope = by_frozen_equilibria(at, number, f, step * std::abs(number.value));
    if (std::abs(slope - last) < best.error) best = {slope, std::abs(slope - last)};
    last = slope;
  }
  return best;
}

/// Compares derivatives with finite differences for random pairs of a key figure and a number of a scene.
Errors compare_frozen(const char* name, bool has_plan, std::size_t pairs, unsigned seed) {
  Errors errors;
  std::vector<std::string> set{"analysis.tolerance=1e-13"};
  if (has_plan) set.push_back("gear.nodes=300");
  AtRest at(name, set);
  if (!at.is_there()) return errors;
  const auto figures = chosen_figures(at.result, {});
  const Sensitivities found = find_sensitivities(
      at.scene, at.solution,
      {.figures = all_figures(at.result), .numbers = chosen_numbers(at.scene, {}), .with_reach = false});
  std::vector<std::pair<std::size_t, std::size_t>> drawn;
  for (const std::size_t f : figures)
    for (const std::size_t n : effective(found, figures))
      if (largest_effect(found, f) > 0) drawn.emplace_back(f, n);
  std::ranges::shuffle(drawn, std::mt19937(seed));
  drawn.resize(std::min(pairs, drawn.size()));
  for (const auto& [f, n] : drawn) {
    const NumberEffect& effect = found.effects[n];
    const Known known = by_frozen_equilibria(at, effect.number, f);
    const auto scaled = [&, number = effect.number.value](double error) {
      return 0.01 * std::abs(number * error) / largest_effect(found, f);
    };
    if (std::isnan(known.slope)) {
      ++errors.lost;
      continue;
    }
    errors.add(scaled(known.slope - effect.per_unit[f]), scaled(known.error),
               found.figures[f].name + " to " + effect.number.path);
  }
  return errors;
}

void print(const std::string& scene, Errors& errors) {
  const Errors::One &median = errors.at(0.5), &most = errors.at(0.9), &largest = errors.at(1);
  std::printf("| %s | %zu | %.0e | %.0e | %.0e ± %.0e %s | %d |\n", scene.c_str(), errors.all.size(),
              median.error, most.error, largest.error, largest.known_to, largest.pair.c_str(), errors.lost);
  std::fflush(stdout);
}

void print_frozen(std::size_t pairs, unsigned seed) {
  std::printf(
      "\n## While nothing switches\n\n"
      "Here, a pair is any number and any key figure that depends on it. Equilibria on the same mesh "
      "topology, found by Newton's iteration to 1e-13 from that of\nthe scene, give the derivative to the "
      "fourth order of the step, for steps of 1e-3 ... 3e-6 of the number over which no member becomes taut "
      "or slack and no node\ntouches or leaves the ground. Of two steps in succession, those whose results "
      "differ least count; ± is their difference. Errors are fractions of the largest\nchange of the figure "
      "by one percent of any number.\n\n"
      "| scene | pairs | median error | nine tenths are below | largest | pairs without such equilibria "
      "|\n|---|---|---|---|---|---|\n");
  Errors all;
  for (const auto& [name, has_plan] : kScenes) {
    Errors one = compare_frozen(name, has_plan, pairs, seed);
    print(name, one);
    all.all.insert(all.all.end(), one.all.begin(), one.all.end());
    all.lost += one.lost;
  }
  print("all", all);
}

/// Processor times of derivatives, divided by the time to read and solve the scene.
struct DerivativeCost {
  double with_reach, without_reach, of_one, adjoint;
};

/// The median of five ratios.
double median(std::vector<double> ratios) {
  std::ranges::sort(ratios);
  return ratios[ratios.size() / 2];
}

/// The cost of derivatives of all figures with respect to the first `count` numbers of the 83-112 at sea with
/// 2000 nodes, with and without how far they reach, and to one number; and of the adjoint variables of one
/// figure, with the factors of K.
DerivativeCost cost(std::size_t count) {
  std::vector<double> with_reach, without_reach, of_one, adjoint;
  for (int i = 0; i < 5; ++i) {
    const double begin = cpu_seconds();
    AtRest at("83-112-at-sea-66m", {"gear.nodes=2000"});
    const double solved = cpu_seconds() - begin;
    const auto all = chosen_numbers(at.scene, {});
    const auto ratio_of = [&](std::size_t numbers, bool reach) {
      const double before = cpu_seconds();
      find_sensitivities(at.scene, at.solution,
                         {.figures = all_figures(at.result),
                          .numbers = {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(numbers)},
                          .with_reach = reach});
      return (cpu_seconds() - before) / solved;
    };
    with_reach.push_back(ratio_of(count, true));
    without_reach.push_back(ratio_of(count, false));
    of_one.push_back(ratio_of(1, false));
    const double before = cpu_seconds();
    runs::Tangent tangent(at.scene, at.solution.x);
    tangent.adjoint(std::vector<double>(at.solution.u.size(), 1.0));
    adjoint.push_back((cpu_seconds() - before) / solved);
  }
  return {median(with_reach), median(without_reach), median(of_one), median(adjoint)};
}

void print_cost() {
  constexpr std::size_t kNumbers = 30;
  const DerivativeCost ratio = cost(kNumbers);
  std::printf(
      "\nDerivatives of all figures of the 83-112 at sea with 2000 nodes with respect to its first %zu "
      "numbers, most of them of the net plan, take %.2f of the processor\ntime of reading and solving it, "
      "and "
      "%.2f with how far they reach; with respect to one number, %.2f. The adjoint variables of one figure, "
      "with the factors of K, take %.3f.\n",
      kNumbers, ratio.without_reach, ratio.with_reach, ratio.of_one, ratio.adjoint);
}

void print_page(std::size_t count, unsigned seed) {
  std::printf(
      "# Derivatives of figures, against pairs of equilibria\n\n"
      "The program `bench_derivatives` prints this page. A *pair* is a number of the scene, drawn at random, "
      "and a key figure. It agrees if the derivative\ndiffers from the central difference of two equilibria, "
      "which the default strategy finds at 1e-4 of the number above and below on the same mesh topology,\nby "
      "at most 1e-4 of the largest change of the figure by one percent of any number. Those that do not "
      "agree "
      "are expected where a member becomes slack\nor a node touches the ground within the step; `--check` "
      "has "
      "to mark them.\n\n"
      "| scene | pairs | agree | others that are marked | largest difference of one that is not marked | "
      "pairs without both equilibria |\n|---|---|---|---|---|---|\n");
  Pairs all;
  for (const auto& [name, has_plan] : kScenes) {
    const Pairs one = compare(name, has_plan, count, seed);
    print(name, one);
    all = {all.all + one.all,   all.good + one.good, all.marked + one.marked,
           all.lost + one.lost, all.worst,           all.worst_one};
    if (one.worst > all.worst)
      all.worst = one.worst, all.worst_one = std::string(name) + ": " + one.worst_one;
  }
  print("all", all);
  print_frozen(kFrozenPairs, seed);
  print_cost();
}

}  // namespace
}  // namespace netloft::studies

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 6);
  if (count == 0) {
    netloft::studies::print_cost();
    return 0;
  }
  netloft::studies::print_page(count, argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1);
}
