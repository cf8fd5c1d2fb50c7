// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of terms that a scene does not use: the time for the hanging panel with the shipped priour/triangle,
// divided by the time with the same triangle reduced to tension and weight (bare_netting.cpp).
//
// Each pair evaluates both panels one right after the other, in random order, on one core and in processor
// time, so that a busy machine disturbs both alike. A pair gives a ratio. The median of many ratios does not
// depend on how large the disturbances are. The memory addresses of the two panels change the ratio by up to
// a per cent, equally in all their pairs; therefore both panels are built anew many times, and the printed
// median and its confidence interval are those of the medians of these builds. The ratio of the best times is
// printed, too.
#include "framework/assembler/assembler.hpp"
#include "tests/folders.hpp"
#include "tests/support/sample_scenes.hpp"

#include <sched.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace {

using namespace netloft;

constexpr int kBuilds = 60;                // how often the two panels of each size are built
constexpr double kSecondsPerBuild = 0.15;  // [s]
constexpr double kSecondsPerTurn = 1e-4;   // [s]

/// Processor time of this thread [s].
double processor_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

void stay_on_this_core() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) std::puts("not on one core: the system does not allow it");
}

struct Panel {
  Panel(const std::string& type, int cells, Registry& registry) : scene(sample::hanging_panel(cells, 36.5)) {
    scene.parts[0].type = type;
    assembler = std::make_unique<Assembler>(scene, make_scene_plan(scene, registry), 1);
    residual.resize(assembler->numbering().dofs()), values.resize(assembler->value_slots());
  }
  /// Mean time of an evaluation of residual and tangent [s].
  double seconds(int evaluations) {
    const double begin = processor_seconds();
    for (int i = 0; i < evaluations; ++i)
      assembler->evaluate(
          assembler->start(),
          {.residual = residual.data(), .matrix = MatrixKind::exact, .values = values.data()});
    return (processor_seconds() - begin) / evaluations;
  }
  Scene scene;
  std::unique_ptr<Assembler> assembler;
  std::vector<double> residual, values;
};

/// Median with its two-sided 95 % confidence interval for any distribution: the order statistics n/2 ± 0.98
/// √n.
struct Median {
  explicit Median(std::vector<double> of) {
    std::sort(of.begin(), of.end());
    const double n = double(of.size()), reach = 0.98 * std::sqrt(n);
    const auto ranked = [&](double rank) {
      return of[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))];
    };
    value = ranked(n / 2), low = ranked(n / 2 - reach), high = ranked(n / 2 + reach);
  }
  double value, low, high;
};

struct Timing {
  std::vector<double> ratios;            // shipped over bare: medians of the builds
  double shipped = 1e300, bare = 1e300;  // best [s]
  std::size_t pairs = 0;
};

double time_pair(Panel& shipped, Panel& bare, int evaluations, bool shipped_first, Timing& timing) {
  double a = shipped_first ? shipped.seconds(evaluations) : 0;
  const double b = bare.seconds(evaluations);
  if (!shipped_first) a = shipped.seconds(evaluations);
  timing.shipped = std::min(timing.shipped, a), timing.bare = std::min(timing.bare, b);
  ++timing.pairs;
  return a / b;
}

void time_build(Panel& shipped, Panel& bare, std::mt19937& dice, Timing& timing) {
  shipped.seconds(10);
  const double once = bare.seconds(10);
  const int evaluations = std::max(1, static_cast<int>(kSecondsPerTurn / once));
  std::vector<double> ratios;
  for (double left = kSecondsPerBuild; left > 0; left -= 2 * evaluations * once)
    ratios.push_back(time_pair(shipped, bare, evaluations, dice() % 2 == 0, timing));
  timing.ratios.push_back(Median(ratios).value);
}

Timing time_builds(int cells, Registry& registry, std::mt19937& dice) {
  Timing timing;
  for (int build = 0; build < kBuilds; ++build) {
    const bool shipped_first = build % 2 == 0;
    Panel first(shipped_first ? "priour/triangle" : "bare/triangle", cells, registry),
        second(shipped_first ? "bare/triangle" : "priour/triangle", cells, registry);
    time_build(shipped_first ? first : second, shipped_first ? second : first, dice, timing);
  }
  return timing;
}

}  // namespace

int main() {
  stay_on_this_core();
  Registry registry;
  registry.add_folder(netloft::test::build_folder() + "/tests/bench/plugins");
  registry.add_folder(netloft::test::plugin_folder());
  std::mt19937 dice(20240817);
  std::puts(
      "residual and tangent, best ns per triangle; ratio of the best, and of builds: median, 95 % interval");
  std::puts(
      "triangles   as shipped   tension and weight alone    best    median            interval     pairs");
  for (const int cells : {16, 32, 64}) {
    const Timing timing = time_builds(cells, registry, dice);
    const double elements = 2.0 * cells * cells;
    const Median ratio(timing.ratios);
    std::printf("%9.0f %12.2f %26.2f %7.4f %9.4f   %7.4f .. %7.4f %9zu\n", elements,
                1e9 * timing.shipped / elements, 1e9 * timing.bare / elements, timing.shipped / timing.bare,
                ratio.value, ratio.low, ratio.high, timing.pairs);
  }
}
