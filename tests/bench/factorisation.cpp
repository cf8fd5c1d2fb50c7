// SPDX-License-Identifier: BSD-3-Clause
// Orderings and factorisations against each other, in one run, because only ratios travel between machines.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>

#include "solvers/factorisation/cholmod.hpp"
#include "solvers/factorisation/umfpack.hpp"
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

/// CPU time of `work`, the best of several [s]. CPU and not wall, so that a busy machine does less harm.
double time_of(const std::function<void()>& work, int repeats) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    work();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

struct Times {
  double analyse, factorise, solve;  // [s]
  double entries, flops;             // of the factor
};

Times measure(Factorisation& factorisation, const TestMatrix& net) {
  const int repeats = net.pattern.size < 30000 ? 50 : 5;
  std::vector<double> x(net.pattern.size, 1.0);
  Times times{};
  times.analyse = time_of([&] { factorisation.analyse(net.pattern); }, 3);
  times.factorise = time_of([&] { factorisation.factorise(net.value); }, repeats);
  times.solve = time_of([&] { factorisation.solve(x, x); }, repeats);
  times.entries = factorisation.factor_entries();
  times.flops = factorisation.factor_flops();
  return times;
}

void print(const char* name, const Times& t, const Times& reference) {
  std::printf("  %-14s %9.2f %9.2f %9.2f %9.3g %9.3g   %5.2f %5.2f %5.2f %5.2f\n", name, 1e3 * t.analyse,
              1e3 * t.factorise, 1e3 * t.solve, t.entries, t.flops, t.analyse / reference.analyse,
              t.factorise / reference.factorise, t.solve / reference.solve, t.flops / reference.flops);
}

void compare(int side, bool diagonals) {
  NetOptions options{.rings = side, .nodes_per_ring = side, .diagonals = diagonals};
  const TestMatrix net = make_net_matrix(options);
  options.symmetric = false;
  const TestMatrix full = make_net_matrix(options);
  std::printf("%d unknowns, %s\n", net.pattern.size, diagonals ? "triangles" : "squares");

  const Times best = measure(*make_cholmod_factorisation(), net);
  print("CHOLMOD best", best, best);
  print("CHOLMOD METIS", measure(*make_cholmod_factorisation(OrderingMethod::metis), net), best);
  print("CHOLMOD AMD", measure(*make_cholmod_factorisation(OrderingMethod::amd), net), best);
  print("UMFPACK best", measure(*make_umfpack_factorisation(), full), best);
  print("UMFPACK METIS", measure(*make_umfpack_factorisation(OrderingMethod::metis), full), best);
  print("UMFPACK AMD", measure(*make_umfpack_factorisation(OrderingMethod::amd), full), best);
}

}  // namespace
}  // namespace netloft

int main() {
  std::printf(
      "CPU ms:             analyse factorise     solve   entries     flops   ratios to the first line\n");
  for (const int side : {18, 58, 183}) {
    for (const bool diagonals : {true, false}) netloft::compare(side, diagonals);
  }
}
