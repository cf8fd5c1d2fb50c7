// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace netloft;

/// Continuation in the stiffness: if bars must turn, Newton's method can take only short steps with stiff
/// bars, but turns soft bars in one step. The scene is solved with a cap C on all axial stiffnesses,
///   C₁ = f F,  C_{k+1} = f C_k until C_k reaches the largest stiffness                    (1)
/// with the factor f and the largest load F on a node (E. L. Allgower and K. Georg, Introduction to Numerical
/// Continuation Methods, 2003, ch. 6). If no equilibrium is found with a cap, no further cap is tried; the
/// scene itself is then solved from the end of that stage. Each cap is solved to the tolerance of the scene:
/// a small residual force can displace slack netting between steel ropes by a long way; removing the force
/// costs the fewest iterations while the ropes are soft (tests/bench/sensitivity.md).
struct StiffnessSteps {
  struct Parameters {
    double factor = 0;
  };

  static void run(const Parameters& p, Search& search) {
    const double first = first_cap(p, search);
    if (!(first > 0) || first >= search.stiffness()) return search.decline("the gear is soft for its load");
    const auto u = stiffened(p, search, first);
    if (search.work_left() == 0) return;
    const Stage stage = search.solve({.name = "from soft to stiff"}, u);
    if (stage.is_stationary()) search.answer(stage.u);
  }

  static std::string explain(const Parameters& p, Search& search) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "stiffnesses up to %.3g N at first, then %.3g times as much, up to %.3g N\n",
                  first_cap(p, search), p.factor, search.stiffness());
    const bool has_steps = first_cap(p, search) > 0 && first_cap(p, search) < search.stiffness();
    return has_steps ? text : "nothing: the gear is soft for its load\n";
  }

 private:
  static double first_cap(const Parameters& p, Search& search) { return p.factor * search.largest_load(); }

  /// Returns the equilibrium with the largest cap of (1), or the state in which the first failed solve ended.
  static Displacements stiffened(const Parameters& p, Search& search, double cap) {
    Displacements u = search.start();
    for (; cap < search.stiffness() && search.work_left() > 0; cap *= p.factor) {
      const Stage stage = search.solve({.name = "softer", .variant = {.stiffness_cap = cap}}, u);
      u = stage.u;
      if (!stage.is_stationary()) break;
    }
    return u;
  }
};

}  // namespace

NETLOFT_PLUGIN("stiffness-steps", "0.1.0", "From soft to stiff") {
  auto& s = plugin.strategy<StiffnessSteps>("stiffness-steps",
                                            "From soft to stiff, by caps on all axial stiffnesses");
  using P = StiffnessSteps::Parameters;
  s.real("factor", &P::factor, "1",
         "ratio of the first cap to the largest nodal load, and of each cap to the previous one",
         {.lo = 1.01, .hi = 1e6, .fallback = 10});
}
