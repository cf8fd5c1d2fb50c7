// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

namespace {

using namespace netloft;

/// Solves the scene itself once, from its start. This shows how well a solver does alone.
struct Direct {
  struct Parameters {};

  static void run(const Parameters&, Search& search) {
    const Stage stage = search.solve({.name = "as it is"}, search.start());
    if (stage.is_stationary()) search.answer(stage.u);
  }

  static std::string explain(const Parameters&, Search&) { return "the scene itself from its start, once\n"; }
};

}  // namespace

NETLOFT_PLUGIN("direct", "0.1.0", "The solver of the analysis alone") {
  plugin.strategy<Direct>("direct", "The solver of the analysis on the scene itself, from its start, once");
}
