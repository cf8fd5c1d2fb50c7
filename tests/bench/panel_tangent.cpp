// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench/panel_tangent.hpp"

#include "framework/scene/plan.hpp"
#include "tests/support/sample_scenes.hpp"

namespace netloft {

Scene panel_in_current(int cells, double speed) {
  Scene scene = sample::hanging_panel(cells, 36.5);
  if (speed > 0) scene.current.samples = {{0, {0, speed, 0}}};
  return scene;
}

TestMatrix tangent_of_panel(int cells, double speed, MatrixKind kind, double shift, Registry& registry) {
  const Scene scene = panel_in_current(cells, speed);
  const Plan plan = make_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  TestMatrix matrix;
  matrix.pattern = assembler.pattern();
  std::vector<double> metric(assembler.value_slots());
  matrix.value.resize(assembler.value_slots());
  assembler.evaluate(assembler.start(), {.matrix = kind, .values = matrix.value.data()});
  assembler.evaluate(assembler.start(), {.matrix = MatrixKind::metric, .values = metric.data()});
  for (std::size_t i = 0; i < metric.size(); ++i) matrix.value[i] += shift * metric[i];
  matrix.value.resize(matrix.pattern.value_slots());
  return matrix;
}

}  // namespace netloft
