// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/restarts.hpp"

#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <utility>

namespace netloft::automatic {

namespace {

/// Largest force on a node that only resistance to compression bears, over the largest load.
double borne_by_compression(Study& study, const Stage& at) {
  return study.assess({.name = "what is in compression", .variant = {.compression = 0}}, at.u).imbalance();
}

bool may_have_other_shapes(Study& study, const Options& options, const Stage& at) {
  if (options.everywhere) return !study.remembers();
  return study.conservative() && study.resists_compression() && !study.remembers() &&
         borne_by_compression(study, at) > options.counts;
}

Stage solve_from(Study& study, const Options& options, int turn, const Stage& best, double work) {
  const Ask ask{.name = "restart", .work = work};
  if (turn == 1) {
    const Stage convex = study.solve(
        {.name = "nothing in compression", .variant = {.compression = 0}, .tolerance = 1e-4, .work = work},
        best.u);
    return study.work_left() > 0 ? study.call("direct", "", ask, convex.u) : Stage{};
  }
  return study.call("direct", "", ask, perturbed(best.u, options.far * study.element_size(), turn));
}

}  // namespace

void restart(Study& study, const Options& options, const Stage& first, double work) {
  if (options.restarts == 0 || is_left_out(options, "restarts")) return;
  if (!may_have_other_shapes(study, options, first)) return;
  Stage best = first;
  double left = options.restart_work * work;
  for (int turn = 1; turn <= options.restarts && left > 0 && study.work_left() > 0; ++turn) {
    const double before = study.work_left();
    Stage next = solve_from(study, options, turn, best, std::min(left, before));
    left -= before - study.work_left();
    if (!next.has_converged()) continue;
    study.answer(next.u);
    if (study.conservative() && next.energy < best.energy) best = std::move(next);
  }
}

}  // namespace netloft::automatic
