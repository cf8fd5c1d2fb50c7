// SPDX-License-Identifier: BSD-3-Clause
// Compares orderings and factorisations on tangents of the hanging panel and on nets like cod-ends, in one
// run, because only ratios of times can be compared between machines.
//
//   bench_factorisation [SIDE…]    cells or nodes along one side; 3·SIDE² unknowns
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>

#include "framework/assembler/assembler.hpp"
#include "framework/registry/registry.hpp"
#include "framework/scene/scene_plan.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "tests/bench/cholmod_factorisation.hpp"
#include "tests/folders.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

/// CPU time of `work`, the best of several [s]. A busy machine changes it less than wall time.
double time_of(const std::function<void()>& work, int repeats) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    work();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

/// Memory allocated by malloc [bytes]. A factorisation keeps its memory, so that the difference between two
/// calls is its size.
double memory() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

struct Cost {
  double analyse, factorise, solve;  // [s]
  double entries, flops;             // of the factor
  double memory;                     // [bytes]
  FactorResult result;
};

Cost measure(Factorisation& factorisation, const TestMatrix& matrix) {
  const int repeats = matrix.pattern.size < 30000 ? 20 : matrix.pattern.size < 200000 ? 5 : 3;
  std::vector<double> x(matrix.pattern.size, 1.0);
  Cost cost{};
  const double before = memory();
  cost.analyse = time_of([&] { factorisation.analyse(matrix.pattern); }, 2);
  cost.factorise = time_of([&] { cost.result = factorisation.factorise(matrix.value); }, repeats);
  if (cost.result.status == FactorStatus::ok)
    cost.solve = time_of([&] { factorisation.solve(x, x); }, repeats);
  cost.memory = memory() - before;
  cost.entries = factorisation.factor_entries();
  cost.flops = factorisation.factor_flops();
  return cost;
}

/// Prints the lines of one table. Each line ends with its ratios to the first line.
class Table {
 public:
  explicit Table(const char* what, const TestMatrix& matrix) {
    std::printf("%d unknowns, %s\n", matrix.pattern.size, what);
  }
  void add(const char* name, const Cost& c) {
    if (first_.factorise == 0) first_ = c;
    std::printf("  %-22s %8.1f %9.2f %8.2f %9.3g %9.3g %7.0f   %5.2f %5.2f %5.2f %5.2f", name,
                1e3 * c.analyse, 1e3 * c.factorise, 1e3 * c.solve, c.entries, c.flops, 1e-6 * c.memory,
                c.analyse / first_.analyse, c.factorise / first_.factorise, c.solve / first_.solve,
                c.flops / first_.flops);
    if (c.result.negative_pivots > 0) std::printf("   %d negative", c.result.negative_pivots);
    std::printf("%s\n", c.result.status == FactorStatus::ok ? "" : "   REFUSED");
  }

 private:
  Cost first_{};
};

void compare_definite(const char* what, const TestMatrix& m) {
  Table table(what, m);
  table.add("multifrontal best", measure(*make_definite_factorisation(), m));
  table.add("multifrontal METIS", measure(*make_definite_factorisation(OrderingMethod::metis), m));
  table.add("multifrontal AMD", measure(*make_definite_factorisation(OrderingMethod::amd), m));
  if (has_mumps())
    table.add("MUMPS LDLT best", measure(*make_mumps_factorisation(MatrixClass::symmetric), m));
  if (const auto cholmod = make_cholmod_factorisation()) table.add("CHOLMOD", measure(*cholmod, m));
}

void compare_indefinite(const char* what, const TestMatrix& m) {
  Table table(what, m);
  if (has_mumps()) {
    table.add("MUMPS LDLT best", measure(*make_mumps_factorisation(MatrixClass::symmetric), m));
    table.add("MUMPS LDLT AMD",
              measure(*make_mumps_factorisation(MatrixClass::symmetric, OrderingMethod::amd), m));
  }
}

void compare_unsymmetric(const char* what, const TestMatrix& m) {
  Table table(what, m);
  table.add("multifrontal best", measure(*make_multifrontal_factorisation(nullptr), m));
  if (has_mumps())
    table.add("MUMPS LU best", measure(*make_mumps_factorisation(MatrixClass::unsymmetric), m));
}

/// The tangent at the start of the panel across a current of `speed`, where forces are out of balance as in
/// an iteration, plus `shift` times the linear stiffness.
TestMatrix tangent_of_panel(int cells, double speed, MatrixKind kind, double shift, Registry& registry) {
  Scene scene = sample::hanging_panel(cells, 36.5);
  if (speed > 0) scene.current.samples = {{0, {0, speed, 0}}};
  const ScenePlan plan = make_scene_plan(scene, registry);
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

void compare_on_panel(int cells, Registry& registry) {
  compare_definite("panel, convex part", tangent_of_panel(cells, 0, MatrixKind::convex, 1e-3, registry));
  compare_indefinite("panel, exact tangent", tangent_of_panel(cells, 0, MatrixKind::exact, 1e-3, registry));
  compare_unsymmetric("panel in a current", tangent_of_panel(cells, 1, MatrixKind::exact, 1e-3, registry));
}

void compare_on_nets(int side) {
  const NetOptions triangles{.rings = side, .nodes_per_ring = side}, squares{side, side, false};
  compare_definite("tube of triangles", make_net_matrix(triangles));
  compare_definite("tube of squares", make_net_matrix(squares));
}

}  // namespace
}  // namespace netloft

int main(int count, char** arguments) {
  netloft::Registry registry;
  registry.add_folder(netloft::test::plugin_folder());
  std::vector<int> sides{18, 63, 183};
  if (count > 1) sides.clear();
  for (int i = 1; i < count; ++i) sides.push_back(std::max(3, std::atoi(arguments[i])));
  std::printf("%25s%8s%10s%9s%10s%10s%8s   %s\n", "CPU ms:", "analyse", "factorise", "solve", "entries",
              "flops", "MB", "ratios to the first line");
  for (const int side : sides) {
    netloft::compare_on_panel(side, registry);
    netloft::compare_on_nets(side);
  }
}
