// SPDX-License-Identifier: BSD-3-Clause
//
// Strategies that are wrong in one place each. The description of a strategy is the name of the only check
// that must fail: tests/unit/framework/conformance/wrong_strategies_test.cpp reads it.
#include <netloft/strategy.hpp>

#include <chrono>
#include <cmath>
#include <thread>

using namespace netloft;

namespace {

enum class Flaw {
  none,
  keeps_quiet,
  ignores_start,
  answers_nonsense,
  answers_variant,
  forgets_the_second,
  throws_when_lost,
  swallows_errors,
  ignores_interrupt,
  ignores_budget,
  nameless,
  asks_wrongly,
  overspends,
  starts_nowhere,
  counts_calls,
  waits_for_others,
  calls_itself,
  needs_unknowns,
  throws_at_a_bound,
  solves_to_explain,
  keeps_threads
};

/// Solves the scene at once, from a coarser mesh if there is one. If this fails, the strategy solves again
/// with a cap on the stiffness, which rises to the full stiffness; if the result is unstable, it solves again
/// from a perturbed point.
template <Flaw F>
struct Wrong {
  struct Parameters {
    double softest = 0;       // cap on stiffness in the first stage, over the largest stiffness
    std::int64_t stages = 0;  // number of stages from the first cap to the full stiffness
  };
  static constexpr bool has(Flaw flaw) { return F == flaw; }

  static void run(const Parameters& p, Search& search) {
    prepare(p, search);
    try {
      seek(p, search);
    } catch (const std::exception&) {
      if (!has(Flaw::swallows_errors)) throw;
    }
  }

  static std::string explain(const Parameters&, Search& search) {
    if (has(Flaw::solves_to_explain)) solve(search, "to see", {}, search.start());
    return "at once; if that fails, with growing stiffness";
  }

  static void prepare(const Parameters& p, Search& search) {
    if (has(Flaw::needs_unknowns) && search.size() == 0) throw std::invalid_argument("nothing to solve");
    if (has(Flaw::throws_at_a_bound) && p.stages == 0) throw std::invalid_argument("no stages");
    if (has(Flaw::keeps_threads))
      std::thread([] { std::this_thread::sleep_for(std::chrono::minutes(1)); }).detach();
  }

  static void seek(const Parameters& p, Search& search) {
    Stage stage = at_once(search);
    if (!stage.is_stationary() && !is_over(search, stage) && !has(Flaw::ignores_start))
      stage = soft_to_stiff(p, search, stage);
    while (has(Flaw::waits_for_others) && !stage.is_stationary() && !is_over(search, stage))
      stage = search.call("direct", "", {.name = "by another"}, stage.u);
    if (has(Flaw::calls_itself) && !stage.is_stationary() && !is_over(search, stage))
      stage = search.call("wrong_strategies/calls_itself", "", {.name = "once more"}, search.start());
    if (stage.is_stationary()) answer(search, stage.u);
    if (!stage.is_stationary() && has(Flaw::throws_when_lost)) throw std::runtime_error("no equilibrium");
    if (!is_over(search, stage)) go_on_from(search, stage);
  }

  /// Starts from a coarser mesh if there is one. Returns the stage on the scene's own mesh, or an empty stage
  /// if the search ended before that stage.
  static Stage at_once(Search& search) {
    Displacements u = has(Flaw::ignores_start) ? Displacements(search.size(), 0.0) : search.start();
    if (search.levels() > 1) {
      const Stage coarse = solve(search, "coarse", {.level = 1}, search.transfer(0, u, 1));
      if (is_over(search, coarse)) return {};
      u = search.transfer(1, coarse.u, 0);
    }
    return solve(search, "at once", {}, std::move(u));
  }

  static Stage soft_to_stiff(const Parameters& p, Search& search, Stage stage) {
    const double ratio = std::pow(p.softest, 1.0 / double(std::max<std::int64_t>(p.stages, 1)));
    stage.u = search.start();
    for (std::int64_t i = p.stages; i >= 0 && !is_over(search, stage); --i) {
      const double cap = i == 0 ? 0 : search.stiffness() * std::pow(ratio, double(i));
      stage = solve(search, "softer", {.stiffness_cap = cap}, std::move(stage.u));
      if (has(Flaw::answers_variant) && stage.is_stationary()) search.answer(stage.u);
      if (i > 0) stage.ending = stage.is_stationary() ? Ending::not_converged : stage.ending;
    }
    return stage;
  }

