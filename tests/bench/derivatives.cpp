// SPDX-License-Identifier: BSD-3-Clause
// Compares the derivatives of `netloft sensitivity` with pairs of equilibria on the same mesh topology, and
// their cost with that of a run. Prints derivatives.md.
//
//   bench_derivatives [NUMBERS [SEED]]    numbers that are drawn for each scene (6), seed (1)
#include "io/studies/sensitivity/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "framework/balance/statistics.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/runs/equilibrium.hpp"
#include "tests/folders.hpp"

namespace netloft::studies {
namespace {

constexpr double kStep = 1e-4;  // step of the central differences, over the number
constexpr double kSame = 1e-4;  // pairs agree within this fraction of the largest effect on the figure

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

/// The figures of the equilibrium at another value of a number, on the mesh of `at`; none without one.
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
  double worst = 0;       // largest difference of a pair that is not marked
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

/// Adds the pairs of one number and the chosen figures.
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

/// Compares the key figures of a scene for some of its numbers.
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

/// The processor time of the derivatives of all figures with respect to the first `count` numbers of the
/// 83-112 at sea with 2000 nodes, over that of reading and solving it; the median of five pairs.
double cost(std::size_t count) {
  std::vector<double> ratios;
  for (int i = 0; i < 5; ++i) {
    const double begin = cpu_seconds();
    AtRest at("83-112-at-sea-66m", {"gear.nodes=2000"});
    const double solved = cpu_seconds();
    auto numbers = chosen_numbers(at.scene, {});
    numbers.resize(count);
    find_sensitivities(at.scene, at.solution, {.figures = all_figures(at.result), .numbers = numbers});
    ratios.push_back((cpu_seconds() - solved) / (solved - begin));
  }
  std::ranges::sort(ratios);
  return ratios[2];
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
  constexpr std::size_t kNumbers = 30;
  std::printf(
      "\nDerivatives of all figures of the 83-112 at sea with 2000 nodes with respect to its first %zu "
      "numbers, most of them of the net plan, take %.2f of the processor\ntime of reading and solving it; "
      "with respect to one number, %.2f.\n",
      kNumbers, cost(kNumbers), cost(1));
}

}  // namespace
}  // namespace netloft::studies

int main(int argc, char** argv) {
  const auto count = static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 6);
  netloft::studies::print_page(count, argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1);
}
