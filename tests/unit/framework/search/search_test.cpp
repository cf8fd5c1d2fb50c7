// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/search.hpp"

#include <gtest/gtest.h>
#include <netloft/strategy.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "framework/balance/work.hpp"
#include "framework/registry/hand_out.hpp"
#include "framework/search/running_search.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// A strategy implemented by a function of the test.
struct ByHand {
  struct Parameters {};
  static inline std::function<void(Search&)> now;
  static void run(const Parameters&, Search& search) { now(search); }
};

const StrategyType& by_hand() {
  static const StrategyType type = [] {
    StrategyType t;
    t.type = "test/by-hand", t.strategy = StrategyTable<ByHand>("by-hand", "a test").descriptor();
    return t;
  }();
  return type;
}

/// Two bars of 1 m, as stiff in compression as in tension, straight between ends that are 1.8 m apart.
Scene compressed_bars() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.9, 0, 0), c = s.node(1.8, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  return s.scene;
}

Scene taut_bars() {
  Scene scene = compressed_bars();
  scene.positions[6] = 2.2;
  return scene;
}

Solution search(const Scene& scene, std::function<void(Search&)> strategy, double work = 1000,
                Limits limits = {}, std::map<std::string, Values> given = {}) {
  Registry& registry = shipped_plugins();
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  SearchOptions options;
  options.solver.type = &registry.solver("newton"), options.limits = limits, options.work = work;
  options.given = std::move(given);
  ByHand::now = std::move(strategy);
  return find_equilibrium({&scene, &assembler, &registry, nullptr, make_factorisation}, options,
                          {&by_hand(), {}});
}

TEST(ASearch, ChoosesWhatTheStrategyAnswered) {
  const Solution s = search(taut_bars(), [](Search& of) {
    const Stage stage = of.solve({.name = "first"}, of.start());
    EXPECT_TRUE(stage.has_converged());
    of.answer(stage.u);
  });
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  ASSERT_EQ(s.cost.stages.size(), 1u) << "an answer that a stage has judged is not judged again";
  EXPECT_EQ(s.cost.stages[0].name, "first");
}

TEST(ASearch, JudgesAnAnswerItself) {
  const Solution s = search(taut_bars(), [](Search& of) {
    Displacements wrong = of.start();
    wrong[0] = 0.3;
    of.answer(wrong);
  });
  EXPECT_EQ(s.status, SolveStatus::not_converged) << s.reason;
}

TEST(ASearch, IsNotConvergedWithoutAnAnswer) {
  const Solution s = search(taut_bars(), [](Search&) {});
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("no stage"), std::string::npos) << s.reason;
  EXPECT_EQ(s.u, std::vector<double>(3, 0.0)) << "a place for every node, where it was sketched";
}

TEST(ASearch, SaysThatItsStrategyFailed) {
  const Solution s = search(compressed_bars(), [](Search& of) {
    of.solve({.name = "straight", .work = 1e-6}, of.start());
    throw std::runtime_error("the tide turned");
  });
  EXPECT_NE(s.reason.find("test/by-hand failed: the tide turned"), std::string::npos) << s.reason;
}

TEST(ASearch, HasNoAnswerOfAStrategyThatFailedAfterIt) {
  const Solution s = search(taut_bars(), [](Search& of) {
    of.answer(of.solve({.name = "found"}, of.start()).u);
    throw std::runtime_error("the tide turned");
  });
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_TRUE(s.reason.starts_with("the strategy test/by-hand failed: the tide turned; largest residual"))
      << s.reason;
  EXPECT_TRUE(s.balance.balanced) << "the state that it left is kept";
}

TEST(ASearch, SaysOnceThatItsWorkIsUsedUp) {
  const auto count = [](const std::string& text, const std::string& what) {
    int times = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++times;
    return times;
  };
  const auto nested = [](Search& of) {
    of.call("relaxed", "", {.name = "by another"}, perturbed(of.start(), 0.3));
    of.call("direct", "", {.name = "by another"}, perturbed(of.start(), 0.3));
  };
  const Solution s = search(compressed_bars(), nested, 0.5);
  EXPECT_EQ(count(s.reason, "budget of work"), 1) << s.reason;
  const Solution gave_up = search(compressed_bars(), [](Search& of) {
    of.solve({.name = "short", .work = 1e-3}, perturbed(of.start(), 0.3));
  });
  EXPECT_TRUE(gave_up.reason.ends_with("; the strategy ended with work left")) << gave_up.reason;
}

TEST(ASearch, SaysWhyItsStrategySolvedNothing) {
  const Solution s = search(taut_bars(), [](Search& of) { of.decline("there is no tide"); });
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_EQ(s.reason, "the strategy solved no stage of the scene itself: there is no tide");
}

