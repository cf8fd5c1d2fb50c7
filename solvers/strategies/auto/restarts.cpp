// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/restarts.hpp"

#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <utility>

namespace netloft::automatic {

namespace {

/// Removes the resistance to compression at the equilibrium `at`. Returns the largest force on a node that
/// this leaves out of balance, relative to the largest load.
double borne_by_compression(Search& search, const Stage& at) {
  return search.assess({.name = "what is in compression", .variant = {.compression = 0}}, at.u).imbalance();
}

/// Whether other equilibria are possible. Compression below kOnlyAStart of the load counts as none.
bool may_have_other_shapes(Search& search, const Options& options, const Stage& at) {
  return may_restart(search, options) &&
         (options.everywhere || borne_by_compression(search, at) > kOnlyAStart);
}

/// Returns the equilibrium without resistance to compression, in which parts in compression have folded.
Displacements without_compression(Search& search, const Stage& best, double work) {
  const Ask ask{.name = "nothing in compression",
                .variant = {.compression = 0},
                .tolerance = kOnlyAStart,
                .work = work};
  return search.solve(ask, best.u).u;
}

Displacements start_of(Search& search, int shape, const Stage& best, double work) {
  return shape == 1 ? without_compression(search, best, work)
                    : perturbed(best.u, search.element_size(), shape);
}

}  // namespace

bool may_restart(const Search& search, const Options& options) {
  if (options.restarts == 0 || is_left_out(options, "restarts") || search.remembers()) return false;
  return options.everywhere || (search.conservative() && search.resists_compression());
}

void restart(Search& search, const Options& options, const Stage& first) {
  if (!may_have_other_shapes(search, options, first)) return;
  Stage best = first;
  for (int shape = 1; shape <= options.restarts && search.work_left() > 0; ++shape) {
    const double end = std::max(0.0, search.work_left() - options.slice);
    const auto start = start_of(search, shape, best, search.work_left() - end);
    if (search.work_left() <= end) continue;
    Stage next = search.call("direct", "", {.name = "restart", .work = search.work_left() - end}, start);
    if (!next.has_converged()) continue;
    search.answer(next.u);
    if (search.conservative() && next.energy < best.energy) best = std::move(next);
  }
}

}  // namespace netloft::automatic
