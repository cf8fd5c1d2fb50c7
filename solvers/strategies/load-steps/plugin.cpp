// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

namespace {

using namespace netloft;

/// Continuation in the current, from still water to the full current. A step is doubled if its stage
/// converged, and halved if not.
struct LoadSteps {
  struct Parameters {
    double step = 0, shortest = 0;
  };

  static void run(const Parameters& p, Search& search) {
    if (!search.flows()) return search.decline("there is no current");
    Displacements u = solve_at(search, 0, search.start()).u;
    double fraction = 0;
    for (double step = p.step; fraction + step < 1 && search.work_left() > 0;) {
      Stage stage = solve_at(search, fraction + step, u);
      if (stage.is_stationary()) {
        fraction += step;
        u = std::move(stage.u);
        step *= 2;
      } else if ((step *= 0.5) < p.shortest)
        return search.decline("steps of the current became too short");
    }
    if (search.work_left() == 0) return;
    const Stage stage = search.solve({.name = "from slow to fast"}, u);
    if (stage.is_stationary()) search.answer(stage.u);
  }

  static std::string explain(const Parameters&, Search& search) {
    return search.flows() ? "still water, then more and more of the current\n"
                          : "nothing: there is no current\n";
  }

 private:
  static Stage solve_at(Search& search, double fraction, const Displacements& u) {
    return search.solve({.name = "slower", .variant = {.current = fraction}, .tolerance = kOnlyAStart}, u);
  }
};

}  // namespace

NETLOFT_PLUGIN("load-steps", "0.1.0", "From still water to the whole current") {
  auto& s = plugin.strategy<LoadSteps>("load-steps", "From still water to the whole current, by steps");
  using P = LoadSteps::Parameters;
  s.real("step", &P::step, "1", "first fraction of the scene's current",
         {.lo = 1e-6, .hi = 1, .fallback = 0.25});
  s.real("shortest", &P::shortest, "1", "step below which it gives up",
         {.lo = 1e-9, .hi = 1, .fallback = 1.0 / 64});
}