TEST(ASearch, RefusesStrategiesThatCallThemselvesWithoutEnd) {
  std::string why;
  try {
    search(taut_bars(),
           [](Search& of) {
             of.call("deflation", "", {.name = "by itself"}, of.start());
             ADD_FAILURE() << "it has come back";
           },
           1000, {}, {{"deflation/deflation", {{"by", std::string("deflation")}}}});
  } catch (const std::runtime_error& e) {
    why = e.what();
  }
  EXPECT_TRUE(
      why.starts_with("the strategy deflation/deflation failed: 64 strategies have called one another"))
      << why;
  EXPECT_TRUE(why.ends_with("does one of them call itself?")) << why;
}

/// A strategy whose `explain` is a function of the test. If it is `bare`, it does not use strategy.hpp.
struct Explained : ByHand {
  static inline std::function<std::string()> plan;
  static std::string explain(const Parameters&, Search&) { return plan(); }
};

std::string explain(int (*bare)(const void*, netloft_search*, char*, std::uint32_t) = nullptr) {
  const Scene scene = taut_bars();
  Registry& registry = shipped_plugins();
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  SearchOptions options;
  options.solver.type = &registry.solver("newton");
  StrategyType type;
  type.type = "test/explained", type.strategy = StrategyTable<Explained>("explained", "a test").descriptor();
  if (bare) type.strategy.explain = bare;
  try {
    return explain_strategy({&scene, &assembler, &registry, nullptr, make_factorisation}, options,
                            {&type, {}});
  } catch (const std::runtime_error& e) {
    return e.what();
  }
}

TEST(ASearch, SaysThatItsStrategyCannotExplainIt) {
  Explained::plan = [] { return std::string("all of it\n"); };
  EXPECT_EQ(explain(), "all of it\n");
  Explained::plan = []() -> std::string { throw std::runtime_error("no idea"); };
  EXPECT_EQ(explain(), "the strategy test/explained failed to explain what it does: no idea");
  EXPECT_EQ(explain([](const void*, netloft_search*, char* text, std::uint32_t size) -> int {
              std::memset(text, 'x', size);
              return NETLOFT_OK;
            }),
            "the strategy test/explained explains what it does with more than 4096 characters");
}

TEST(ASearch, PrefersAStableAnswerToAnUnstableOne) {
  const Solution s = search(compressed_bars(), [](Search& of) {
    const Stage straight = of.solve({.name = "straight"}, of.start());
    EXPECT_EQ(straight.ending, Ending::unstable);
    of.answer(straight.u);
    of.answer(of.solve({.name = "buckled"}, perturbed(straight.u, 0.1)).u);
  });
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_TRUE(s.shapes.others.empty()) << "what is unstable is no other shape";
}

TEST(ASearch, SpendsNoMoreWorkThanItWasGiven) {
  double spent = 0;
  const Solution s = search(
      taut_bars(),
      [&](Search& of) {
        for (int i = 0; i < 1000 && of.work_left() > 0; ++i)
          spent += of.solve({.name = "again"}, perturbed(of.start(), 0.3, i)).spent;
        EXPECT_EQ(of.work_left(), 0);
        EXPECT_EQ(of.solve({.name = "no more"}, of.start()).ending, Ending::out_of_work);
      },
      20);
  EXPECT_GE(spent, 20);
  EXPECT_NE(s.reason.find("budget of work"), std::string::npos) << s.reason;
}

TEST(ASearch, EndsAStageByItsOwnBudget) {
  search(compressed_bars(), [](Search& of) {
    const Stage stage = of.solve({.name = "short", .work = 1e-3}, perturbed(of.start(), 0.2));
    EXPECT_EQ(stage.ending, Ending::out_of_work);
    EXPECT_GT(stage.load + stage.residual, 0);
  });
}

// Callers repeat a strategy that used up its work, but not one that found nothing, so that their endings must
// differ.
TEST(ASearch, TellsAStrategyThatFoundNothingFromOneThatWasCutOff) {
  search(compressed_bars(), [](Search& of) {
    const Stage nothing = of.call("coarse-to-fine", "", {.name = "there is no coarser mesh"}, of.start());
    EXPECT_EQ(nothing.ending, Ending::not_converged);
  });
}

