// SPDX-License-Identifier: BSD-3-Clause
// Compares the model of work (framework/balance/work.hpp) with measured CPU time, on panels in still water
// and in a current and on a trawl. It prints the modelled number of operations per measured microsecond,
// which would be equal in all columns if the model were exact, and the modelled and the measured cost of each
// operation, in factorisations.
//
//   bench_work_model [LARGEST]    most unknowns of a scene, 100 000 if left out
#include "framework/assembler/assembler.hpp"
#include "framework/balance/work.hpp"
#include "framework/registry/registry.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/scene_source.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/folders.hpp"
#include "tests/support/sample_scenes.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace netloft;

/// CPU time of `work`, the best of several [s].
double time_of(const std::function<void()>& work) {
  double best = std::numeric_limits<double>::infinity(), spent = 0;
  for (int i = 0; i < 3 || (i < 1000 && spent < 0.3); ++i) {
    const double begun = cpu_seconds();
    for (int k = 0; k < 10; ++k) work();
    const double seconds = cpu_seconds() - begun;
    best = std::min(best, seconds / 10), spent += seconds;
  }
  return best;
}

/// Measured seconds of each operation.
struct Measured {
  double factorisation, solution, matrix, residual;
};

Measured measure(Assembler& assembler) {
  const SparsePattern& pattern = assembler.pattern();
  const auto x = assembler.start();
  std::vector<double> K(assembler.value_slots()), M = K, r(assembler.numbering().dofs());
  assembler.evaluate(x, {.matrix = MatrixKind::metric, .values = M.data()});
  Measured m{};
  m.residual = time_of([&] { assembler.evaluate(x, {.residual = r.data()}); });
  m.matrix = time_of([&] { assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = K.data()}); });
  for (std::size_t i = 0; i < K.size(); ++i) K[i] += M[i];
  const auto factorisation =
      make_factorisation(pattern.symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  const std::span<const double> values{K.data(), pattern.value_slots()};
  std::vector<double> step(static_cast<std::size_t>(pattern.size), 1.0);
  m.factorisation = time_of([&] { factorisation->factorise(values); });
  m.solution = time_of([&] { factorisation->solve(step, step); });
  return m;
}

void print_row(const char* name, const Scene& scene, Registry& registry) {
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  const WorkModel w = make_work_model(assembler, make_factorisation);
  const Measured m = measure(assembler);
  const auto rate = [](double operations, double seconds) { return 1e-6 * operations / seconds; };
  std::printf("%-18s %8zu  %7.0f %7.0f %7.0f %7.0f   %6.3f %6.3f   %6.3f %6.3f   %6.3f %6.3f   %7.0f\n", name,
              plan.unknowns, rate(w.factorisation, m.factorisation), rate(w.solution, m.solution),
              rate(w.matrix, m.matrix), rate(w.residual, m.residual), w.solution / w.factorisation,
              m.solution / m.factorisation, w.matrix / w.factorisation, m.matrix / m.factorisation,
              w.residual / w.factorisation, m.residual / m.factorisation,
              rate(w.of_iteration(), m.factorisation + m.solution + m.matrix + m.residual));
}

void print_panels(double largest, Registry& registry) {
  for (const double speed : {0.0, 1.0})
    for (const int cells : {8, 18, 32, 58, 100, 182}) {
      if (3.0 * cells * cells > largest) continue;
      Scene scene = sample::hanging_panel(cells, 36.5);
      if (speed > 0) scene.current.samples = {{0, {0, speed, 0}}};
      print_row(speed > 0 ? "panel in a current" : "panel", scene, registry);
    }
}

void print_trawls(double largest, Registry& registry) {
  for (const int nodes : {100, 400, 2000, 8000, 33000}) {
    if (3.0 * nodes > largest) continue;
    formats::Diagnostics diagnostics;
    bool refused = false;
    const scenes::LoadedScene loaded =
        scenes::SceneSource(netloft::test::source_folder() + "/gear-library/scenes/83-112-flume-3.0kn.toml")
            .instance({formats::make_change({"gear", "nodes"}, {{}, std::int64_t{nodes}})}, registry,
                      diagnostics, refused);
    if (!diagnostics.errors()) print_row("83-112", loaded.scene, registry);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const double largest = count > 1 ? std::atof(arguments[1]) : 1e5;
  Registry registry;
  registry.add_folder(netloft::test::plugin_folder());
  std::printf("%28s%33s   %13s   %13s   %13s   %s\n", "", "operations per microsecond of", "solution",
              "matrix", "residual", "per us of an");
  std::printf("%18s %9s  %7s %7s %7s %7s   %6s %6s   %6s %6s   %6s %6s   %s\n", "", "unknowns", "factor.",
              "solve", "matrix", "resid.", "model", "meas.", "model", "meas.", "model", "meas.", "iteration");
  print_panels(largest, registry);
  print_trawls(largest, registry);
}
