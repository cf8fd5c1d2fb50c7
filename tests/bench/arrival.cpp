// SPDX-License-Identifier: BSD-3-Clause
// How fast equilibria are found: iterations, time in units of one factorisation of the same tangent, how the
// time grows with the number of unknowns, the cost of a small change and of one iteration of Newton's method,
// and the gain by a second thread. The panels are those of fig. 6a and 6b of the trawl-gear paper.
//
//   bench_arrival [LARGEST [NODES…]]    most unknowns of a scene (1e5); nodes of the trawl 83-112 (1000)
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/formats/toml/diagnostics.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/folders.hpp"

namespace netloft {
namespace {

using Overrides = std::vector<std::string>;
using Change = std::function<void(scenes::LoadedScene&)>;

Registry& plugins() {
  static Registry registry = [] {
    Registry shipped;
    shipped.add_folder(netloft::test::plugin_folder());
    return shipped;
  }();
  return registry;
}

std::string scene_file(const char* name) { return netloft::test::source_folder() + "/" + name; }

runs::CaseSource source(const char* file, Overrides overrides, int threads = 1) {
  overrides.push_back("analysis.strategy=auto");
  return {scene_file(file), std::move(overrides), threads};
}

void open(runs::PreparedScene& scene, const Change& change = {}) {
  if (scene.prepare(change) == runs::PreparedScene::State::ready) return;
  for (const auto& d : scene.diagnostics().sorted()) std::fprintf(stderr, "%s\n", d.message.c_str());
  std::exit(2);
}

/// Returns the values of the tangent at x.
std::vector<double> tangent(runs::PreparedScene& scene, const std::vector<double>& x) {
  std::vector<double> values(scene.assembler().value_slots());
  scene.assembler().evaluate(x, {.matrix = MatrixKind::exact, .values = values.data()});
  values.resize(scene.assembler().pattern().value_slots());
  return values;
}

/// CPU time of one numeric factorisation of the tangent at x, the best of several [s].
double factorisation_time(runs::PreparedScene& scene, const std::vector<double>& x) {
  const SparsePattern& pattern = scene.assembler().pattern();
  const auto values = tangent(scene, x);
  auto factorisation =
      make_factorisation(pattern.symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const double begun = cpu_seconds();
    factorisation->factorise(values);
    best = std::min(best, cpu_seconds() - begun);
  }
  return best;
}

double gibibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

struct Row {
  double unknowns = 0, cpu = 0;
};

/// Sum of the statistics of the stages on the scene's mesh, without those on coarser meshes.
Statistics on_its_own_mesh(const Solution& s) {
  if (s.cost.stages.empty()) return s.cost.statistics;
  Statistics sum;
  for (const StageRecord& stage : s.cost.stages)
    if (stage.unknowns == s.u.size()) sum.add(stage.statistics);
  return sum;
}

Row print_row(runs::PreparedScene& scene, const Solution& s, double cpu) {
  const Statistics finest = on_its_own_mesh(s);
  const double unit = factorisation_time(scene, s.x);
  std::printf("  %8zu %5d %5d %6d %6d %7.1f %9.3f %7.1f %8.2f   %s\n", s.u.size(),
              s.cost.statistics.iterations, finest.iterations, finest.factorisations,
              s.cost.statistics.factorisations, s.cost.statistics.factorisation_seconds / unit, cpu,
              cpu / unit, gibibytes(), name_of(s.status));
  std::fflush(stdout);
  return {static_cast<double>(s.u.size()), cpu};
}

void print_head(const char* what) {
  std::printf("%s\n  unknowns    it.  finest  fact.    all    like     CPU s   units  GiB\n", what);
}

Row arrive(const char* file, const Overrides& overrides) {
  runs::PreparedScene scene(source(file, overrides), plugins());
  open(scene);
  const double begun = cpu_seconds();
  const Solution s = runs::find_equilibrium(scene);
  return print_row(scene, s, cpu_seconds() - begun);
}

/// Prints the exponent p of t ~ nᵖ from the first and last row: t is the CPU time, n the number of unknowns.
void print_exponent(const std::vector<Row>& rows) {
  if (rows.size() > 1)
    std::printf("  CPU time grows with the power %.2f of the unknowns\n",
                std::log(rows.back().cpu / rows.front().cpu) /
                    std::log(rows.back().unknowns / rows.front().unknowns));
}

void panels(const char* what, const char* file, double largest) {
  print_head(what);
  std::vector<Row> rows;
  for (const int n : {18, 32, 64, 128, 256, 576}) {
    if (3.0 * n * n > largest) break;
    const std::string cells = std::to_string(n);
    rows.push_back(arrive(file, {"parts.net.cells=[" + cells + "," + cells + "]"}));
  }
  print_exponent(rows);
}

/// Overrides that set the numbers of cells of a pelagic trawl: `across` a panel, along its `fore` half and
/// its `aft` half, and along a `bridle`.
Overrides trawl_cells(int across, int fore, int aft, int bridle) {
  Overrides all;
  const auto cells = [](int a, int b) { return "[" + std::to_string(a) + "," + std::to_string(b) + "]"; };
  for (const char* side : {"upper", "starboard", "lower", "port"}) {
    all.push_back(std::string("parts.") + side + ".cells=" + cells(across, fore));
    all.push_back(std::string("parts.") + side + "-bag.cells=" + cells(across, aft));
  }
  for (const char* at : {"upper-port", "upper-starboard", "lower-port", "lower-starboard"})
    all.push_back(std::string("parts.bridle-") + at + ".cells=" + std::to_string(bridle));
  return all;
}

constexpr const char* kTrawl = "tests/stability/scenes/pelagic-trawl.toml";

/// Solves the trawl at 1.5 m/s from its crude sketch, and then at a speed higher by 0.5 % from that
/// equilibrium.
void trawl(Overrides overrides) {
  overrides.push_back("water.current=[1.5,0,0]");
  runs::PreparedScene first(source(kTrawl, overrides), plugins());
  open(first);
  double begun = cpu_seconds();
  const Solution s = runs::find_equilibrium(first);
  print_row(first, s, cpu_seconds() - begun);
  overrides.back() = "water.current=[1.5075,0,0]";
  overrides.push_back("analysis.strategy=direct");
  runs::PreparedScene next(source(kTrawl, overrides), plugins());
  const std::vector<double> at_rest = first.assembler().node_positions(s.x);
  open(next, [&](scenes::LoadedScene& loaded) {
    for (std::size_t d = 0; d < at_rest.size(); ++d)
      if (loaded.scene.held[d / 3] == 0) loaded.scene.positions[d] = at_rest[d];
  });
  begun = cpu_seconds();
  const Solution changed = runs::find_equilibrium(next);
  print_row(next, changed, cpu_seconds() - begun);
}

/// Solves by Newton's method alone, on the scene's mesh, from the equilibrium at a speed lower by 0.5 %.
void newton(int nodes) {
  const char* file = "gear-library/scenes/83-112-flume-3.0kn.toml";
  const Overrides overrides{"gear.nodes=" + std::to_string(nodes)};
  runs::PreparedScene first(source(file, overrides), plugins());
  open(first);
  const std::vector<double> from = first.assembler().node_positions(runs::find_equilibrium(first).x);
  runs::PreparedScene next(
      {scene_file(file),
       {overrides[0], "tow.speed=3.015 kn", "analysis.strategy=direct", "analysis.solver=newton"},
       1},
      plugins());
  open(next, [&](scenes::LoadedScene& loaded) {
    for (std::size_t d = 0; d < from.size(); ++d)
      if (loaded.scene.held[d / 3] == 0) loaded.scene.positions[d] = from[d];
  });
  const Solution s = runs::find_equilibrium(next);
  const Statistics& cost = s.cost.statistics;
  const double unit = factorisation_time(next, s.x), per_iteration = 1.0 / cost.iterations,
               iteration = cost.solver_cpu_seconds * per_iteration,
               own = cost.factorisation_seconds / cost.factorisations;
  std::printf("  %8d %9zu %5d %9.2f %9.2f %9.2f %8.2f %10.3f %9.2f %10.3f %9.2f   %s\n", nodes, s.u.size(),
              cost.iterations, cost.factorisations * per_iteration, cost.residuals * per_iteration,
              cost.matrices * per_iteration, cost.solves * per_iteration, 1e3 * unit, iteration / unit,
              1e3 * own, iteration / own, name_of(s.status));
  std::fflush(stdout);
}

/// Wall time of one evaluation of residual and tangent, the least of several [s].
double assembly_time(runs::PreparedScene& scene, const std::vector<double>& x) {
  std::vector<double> values(scene.assembler().value_slots()), residual(x.size());
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 40; ++i) {
    const double begun = wall_seconds();
    scene.assembler().evaluate(
        x, {.residual = residual.data(), .matrix = MatrixKind::exact, .values = values.data()});
    best = std::min(best, wall_seconds() - begun);
  }
  return best;
}

void threads() {
  const Overrides overrides = trawl_cells(12, 24, 16, 8);
  runs::PreparedScene one(source(kTrawl, overrides, 1), plugins()),
      two(source(kTrawl, overrides, 2), plugins());
  open(one), open(two);
  const Solution a = runs::find_equilibrium(one), b = runs::find_equilibrium(two);
  std::printf("one thread and two: %s", a.x == b.x ? "the same bits" : "DIFFERENT");
  runs::PreparedScene big_one(source(kTrawl, trawl_cells(40, 80, 48, 24), 1), plugins());
  runs::PreparedScene big_two(source(kTrawl, trawl_cells(40, 80, 48, 24), 2), plugins());
  open(big_one), open(big_two);
  const std::vector<double> x = big_one.assembler().start();
  double best_one = assembly_time(big_one, x), best_two = assembly_time(big_two, x);
  for (int i = 0; i < 4; ++i) {  // in turns, so that a busy machine slows down both
    best_one = std::min(best_one, assembly_time(big_one, x));
    best_two = std::min(best_two, assembly_time(big_two, x));
  }
  std::printf("; assembly of %zu unknowns %.2f times as fast with two\n", x.size(), best_one / best_two);
}

}  // namespace
}  // namespace netloft