/// The ending that `strategy`, which a test defines, reports to the strategy that calls it.
std::uint32_t ending_of_call(const Scene& scene, std::function<void(Search&)> strategy) {
  Registry& registry = shipped_plugins();
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  SearchOptions options;
  options.solver.type = &registry.solver("newton"), options.work = 1000;
  ByHand::now = std::move(strategy);
  SearchHost host({&scene, &assembler, &registry, nullptr, make_factorisation}, options);
  RunningSearch running(host, as_written(), options.limits.tolerance, options.work, nullptr);
  running.run(by_hand(), nullptr);
  EXPECT_GT(running.work_left(), 0);
  return running.ending();
}

// A search whose last stage ran out of work must report that, so that it gets more work, even if an earlier
// point was closer to balance.
TEST(ASearch, EndsAsItsLastStageDidAndNotAsTheOneThatWasClosest) {
  const auto cut_off = [](Search& of) {
    Displacements near = of.start();
    near[0] += 0.199;  // close to the equilibrium, at 0.2
    const Stage closest = of.assess({.name = "near"}, near);
    const Stage stage = of.solve({.name = "short", .work = 1e-3}, of.start());
    EXPECT_FALSE(closest.is_stationary());
    EXPECT_LT(closest.imbalance(), stage.imbalance());
  };
  const auto ended = [&](Search& of) {
    cut_off(of);
    of.call("coarse-to-fine", "", {.name = "there is no coarser mesh"}, of.start());
  };
  EXPECT_EQ(ending_of_call(taut_bars(), cut_off), NETLOFT_ENDED_OUT_OF_WORK);
  EXPECT_EQ(ending_of_call(taut_bars(), ended), NETLOFT_ENDED_NOT_CONVERGED);
  EXPECT_EQ(ending_of_call(taut_bars(), [](Search& of) { of.answer(of.solve({}, of.start()).u); }),
            NETLOFT_ENDED_CONVERGED);
  EXPECT_EQ(ending_of_call(taut_bars(), [](Search&) {}), NETLOFT_ENDED_NOT_CONVERGED);
}

TEST(ASearch, FillsNoMoreOfAProblemThanThereIsRoomFor) {
  struct Room {
    netloft_problem problem;
    unsigned char behind[sizeof(netloft_problem)];
  };
  constexpr std::size_t kLeast = offsetof(netloft_problem, evaluate_both);
  const auto filled = [](std::uint32_t said) {
    Room room;
    std::memset(&room, 0x5a, sizeof room);
    room.problem.size = said;
    hand_out(netloft_problem{.size = sizeof(netloft_problem), .unknowns = 7}, room.problem, kLeast);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&room);
    EXPECT_EQ(room.problem.unknowns, 7u);
    const std::size_t size = room.problem.size;
    EXPECT_TRUE(std::all_of(bytes + size, bytes + sizeof room, [](unsigned char b) { return b == 0x5a; }));
    return size;
  };
  EXPECT_EQ(filled(0), kLeast) << "a plugin that says nothing";
  EXPECT_EQ(filled(3), kLeast) << "or leaves there what was in its memory";
  EXPECT_EQ(filled(sizeof(netloft_problem)), sizeof(netloft_problem));
  EXPECT_EQ(filled(sizeof(Room)), sizeof(netloft_problem)) << "a newer interface";
}

TEST(ASearch, SolvesNothingTwice) {
  const Solution s = search(compressed_bars(), [](Search& of) {
    const auto ask = [&](double cap) {
      return of.solve({.name = "soft", .variant = {.stiffness_cap = cap}}, perturbed(of.start(), 0.1));
    };
    const Stage first = ask(100), again = ask(100), other = ask(50);
    ASSERT_TRUE(first.has_converged());
    EXPECT_EQ(again.u, first.u);
    EXPECT_TRUE(again.has_converged());
    EXPECT_GT(first.factorisations, 0u);
    EXPECT_EQ(again.factorisations, 0u);
    EXPECT_GT(again.spent, 0) << "a strategy that asks for the same without end must come to its end";
    EXPECT_LT(again.spent, 0.5 * first.spent);
    EXPECT_GT(other.factorisations, 0u);
  });
  EXPECT_EQ(s.cost.stages.size(), 2u) << "what is known is no stage";
}

TEST(ASearch, GoesOnWhereAStageWasCutOff) {
  search(compressed_bars(), [](Search& of) {
    const Displacements start = perturbed(of.start(), 0.2);
    const auto ask = [&](const Displacements& from, double path) {
      return of.solve({.name = "short", .path = path, .iterations = 2}, from);
    };
    const Stage first = ask(start, 0), second = ask(start, 0);
    ASSERT_EQ(first.ending, Ending::out_of_work);
    EXPECT_NE(second.u, first.u);
    EXPECT_EQ(second.u, ask(first.u, 1e6).u) << "with another limit, so that it is another stage";
  });
}

