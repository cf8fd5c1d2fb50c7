// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/restarts.hpp"

#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <utility>

namespace netloft::automatic {

namespace {

/// Removes the resistance to compression at the equilibrium `at`. Returns the largest force on a node that is
/// then unbalanced, relative to the largest load.
double borne_by_compression(Search& search, const Stage& at) {
  return search.assess({.name = "what is in compression", .variant = {.compression = 0}}, at.u).imbalance();
}

double borne_by_bending(Search& search, const Stage& at) {
  return at.has_forces() ? search.bending(at.u) / at.load : 0;
}

/// Returns the equilibrium without resistance to compression, in which parts in compression have folded.
Displacements without_compression(Search& search, const Stage& best, double work) {
  const Ask ask{.name = "nothing in compression",
                .variant = {.compression = 0},
                .tolerance = kOnlyAStart,
                .work = work};
  return search.solve(ask, best.u).u;
}

/// The searches for other shapes after the first equilibrium.
class Restarts {
 public:
  Restarts(Search& search, const Stage& first, double work) : search_(search), best_(first), work_(work) {}

  void begin() { end_ = std::max(0.0, search_.work_left() - work_); }
  double left() const { return search_.work_left() - end_; }
  const Stage& best() const { return best_; }

  /// Lets a strategy solve from `start` with the work that is left for this restart. A result that equals the
  /// best shape bit for bit is ignored: the strategy has then solved the same problem as in the race.
  void solve(const char* strategy, const Displacements& start) {
    if (left() <= 0) return;
    Stage next = search_.call(strategy, "", {.name = "restart", .work = left()}, start);
    if (!next.has_converged() || next.u == best_.u) return;
    search_.answer(next.u);
    if (search_.conservative() && next.energy < best_.energy) best_ = std::move(next);
  }

 private:
  Search& search_;
  Stage best_;
  double work_, end_ = 0;  // work of each search; work left at the end of the current one
};

}  // namespace

bool may_restart(const Search& search, const Options& options) {
  if (options.restarts == 0 || is_left_out(options, "restarts") || search.remembers()) return false;
  return options.everywhere ||
         (search.conservative() && (search.resists_compression() || search.resists_bending()));
}

void restart(Search& search, const Options& options, const Displacements& start, const Stage& first,
             double spent) {
  if (!may_restart(search, options)) return;
  const bool bends =
      search.conservative() && search.resists_bending() && borne_by_bending(search, first) > kOnlyAStart;
  const bool folds = options.everywhere ||
                     (search.resists_compression() && borne_by_compression(search, first) > kOnlyAStart);
  const double size = search.element_size();
  Restarts restarts(search, first, options.slice + spent);
  for (int shape = 1; shape <= options.restarts; ++shape) {
    for (const char* strategy : {"stiffness-steps", "direct"}) {
      restarts.begin();
      if (bends) restarts.solve(strategy, shape == 1 ? start : perturbed(start, size, shape));
    }
    restarts.begin();
    if (folds && restarts.left() > 0)
      restarts.solve("direct", shape == 1 ? without_compression(search, restarts.best(), restarts.left())
                                          : perturbed(restarts.best().u, size, shape));
  }
}

}  // namespace netloft::automatic
