// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

namespace {

using namespace netloft;

/// Limit of iterations that is never reached, because the budget of work ends the motion.
constexpr unsigned kAsManyAsItTakes = 10000000;

/// Follows the motion M u̇ = −r(u), in which the linear stiffness M acts as viscosity, in implicit steps
/// until it comes to rest, then solves the scene itself from there. Unlike Newton's method, the motion does
/// not end at unstable equilibria. The strategy stops the motion if its path becomes many times as long as
/// the gear, because the gear then moves in circles or away and will not come to rest.
struct PseudoTime {
  struct Parameters {
    const char* solver = nullptr;
    double path = 0;
  };

  static void run(const Parameters& p, Search& search) {
    const Specification by = specification_of(p.solver);
    const Stage motion = search.solve({.name = "motion",
                                       .solver = by.name.c_str(),
                                       .parameters = by.parameters.c_str(),
                                       .path = p.path,
                                       .iterations = kAsManyAsItTakes},
                                      search.start());
    if (motion.ending == Ending::unsettled || search.work_left() == 0) return;
    const Stage stage = search.solve({.name = "from where it comes to rest"}, motion.u);
    if (stage.is_stationary()) search.answer(stage.u);
  }

  static std::string explain(const Parameters& p, Search&) {
    return std::string("a motion that the linear stiffness damps, followed by ") + p.solver +
           " until it comes to rest\n";
  }
};

}  // namespace

NETLOFT_PLUGIN("pseudo-time", "0.1.0", "Follows a motion until it comes to rest") {
  auto& s = plugin.strategy<PseudoTime>(
      "pseudo-time", "Follows a motion, damped by the linear stiffness, until it comes to rest");
  using P = PseudoTime::Parameters;
  s.solver("solver", &P::solver, "solver that follows the motion", "ptc");
  s.real(
      "path", &P::path, "1",
      "a gear that has moved by more than this multiple of its size counts as not coming to rest: in hard "
      "cases, gears that came to rest had moved by up to 6.3 times their size, most others by 20 to 80 times",
      {.lo = 0, .hi = 1e6, .fallback = 10});
}
