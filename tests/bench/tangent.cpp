// SPDX-License-Identifier: BSD-3-Clause
//
// Benefit of the exact tangent of drag: iterations, factorisations and time to a tolerance of 1e-8 for the
// hanging panel across a current, with the whole tangent of drag, with its symmetric part, and without it.
// Compare the times of one run only.
#include "framework/judging/verdict.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/folders.hpp"
#include "tests/support/sample_scenes.hpp"

#include <cstdio>

namespace {

using namespace netloft;

void run(int cells, double speed, TangentChoice tangent, const char* name, Registry& registry) {
  Scene scene = sample::hanging_panel(cells, 36.5);
  scene.current.samples = {{0, {0, speed, 0}}};
  const ScenePlan plan = make_scene_plan(scene, registry, tangent);
  Assembler assembler(scene, plan, 1);
  const SolverType& newton = registry.solver("newton");
  std::vector<std::string> faults;
  const ParameterBlock parameters(newton.parameters, newton.solver.parameter_bytes, {}, faults);
  Limits limits;
  limits.tolerance = 1e-8, limits.iterations = 500;
  const Solution s =
      solve_static({scene, assembler, make_factorisation}, {&newton, parameters.data()}, limits);
  std::printf("%6.1f  %8zu  %-10s %10d %15d %9.3f  %s, residual %.1e N of %.3g N\n", speed, plan.unknowns,
              name, s.cost.statistics.iterations, s.cost.statistics.factorisations,
              s.cost.statistics.total_cpu_seconds, name_of(s.status), s.balance.residual, s.balance.scale);
}

}  // namespace

int main() {
  Registry registry;
  registry.add_folder(netloft::test::plugin_folder());
  std::printf("current  unknowns  tangent    iterations  factorisations     CPU s\n");
  for (const double speed : {0.5, 1.0, 2.0}) {
    run(32, speed, TangentChoice::exact, "exact", registry);
    run(32, speed, TangentChoice::symmetric, "symmetric", registry);
    run(32, speed, TangentChoice::elastic, "elastic", registry);
  }
}
