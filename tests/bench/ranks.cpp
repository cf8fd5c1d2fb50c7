// SPDX-License-Identifier: BSD-3-Clause
// One factorisation of a tangent of the hanging panel, by this process or by all that mpirun has started; and
// the evaluations that give it.
//
//   [mpirun -n N] bench_ranks CELLS definite|indefinite|unsymmetric ranks|same-bits|THREADS [REPEATS]
//
// REPEATS 0: analysis alone, of which the memory foreseen for more ranks than there are processors.
//
// Rank 0 prints one JSON object: unknowns, wall clock of analysis, of the fastest factorisation and of the
// fastest solution [s], operations and entries of the factor, what was foreseen for the rank that takes most
// [bytes], the backward error, whether all repetitions gave the same bits, and a hash of those. On ranks it
// prints another one: wall clock of the fastest evaluation of a residual, and of one with its tangent, by
// rank 0 alone and by all ranks, by turns [s]; and how long it takes until the others have the scene. Every
// rank prints what its memory has grown by at most [bytes].
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>

#include "framework/ranks/rank_team.hpp"
#include "framework/ranks/share_server.hpp"
#include "solvers/factorisation/factorisation.hpp"
#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/ranks.hpp"
#include "tests/bench/panel_tangent.hpp"
#include "tests/folders.hpp"

