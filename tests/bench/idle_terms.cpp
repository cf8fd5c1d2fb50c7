// SPDX-License-Identifier: BSD-3-Clause
//
// What terms cost a scene that does not use them: the hanging panel with priour/triangle as shipped, and with
// the same triangle that has tension and weight alone. Both are timed in turns, so that a busy machine hits
// both alike; the ratio is that of the best of each.
#include "framework/assembler/assembler.hpp"
#include "framework/problem/books.hpp"
#include "tests/support/sample_scenes.hpp"

#include <algorithm>
#include <cstdio>

namespace {

using namespace netloft;

struct Panel {
  Panel(const std::string& type, int cells, Registry& registry) : scene(sample::hanging_panel(cells, 36.5)) {
    scene.parts[0].type = type;
    assembler = std::make_unique<Assembler>(scene, make_plan(scene, registry), 1);
    residual.resize(assembler->numbering().dofs()), values.resize(assembler->value_slots());
  }
  void run() {
    const double begin = wall_seconds();
    assembler->evaluate(assembler->start(),
                        {.residual = residual.data(), .matrix = MatrixKind::exact, .values = values.data()});
    best = std::min(best, wall_seconds() - begin);
  }
  Scene scene;
  std::unique_ptr<Assembler> assembler;
  std::vector<double> residual, values;
  double best = 1e300;
};

}  // namespace

int main() {
  Registry registry;
  registry.add_folder(NETLOFT_BARE_DIR);
  registry.add_folder(NETLOFT_PLUGIN_DIR);
  std::printf(
      "triangles   as shipped   tension and weight alone   ratio   (residual and tangent, ns per "
      "triangle)\n");
  for (const int cells : {16, 32, 64}) {
    Panel shipped("priour/triangle", cells, registry), bare("bare/triangle", cells, registry);
    for (int i = 0; i < 4000; ++i) shipped.run(), bare.run();
    const double elements = 2.0 * cells * cells;
    std::printf("%9.0f %12.2f %26.2f %7.3f\n", elements, 1e9 * shipped.best / elements,
                1e9 * bare.best / elements, shipped.best / bare.best);
  }
}
