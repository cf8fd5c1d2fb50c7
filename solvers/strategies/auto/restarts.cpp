// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/restarts.hpp"

#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <utility>

namespace netloft::automatic {

namespace {

/// Largest force on a node that only resistance to compression bears, over the largest load: what is out of
/// balance at an equilibrium as soon as nothing resists compression any more.
double borne_by_compression(Study& study, const Stage& at) {
  return study.assess({.name = "what is in compression", .variant = {.compression = 0}}, at.u).imbalance();
}

/// Compression below what a start may be off by cannot be distinguished from none.
bool may_have_other_shapes(Study& study, const Options& options, const Stage& at) {
  return may_restart(study, options) && (options.everywhere || borne_by_compression(study, at) > kOnlyAStart);
}

/// Where the gear would be if nothing resisted compression: what is in compression is folded there.
Displacements without_compression(Study& study, const Stage& best, double work) {
  const Ask ask{.name = "nothing in compression",
                .variant = {.compression = 0},
                .tolerance = kOnlyAStart,
                .work = work};
  return study.solve(ask, best.u).u;
}

Displacements start_of(Study& study, int shape, const Stage& best, double work) {
  return shape == 1 ? without_compression(study, best, work) : perturbed(best.u, study.element_size(), shape);
}

}  // namespace

bool may_restart(const Study& study, const Options& options) {
  if (options.restarts == 0 || is_left_out(options, "restarts") || study.remembers()) return false;
  return options.everywhere || (study.conservative() && study.resists_compression());
}

void restart(Study& study, const Options& options, const Stage& first) {
  if (!may_have_other_shapes(study, options, first)) return;
  Stage best = first;
  for (int shape = 1; shape <= options.restarts && study.work_left() > 0; ++shape) {
    const double end = std::max(0.0, study.work_left() - options.slice);
    const auto start = start_of(study, shape, best, study.work_left() - end);
    if (study.work_left() <= end) continue;
    Stage next = study.call("direct", "", {.name = "restart", .work = study.work_left() - end}, start);
    if (!next.has_converged()) continue;
    study.answer(next.u);
    if (study.conservative() && next.energy < best.energy) best = std::move(next);
  }
}

}  // namespace netloft::automatic