  static void go_on_from(Search& search, const Stage& stage) {
    if (has(Flaw::starts_nowhere)) {
      solve(search, "from nowhere", {}, Displacements(search.size(), std::nan("")));
      return;
    }
    if (stage.growing.empty()) return;
    Displacements u = stage.u;
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += 0.01 * stage.growing[i];
    const Stage second = solve(search, "beside", {}, std::move(u));
    if (second.is_stationary() && !has(Flaw::forgets_the_second)) answer(search, second.u);
  }

  static Stage solve(Search& search, const char* name, Variant variant, Displacements u) {
    static int calls = 0;
    if (has(Flaw::asks_wrongly)) variant.compression = -1;
    Ask ask{.name = has(Flaw::nameless) ? "" : name, .variant = variant};
    if (has(Flaw::overspends)) ask.work = 1e9;
    if (has(Flaw::counts_calls) && !u.empty()) u[0] += 1e-12 * (++calls % 101);
    const Stage stage = search.solve(ask, std::move(u));
    const bool goes_on =
        has(Flaw::ignores_interrupt)
            ? stage.ending == Ending::interrupted
            : has(Flaw::ignores_budget) && stage.ending != Ending::interrupted && search.work_left() <= 0;
    return goes_on ? search.solve(ask, stage.u) : stage;
  }

  static void answer(Search& search, const Displacements& u) {
    if (has(Flaw::keeps_quiet)) return;
    search.answer(u);
    if (has(Flaw::answers_nonsense)) search.answer(Displacements(u.size(), std::nan("")));
  }

  static bool is_over(Search& search, const Stage& stage) {
    return stage.ending == Ending::interrupted || search.work_left() <= 0;
  }
};

template <Flaw F>
void add(Plugin& plugin, const char* name, const char* found_by, double softest = 1e-3) {
  using Strategy = Wrong<F>;
  auto& s = plugin.strategy<Strategy>(name, found_by);
  s.real("softest", &Strategy::Parameters::softest, "1",
         "cap on stiffness at first, over the largest stiffness", {.lo = 1e-6, .hi = 1, .fallback = softest});
  s.integer("stages", &Strategy::Parameters::stages, "from there to the scene", 0, 100, 6);
}

}  // namespace

NETLOFT_PLUGIN("wrong_strategies", "1", "Strategies that are wrong in one place each") {
  add<Flaw::none>(plugin, "right", "nothing");
  add<Flaw::none>(plugin, "bad_default", "defaults-are-allowed", 2);
  add<Flaw::keeps_quiet>(plugin, "keeps_quiet", "answers-easy-searches");
  add<Flaw::ignores_start>(plugin, "ignores_start", "answers-from-a-start");
  add<Flaw::answers_nonsense>(plugin, "answers_nonsense", "answers-with-numbers");
  add<Flaw::answers_variant>(plugin, "answers_variant", "answers-the-scene-itself");
  add<Flaw::forgets_the_second>(plugin, "forgets_the_second", "hands-back-what-it-found");
  add<Flaw::throws_when_lost>(plugin, "throws_when_lost", "no-equilibrium-is-no-error");
  add<Flaw::waits_for_others>(plugin, "waits_for_others", "comes-to-an-end");
  add<Flaw::calls_itself>(plugin, "calls_itself", "comes-to-an-end");
  add<Flaw::swallows_errors>(plugin, "swallows_errors", "stops-at-an-error");
  add<Flaw::ignores_interrupt>(plugin, "ignores_interrupt", "stops-when-interrupted");
  add<Flaw::ignores_budget>(plugin, "ignores_budget", "stops-when-work-is-used-up");
  add<Flaw::nameless>(plugin, "nameless", "names-its-stages");
  add<Flaw::asks_wrongly>(plugin, "asks_wrongly", "asks-for-what-there-is");
  add<Flaw::overspends>(plugin, "overspends", "keeps-within-its-work");
  add<Flaw::starts_nowhere>(plugin, "starts_nowhere", "starts-from-numbers");
  add<Flaw::counts_calls>(plugin, "counts_calls", "no-hidden-state");
  add<Flaw::needs_unknowns>(plugin, "needs_unknowns", "answers-nothing");
  add<Flaw::throws_at_a_bound>(plugin, "throws_at_a_bound", "survives-its-bounds");
  add<Flaw::solves_to_explain>(plugin, "solves_to_explain", "explains-without-solving");
  add<Flaw::keeps_threads>(plugin, "keeps_threads", "starts-no-threads");
}