TEST(ASearch, KnowsWhatAStrategyCameToThatHasEnded) {
  const Solution s = search(compressed_bars(), [](Search& of) {
    const auto ask = [&](double work) {
      return of.call("direct", "", {.name = "lent", .variant = {.stiffness_cap = 100}, .work = work},
                     perturbed(of.start(), 0.1));
    };
    EXPECT_EQ(ask(1).ending, Ending::out_of_work);
    const Stage first = ask(1000), again = ask(1000);
    EXPECT_TRUE(first.has_converged());
    EXPECT_EQ(again.u, first.u);
    EXPECT_LT(again.spent, 1);
  });
  EXPECT_EQ(s.cost.stages.size(), 2u) << "one that was cut off, and the rest of it";
}

TEST(ASearch, SolvesAnEasierVariantWithoutTakingItForTheScene) {
  const Solution s = search(compressed_bars(), [](Search& of) {
    const Stage soft = of.solve({.name = "soft", .variant = {.compression = 0}}, perturbed(of.start(), 0.1));
    EXPECT_EQ(soft.ending, Ending::converged);
  });
  EXPECT_EQ(s.status, SolveStatus::not_converged) << "a variant is no answer";
  ASSERT_EQ(s.cost.stages.size(), 1u);
  EXPECT_EQ(s.cost.stages[0].variant.compression, 0);
}

/// Iterations of a stage with a named solver, which is set to make one step per iteration.
int iterations_of_named_solver(std::map<std::string, Values> given) {
  const Solution s = search(
      taut_bars(),
      [](Search& of) {
        of.solve({.name = "by steps", .solver = "relaxation", .parameters = "steps=1"},
                 perturbed(of.start(), 0.3));
      },
      1000, {}, std::move(given));
  return s.cost.statistics.iterations;
}

TEST(ASearch, LetsTheUsersOwnParametersHoldOverThoseOfTheStrategy) {
  const int each_step = iterations_of_named_solver({});
  EXPECT_GT(each_step, 5);
  EXPECT_LT(iterations_of_named_solver({{"relaxation/relaxation", {{"steps", std::int64_t{1000}}}}}),
            each_step);
  EXPECT_EQ(iterations_of_named_solver({{"ptc/ptc", {{"solved", 0.1}}}}), each_step)
      << "that of another solver";
}

/// Iterations of the first stage of the strategy `pseudo-time`, whose path the parameters of the call
/// restrict to hardly any length.
int iterations_of_called_strategy(std::map<std::string, Values> given) {
  const Solution s = search(
      taut_bars(),
      [](Search& of) {
        of.call("pseudo-time", "path=1e-9", {.name = "pseudo-time", .work = 100}, perturbed(of.start(), 0.3));
      },
      1000, {}, std::move(given));
  return s.cost.stages.at(0).statistics.iterations;
}

TEST(ASearch, GivesTheUsersOwnParametersToAStrategyThatIsCalled) {
  EXPECT_EQ(iterations_of_called_strategy({}), 1);
  EXPECT_GT(iterations_of_called_strategy({{"pseudo-time/pseudo-time", {{"path", 10.0}}}}), 1);
}

TEST(ASearch, LendsItsSceneToAnotherStrategy) {
  const Solution s = search(taut_bars(), [](Search& of) {
    const Stage stage = of.call("direct", "", {.name = "by direct", .work = 100}, of.start());
    EXPECT_TRUE(stage.has_converged());
    EXPECT_GT(stage.spent, 0);
    of.answer(stage.u);
  });
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
}

/// A chain of 40 bars, and two bars for its coarser mesh.
class TwoMeshes final : public Levels {
 public:
  unsigned most() const override { return 2; }
  const Scene* scene(unsigned level) override { return level == 0 ? &fine : level == 1 ? &coarse : nullptr; }
  std::vector<double> carry(unsigned, std::span<const double>, unsigned) override { return {}; }

  Scene fine = chain(40), coarse = taut_bars();

 private:
  static Scene chain(int bars) {
    Sketch s;
    std::vector<std::uint32_t> nodes{s.node(0, 0, 0, kAllAxes)};
    for (int i = 1; i < bars; ++i) nodes.push_back(s.node(i, 0, 0));
    nodes.push_back(s.node(1.1 * bars, 0, 0, kAllAxes));
    s.rope("bars", nodes, 1, 1e4);
    return s.scene;
  }
};

