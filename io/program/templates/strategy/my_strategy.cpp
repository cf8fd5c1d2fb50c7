// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

/// Solves the scene directly or, if that fails, with increasing stiffness. Newton's method takes only short
/// steps if stiff bars must rotate; soft bars rotate in one step. Axial stiffnesses above C are lowered to C:
///   C₀ = s C_n,  C_{k+1} = f C_k  until C_k ≥ C_n                         (1)
/// C_n [N] largest stiffness of the scene; s softest, f factor. Each stage starts from the end of the
/// previous one (E. L. Allgower and K. Georg, Introduction to Numerical Continuation Methods, 2003, ch. 6).
struct MyStrategy {
  struct Parameters {
    double softest = 0, factor = 0;  // s and f of (1)
  };

  static void run(const Parameters& p, netloft::Search& search) {
    netloft::Stage stage = search.solve({.name = "at once"}, search.start());
    if (!stage.is_stationary()) stage = soft_to_stiff(p, search);
    if (stage.is_stationary()) search.answer(stage.u);
  }

  static std::string explain(const Parameters& p, netloft::Search& search) {
    return "at once; where that fails, with stiffnesses up to " +
           std::to_string(p.softest * search.stiffness()) + " N at first, then stiffer and stiffer\n";
  }

  /// Returns the stage with full stiffness, or the first stage that failed. After an interruption, no work is
  /// left.
  static netloft::Stage soft_to_stiff(const Parameters& p, netloft::Search& search) {
    netloft::Stage stage{.u = search.start()};
    for (double cap = p.softest * search.stiffness(); search.work_left() > 0; cap *= p.factor) {  // (1)
      if (cap >= search.stiffness()) return search.solve({.name = "as stiff as it is"}, stage.u);
      stage = search.solve({.name = "softer", .variant = {.stiffness_cap = cap}}, stage.u);
      if (!stage.is_stationary()) return stage;
    }
    return {};
  }
};

NETLOFT_PLUGIN("my_strategy", "0.1", "A strategy to begin with") {
  auto& s = plugin.strategy<MyStrategy>("my_strategy",
                                        "Solves the scene at once; if that fails, with growing stiffness");
  s.real("softest", &MyStrategy::Parameters::softest, "1",
         "first cap on stiffness, as a fraction of the largest stiffness",
         {.lo = 1e-9, .hi = 1, .fallback = 1e-3});
  s.real("factor", &MyStrategy::Parameters::factor, "1",
         "factor by which the cap is raised after every stage", {.lo = 1.1, .hi = 1e6, .fallback = 10});
}
