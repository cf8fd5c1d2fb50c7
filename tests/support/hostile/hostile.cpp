// SPDX-License-Identifier: BSD-3-Clause
//
// Components that crash, end the program, or never come back, in the middle of a run.
#include <netloft/element.hpp>
#include <netloft/solver.hpp>
#include <netloft/strategy.hpp>

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace netloft;

namespace {

/// Loops for ever. With HOSTILE_TELLS in the environment, it first prints a line, so that a test can wait for
/// it and then interrupt it.
[[noreturn]] void loop_for_ever() {
  if (std::getenv("HOSTILE_TELLS")) std::fputs("hostile loops\n", stderr);
  for (volatile std::uint64_t i = 0;; i = i + 1) {
  }
}

/// Recurses without end; its result prevents the compiler from making a loop.
int overflow(volatile int depth) {
  volatile char here[512];
  here[0] = static_cast<char>(depth);
  return overflow(depth + 1) + here[0];
}

struct OnANode {
  static constexpr auto stencil = NETLOFT_NODE;
  struct Parameters {};
  struct Data {};
};

/// A weight of 100 N with a harmful side effect.
template <void (*Harm)(netloft_tile&)>
struct Weight {
  static Status tile(const auto&, netloft_tile& t) {
    Harm(t);
    for (std::uint32_t i = 0; i < t.count; ++i) {
      if (t.energy) t.energy[i] += 100 * t.x[2 * kLanes + i];
      if (t.force) t.force[2 * kLanes + i] += 100;
    }
    return Status::ok;
  }
};

void crash(netloft_tile& t) { t.count = *static_cast<volatile std::uint32_t*>(nullptr); }
void overflow_stack(netloft_tile& t) { t.lane_at_fault = static_cast<std::uint32_t>(overflow(0)); }
void end_program(netloft_tile&) { std::exit(0); }
void never_return(netloft_tile&) { loop_for_ever(); }

struct Crashes : OnANode {};
struct Overflows : OnANode {};
struct Exits : OnANode {};
struct Loops : OnANode {};

template <class E, void (*Harm)(netloft_tile&)>
void add(Plugin& plugin, const char* name) {
  auto& e = plugin.element<E>(name, "a weight that does harm");
  e.template term<Weight<Harm>, conservative | symmetric | from_outside>("pull", "its weight");
}

/// Takes small steps against the residual, which are accepted but lead to no equilibrium.
bool creep(Problem& problem, std::vector<double>& r, int steps) {
  double energy = 0;
  for (int i = 0; i < steps; ++i) {
    if (problem.evaluate(problem.u(), energy, r) != Evaluation::ok) return false;
    if (!problem.progress(problem.u(), energy, r)) return false;
    for (std::size_t k = 0; k < r.size(); ++k) problem.u()[k] -= 1e-7 * r[k];
  }
  return true;
}

/// Takes three steps and never returns.
struct Stalls {
  struct Parameters {};
  static Outcome solve(const Parameters&, Problem& problem) {
    std::vector<double> r(problem.size());
    creep(problem, r, 3);
    loop_for_ever();
  }
};

/// Evaluates for ever without a report of its progress.
struct Asks {
  struct Parameters {};
  static Outcome solve(const Parameters&, Problem& problem) {
    std::vector<double> r(problem.size());
    creep(problem, r, 3);
    for (double energy = 0;;) problem.evaluate(problem.u(), energy, r);
  }
};

/// Requests the same stage for ever, even after its time is over.
struct Insists {
  struct Parameters {};
  static void run(const Parameters&, Search& search) {
    for (;;) search.solve({.name = "once more"}, search.start());
  }
};

}  // namespace

NETLOFT_PLUGIN("hostile", "1", "Components that do harm in the middle of a run") {
  add<Crashes, crash>(plugin, "crashes");
  add<Overflows, overflow_stack>(plugin, "overflows");
  add<Exits, end_program>(plugin, "exits");
  add<Loops, never_return>(plugin, "loops");
  plugin.solver<Stalls>("stalls", "never comes back");
  plugin.solver<Asks>("asks", "calls back for ever");
  plugin.strategy<Insists>("insists", "asks for ever");
}
