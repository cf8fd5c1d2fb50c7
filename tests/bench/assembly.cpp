// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of assembly: ns per bar and per triangle for the residual, and for residual and tangent, gather and
// scatter included; and the fraction of assembly in one Newton step (assembly, factorisation, solve) at
// growing size. Best of repeats, one thread. Compare rows of one run only: the machine may be shared.
#include "framework/judging/verdict.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/folders.hpp"
#include "tests/support/sample_scenes.hpp"

#include <cstdio>
#include <functional>
#include <vector>

namespace {

using namespace netloft;

double best_seconds(int repeats, const std::function<void()>& work) {
  double best = 1e300;
  for (int i = 0; i < repeats; ++i) {
    const double begin = wall_seconds();
    work();
    best = std::min(best, wall_seconds() - begin);
  }
  return best;
}

void time_elements(const char* what, const Scene& scene, Registry& registry, double limit) {
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  std::vector<double> residual(assembler.numbering().dofs()), values(assembler.value_slots());
  double energy = 0;
  const double elements = static_cast<double>(assembler.families()[0]->size());
  const auto x = assembler.start();
  const int repeats = static_cast<int>(std::max(5.0, 2e6 / elements));
  const double r = best_seconds(repeats, [&] { assembler.evaluate(x, {.residual = residual.data()}); });
  const double er =
      best_seconds(repeats, [&] { assembler.evaluate(x, {.energy = &energy, .residual = residual.data()}); });
  const double rt = best_seconds(repeats, [&] {
    assembler.evaluate(x,
                       {.residual = residual.data(), .matrix = MatrixKind::exact, .values = values.data()});
  });
  std::printf("%-9s %9.0f %12.1f %16.1f %19.1f %10.0f  %s\n", what, elements, 1e9 * r / elements,
              1e9 * er / elements, 1e9 * rt / elements, limit,
              1e9 * rt / elements <= limit ? "within" : "OVER");
}

void time_share(int cells, int threads, Registry& registry) {
  const Scene scene = sample::hanging_panel(cells, 36.5);
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, threads);
  const SolverType& newton = registry.solver("newton");
  std::vector<std::string> faults;
  const ParameterBlock parameters(newton.parameters, newton.solver.parameter_bytes, {}, faults);
  Limits limits;
  limits.iterations = 30;
  const Solution s =
      solve_static({scene, assembler, make_factorisation}, {&newton, parameters.data()}, limits);
  const Statistics& b = s.cost.statistics;
  const double total = b.assembly_seconds + b.analysis_seconds + b.factorisation_seconds + b.solve_seconds;
  std::printf("%8zu %7d %9d %8.1f %% %13.1f %% %7.1f %% %8.1f %%\n", plan.unknowns, threads, b.factorisations,
              100 * b.assembly_seconds / total, 100 * b.factorisation_seconds / total,
              100 * b.solve_seconds / total, 100 * b.analysis_seconds / total);
}

}  // namespace

int main() {
  Registry registry;
  registry.add_folder(netloft::test::plugin_folder());
  std::printf("element    elements   residual ns  energy + residual  residual + tangent   limit ns\n");
  for (const int n : {1000, 30000, 300000}) time_elements("bar", sample::hanging_rope(n), registry, 35);
  for (const int n : {16, 64, 180, 400})
    time_elements("triangle", sample::hanging_panel(n, 36.5), registry, 120);
  std::printf(
      "\nunknowns threads   factors  assembly  factorisation    solve  analysis   (share of the first 30 "
      "iterations)\n");
  for (const int threads : {1, 2})
    for (const int n : {18, 58, 182}) time_share(n, threads, registry);
}