int main(int count, char** arguments) {
  using namespace netloft;
  const double largest = count > 1 ? std::atof(arguments[1]) : 1e5;
  std::vector<int> nodes{1000};
  if (count > 2) nodes.clear();
  for (int i = 2; i < count; ++i) nodes.push_back(std::atoi(arguments[i]));
  std::printf(
      "units: CPU time over that of one factorisation of the same tangent; finest, fact.: on the scene's own "
      "mesh;\n"
      "all: factorisations on all meshes; like: their time, as if all were of the scene's own tangent\n");
  panels("hanging panel, from the flat sketch", "gear-library/scenes/dead-weight-panel.toml", largest);
  panels("stretched panel", "gear-library/scenes/verification/stretched-panel.toml", largest);
  print_head("body of a pelagic trawl at 1.5 m/s from its sketch; then at half a per cent more");
  trawl(trawl_cells(12, 24, 16, 8));
  if (largest > 6e4) trawl(trawl_cells(40, 80, 48, 24));
  threads();
  std::printf(
      "one iteration of Newton's method: the 83-112 from 3.0 to 3.015 knots\n"
      "     nodes  unknowns   it.    fact. residuals  matrices   solves  factor ms     units   own ms      "
      "own   "
      "(units and own: of the iteration, in factorisations alone and in those of the same run)\n");
  for (const int n : nodes) newton(n);
  return 0;
}