namespace netloft {
namespace {

struct Task {
  int cells = 0;
  MatrixClass kind = MatrixClass::positive_definite;
  int threads = 0;  // 0: on ranks
  bool has_same_bits = false;
  int repeats = 3;
};

Task task_of(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("bench_ranks CELLS definite|indefinite|unsymmetric ranks|same-bits|THREADS [REPEATS]\n",
               stderr);
    std::exit(2);
  }
  Task task;
  task.cells = std::atoi(argv[1]);
  if (std::strcmp(argv[2], "unsymmetric") == 0) task.kind = MatrixClass::unsymmetric;
  if (std::strcmp(argv[2], "indefinite") == 0) task.kind = MatrixClass::symmetric;
  task.has_same_bits = std::strcmp(argv[3], "same-bits") == 0;
  if (!task.has_same_bits && std::strcmp(argv[3], "ranks") != 0)
    task.threads = std::max(1, std::atoi(argv[3]));
  if (argc > 4) task.repeats = std::atoi(argv[4]);
  return task;
}

double time_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::size_t hash_of(const std::vector<double>& x) {
  return std::hash<std::string_view>{}({reinterpret_cast<const char*>(x.data()), x.size() * sizeof(double)});
}

struct Cost {
  double analyse = 0;
  double factorise = 1e9, solve = 1e9;  // [s]
  bool has_same_bits = true;
  std::size_t hash = 0;
  double error = 0;
};

/// With entry k at place k, as TestMatrix::backward_error wants it.
TestMatrix without_slots(const TestMatrix& matrix) {
  TestMatrix plain = matrix;
  plain.pattern.slot.clear();
  plain.value.resize(plain.pattern.entries());
  for (std::size_t e = 0; e < plain.value.size(); ++e)
    plain.value[e] = matrix.value[matrix.pattern.slot_of(e)];
  return plain;
}

Cost measure(Factorisation& factorisation, const TestMatrix& matrix, int repeats) {
  std::vector<double> b(matrix.pattern.size), x(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::cos(0.3 * static_cast<double>(i));
  Cost cost;
  cost.analyse = time_of([&] { factorisation.analyse(matrix.pattern); });
  for (int i = 0; i < repeats; ++i) {
    FactorResult result;
    const double seconds = time_of([&] { result = factorisation.factorise(matrix.value); });
    if (result.status != FactorStatus::ok) std::exit(1);
    factorisation.solve(b, x);  // checked, and perhaps refined
    cost.factorise = std::min(cost.factorise, seconds);
    cost.has_same_bits = cost.has_same_bits && (i == 0 || hash_of(x) == cost.hash);
    cost.hash = hash_of(x);
    cost.solve = std::min(cost.solve, time_of([&] { factorisation.solve(b, x); }));
  }
  if (repeats > 0) cost.error = without_slots(matrix).backward_error(x, b);
  return cost;
}

/// Of rank 0 alone and of all ranks, by turns. They have the same bits, or the bench ends.
void measure_evaluations(const Task& task, Ranks& ranks, Registry& registry) {
  const bool is_symmetric = task.kind != MatrixClass::unsymmetric;
  const Scene scene = panel_in_current(task.cells, is_symmetric ? 0 : 1);
  const Plan plan = make_plan(scene, registry);
  RankTeam team(ranks, 1);
  std::unique_ptr<Assembler> alone, shared;
  const double one = time_of([&] { alone = make_assembler(scene, plan, {1, nullptr}); });
  const double all = time_of([&] { shared = make_assembler(scene, plan, {1, &team}); });
  std::vector<double> r(alone->start().size()), r_shared(r), values(alone->value_slots());
  double residual[2] = {1e9, 1e9}, tangent[2] = {1e9, 1e9};
  for (int i = 0; i < task.repeats; ++i)
    for (const int who : {0, 1}) {
      Assembler& assembler = who == 0 ? *alone : *shared;
      Request request{.residual = who == 0 ? r.data() : r_shared.data()};
      residual[who] = std::min(residual[who], time_of([&] { assembler.evaluate(alone->start(), request); }));
      request.matrix = is_symmetric ? MatrixKind::convex : MatrixKind::exact, request.values = values.data();
      tangent[who] = std::min(tangent[who], time_of([&] { assembler.evaluate(alone->start(), request); }));
    }
  if (hash_of(r) != hash_of(r_shared)) std::exit(1);
  std::printf(
      "{\"unknowns\": %d, \"make\": [%.3g, %.3g], \"residual\": [%.3g, %.3g], \"with_tangent\": [%.3g, "
      "%.3g]}\n",
      alone->pattern().size, one, all, residual[0], residual[1], tangent[0], tangent[1]);
}

void print_memory(int rank, double before) {
  std::printf("{\"rank\": %d, \"grown_bytes\": %.0f}\n", rank, peak_bytes() - before);
}

void run(const Task& task, Ranks* ranks) {
  Registry registry;
  registry.add_folder(test::plugin_folder());
  const bool is_symmetric = task.kind != MatrixClass::unsymmetric;
  const TestMatrix matrix =
      tangent_of_panel(task.cells, is_symmetric ? 0 : 1,
                       is_symmetric ? MatrixKind::convex : MatrixKind::exact, 1e-3, registry);
  const double before = peak_bytes();
  const auto factorisation = make_factorisation_with(
      std::max(task.threads, 1), ranks ? RankUse{ranks, 1, task.has_same_bits} : RankUse{})(task.kind);
  const Cost cost = measure(*factorisation, matrix, task.repeats);
  std::printf(
      "{\"what\": \"%s\", \"unknowns\": %d, \"analyse\": %.4f, \"factorise\": %.4f, \"solve\": %.4f, "
      "\"flops\": %.4g, \"entries\": %.4g, \"foreseen_bytes\": %.4g, \"error\": %.2g, \"same_bits\": %s, "
      "\"hash\": \"%zx\"}\n",
      factorisation->description().c_str(), matrix.pattern.size, cost.analyse, cost.factorise, cost.solve,
      factorisation->factor_flops(), factorisation->factor_entries(), factor_bytes_of(*factorisation),
      cost.error, cost.has_same_bits ? "true" : "false", cost.hash);
  if (ranks && task.repeats > 0) measure_evaluations(task, *ranks, registry);
  print_memory(0, before);
}

}  // namespace
}  // namespace netloft

int main(int argc, char** argv) {
  using namespace netloft;
  const Task task = task_of(argc, argv);
  if (task.threads > 0) return run(task, nullptr), 0;
  Ranks ranks(test::plugin_folder() + "/mpi/mumps_mpi.so", launch_of_environment());
  if (ranks.rank() == 0) return run(task, &ranks), 0;
  const double before = peak_bytes();
  ShareServer shares(ranks, [](Registry& registry) { registry.add_folder(test::plugin_folder()); });
  ranks.serve(&shares);
  print_memory(ranks.rank(), before);
}
