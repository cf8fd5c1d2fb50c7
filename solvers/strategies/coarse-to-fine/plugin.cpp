// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

#include <string>
#include <utility>

namespace {

using namespace netloft;

/// Grid sequencing (nested iteration: W. Hackbusch, Multi-Grid Methods and Applications, 1985, section 5).
/// The strategy `by` brings a coarser mesh of the same gear to equilibrium, possibly with the help of still
/// coarser meshes; from that equilibrium, the strategy `then` solves the scene itself. A coarser mesh gets at
/// most half of the work. If it has not converged by then, the strategy gives up and leaves the other half to
/// its caller. Without this limit, a coarse mesh could use up the budget before the next finer mesh is tried.
struct CoarseToFine {
  struct Parameters {
    const char *by = nullptr, *then = nullptr;
  };

  static void run(const Parameters& p, Search& search) {
    if (!has_coarser(search)) return search.decline("there is no coarser mesh");
    const Specification by = specification_of(p.by);
    const Stage coarse = search.call(by.name.c_str(), by.parameters.c_str(),
                                     {.name = "on a coarser mesh",
                                      .variant = {.level = 1},
                                      .tolerance = kOnlyAStart,
                                      .work = kMostOfCoarser * search.work_left()},
                                     search.transfer(0, search.start(), 1));
    if (!coarse.has_converged())
      return search.decline(coarse.was_cut_off() ? "a coarser mesh did not converge with half of the work"
                                                 : "a coarser mesh was not solved");
    const Displacements start = search.transfer(1, coarse.u, 0);
    Stage fine = *p.then ? called_from(start, p, search) : search.solve({.name = kFromCoarser}, start);
    if (fine.is_stationary()) search.answer(fine.u);
  }

  static std::string explain(const Parameters& p, Search& search) {
    return has_coarser(search) ? std::string("half as many cells along a side by ") + p.by +
                                     ", then the scene itself from there" +
                                     (*p.then ? std::string(" by ") + p.then : "") + "\n"
                               : "nothing: there is no coarser mesh\n";
  }

 private:
  static constexpr const char* kFromCoarser = "from a coarser mesh";
  /// Largest fraction of the work for the coarser mesh. With 1, the hard cases take a fifth to a quarter more
  /// factorisations than with ½; with ¼, they take as many as with ½ (tests/bench/sensitivity.md).
  static constexpr double kMostOfCoarser = 0.5;

  /// Solves the scene by the strategy `then`. The start is assessed first, so that there is a result even if
  /// that strategy is cut off before it has solved anything.
  static Stage called_from(const Displacements& start, const Parameters& p, Search& search) {
    Stage fine = search.assess({.name = kFromCoarser}, start);
    const Specification then = specification_of(p.then);
    if (!fine.is_stationary())
      fine = search.call(then.name.c_str(), then.parameters.c_str(), {.name = kFromCoarser}, start);
    return fine.is_stationary() || search.work_left() == 0 ? std::move(fine)
                                                           : search.solve({.name = kFromCoarser}, start);
  }
  static bool has_coarser(Search& search) { return search.levels() > 1 && search.size(1) > 0; }
};

}  // namespace

NETLOFT_PLUGIN("coarse-to-fine", "0.1.0", "Grid sequencing") {
  auto& strategy = plugin.strategy<CoarseToFine>(
      "coarse-to-fine", "Solves the scene itself from the equilibrium of a coarser mesh");
  strategy.strategy("by", &CoarseToFine::Parameters::by, "strategy that solves the coarser mesh", "direct");
  strategy.strategy("then", &CoarseToFine::Parameters::then,
                    "strategy that then solves the scene itself; empty, or if it finds nothing: the solver",
                    "");
}