TEST(ASearch, TellsWorkInIterationsOfTheMeshThatTheStrategyIsCalledFor) {
  TwoMeshes meshes;
  Registry& registry = shipped_plugins();
  const ScenePlan plan = make_scene_plan(meshes.fine, registry);
  Assembler assembler(meshes.fine, plan, 1);
  SearchOptions options;
  options.solver.type = &registry.solver("newton");
  SearchHost host({&meshes.fine, &assembler, &registry, &meshes, make_factorisation}, options);
  netloft_variant coarser = as_written();
  coarser.level = 1;
  const WorkModel model = host.variant_problems().at(coarser)->model;
  EXPECT_LT(model.of_iteration(), 0.5 * model.unit);

  EXPECT_EQ(RunningSearch(host, as_written(), 1e-9, 10, nullptr).work_left(), 10);
  RunningSearch running(host, coarser, 1e-9, 10, nullptr);
  const double budget = running.work_left();
  EXPECT_DOUBLE_EQ(budget, 10 * model.unit / model.of_iteration());
  const double before = host.spent();
  Search search(running.interface());
  const Stage stage =
      search.solve({.name = "one iteration", .iterations = 1}, perturbed(search.start(), 0.3));
  EXPECT_EQ(stage.iterations, 1u);
  EXPECT_GE(stage.spent, 1) << "a factorisation, a solution, a matrix and residuals";
  EXPECT_NEAR(stage.spent, (host.spent() - before) * model.unit / model.of_iteration(), 1e-9);
  EXPECT_NEAR(running.work_left(), budget - stage.spent, 1e-9);
}

TEST(ASearch, RefusesWhatDoesNotExistWithASentence) {
  for (const Ask& ask : {Ask{.variant = {.level = 1}}, Ask{.variant = {.current = 2}},
                         Ask{.solver = "none-such"}, Ask{.parameters = "dumping=1"}})
    try {
      search(taut_bars(), [&](Search& of) { of.solve(ask, of.start()); });
      FAIL() << "nothing was refused";
    } catch (const std::runtime_error& e) {
      EXPECT_NE(std::string(e.what()).find("test/by-hand failed: "), std::string::npos) << e.what();
    }
}

TEST(ASearch, TellsAStrategyThatTheUserInterrupts) {
  const std::atomic<bool> interrupt{true};
  Limits limits;
  limits.interrupt = &interrupt;
  const Solution s = search(
      compressed_bars(),
      [](Search& of) {
        EXPECT_EQ(of.work_left(), 0);
        EXPECT_EQ(of.solve({.name = "too late"}, perturbed(of.start(), 0.2)).ending, Ending::interrupted);
      },
      1000, limits);
  EXPECT_EQ(s.status, SolveStatus::interrupted) << s.reason;
}

// The limit is reached before a solver makes a step; the search reports it once.
TEST(ASearch, SaysThatItsTimeIsOver) {
  Limits limits;
  limits.seconds = 0;
  const Solution s = search(
      compressed_bars(), [](Search& of) { of.solve({.name = "too late"}, perturbed(of.start(), 0.2)); }, 1000,
      limits);
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  const std::size_t first = s.reason.find("the time limit was reached");
  ASSERT_NE(first, std::string::npos) << s.reason;
  EXPECT_EQ(s.reason.find("the time limit was reached", first + 1), std::string::npos) << s.reason;
}

TEST(ASearch, HandsAMethodOfTheStrategysOwnTheProblem) {
  const Solution s = search(taut_bars(), [](Search& of) {
    const Displacements u = of.with_problem({.name = "own Newton"}, of.start(), [](Problem& p) {
      std::vector<double> r(p.size()), du(p.size());
      double energy = 0;
      while (p.evaluate(p.u(), energy, r, Matrix::exact) == Evaluation::ok && p.progress(p.u(), energy, r)) {
        ASSERT_EQ(p.factorise(Matrix::exact, 0), Factor::ok);
        p.solve(r, du);
        for (std::size_t i = 0; i < du.size(); ++i) p.u()[i] -= du[i];
      }
    });
    of.answer(u);
  });
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_GT(s.cost.statistics.factorisations, 0) << "its work is counted";
}

TEST(ASearch, HasTheSumOfAllStages) {
  const Solution s = search(taut_bars(), [](Search& of) {
    for (int i = 0; i < 3; ++i) of.answer(of.solve({.name = "again"}, perturbed(of.start(), 0.1, i)).u);
  });
  int iterations = 0;
  double work = 0;
  for (const StageRecord& stage : s.cost.stages)
    iterations += stage.statistics.iterations, work += stage.work;
  EXPECT_EQ(s.cost.statistics.iterations, iterations);
  EXPECT_DOUBLE_EQ(s.cost.work, work);
  EXPECT_EQ(s.shapes.times, 3) << "the same shape, three times";
}

}  // namespace
}  // namespace netloft::test
