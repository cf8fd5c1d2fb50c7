// SPDX-License-Identifier: BSD-3-Clause
// Checks of a strategy: it finds every equilibrium that one solve finds, answers with equilibria only,
// requests only what exists, and ends when the budget is used up or the user interrupts.
#include "framework/conformance/checklist.hpp"
#include "framework/conformance/strategy_bench.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace netloft {

namespace conformance {
namespace {

/// Traits that a scene may have without any effect on the search.
constexpr std::uint32_t kMayBeClaimed =
    NETLOFT_SEARCH_REMEMBERS | NETLOFT_SEARCH_FLOWS | NETLOFT_SEARCH_COMPRESSION;

const char* const kNoScene = "it needs traits that none of the searches in this test has";

/// Runs the strategy on every scene that it accepts; `fault_of(search, status)` returns a fault or an empty
/// string.
Finding over(StrategyBench& b, const std::vector<NamedScene>& scenes,
             const std::function<std::string(const PracticeSearch&, int)>& fault_of) {
  bool any = false;
  for (auto [name, scene] : scenes) {
    scene.claims = b.type.strategy.needs & kMayBeClaimed;
    scene.by = b.type.type;
    PracticeSearch search(scene);
    if (!b.takes(search)) continue;
    any = true;
    const int status = b.run(search);
    if (const std::string fault = fault_of(search, status); !fault.empty())
      return failed(fault + ", on " + name);
  }
  return any ? Finding{} : not_applicable(kNoScene);
}

Finding never(StrategyBench& b, Slip slip) {
  return over(b, all_scenes(), [slip](const PracticeSearch& search, int) { return search.slip(slip); });
}

Finding strategy_lets_no_exception_escape(StrategyBench& b) {
  auto all = all_scenes();
  for (const auto& [name, scene] : scenes()) {
    all.push_back({name, scene});
    all.back().scene.breaks = true;
  }
  return over(b, all, [&b](const PracticeSearch&, int) { return b.thrown; });
}

// ---------------------------------------------------------------- answers

constexpr double kBalancedSearch = 1e-7;  // ten times the tolerance of the search

/// Checks that the best answer is in balance. Skipped if the strategy requests no stage, because it may not
/// apply to small scenes or to scenes without a current.
Finding is_answered(StrategyBench& b, PracticeScene scene) {
  scene.claims = b.type.strategy.needs & kMayBeClaimed;
  PracticeSearch search(scene);
  if (!b.takes(search)) return not_applicable(kNoScene);
  const int status = b.run(search);
  if (status == NETLOFT_OK && search.stages == 0 && search.answers().empty())
    return not_applicable("it requests no stage in such a scene");
  Finding f;
  f.figure = search.imbalance();
  f.limit = kBalancedSearch;
  f.passed = f.figure <= f.limit;
  f.detail = "imbalance of the best of " + std::to_string(search.answers().size()) + " answers after " +
             std::to_string(search.stages) + " stages; `run` returned " + std::to_string(status);
  return f;
}

/// Checks that the strategy finds the equilibria of easy scenes. The strategy must apply to at least one of
/// these scenes.
Finding answers_easy_searches(StrategyBench& b) {
  Finding worst = not_applicable(kNoScene);
  bool takes_any = false;
  for (const auto& [name, scene] : easy_scenes()) {
    Finding f = is_answered(b, scene);
    takes_any = takes_any || f.detail != kNoScene;
    f.detail += std::string(", on ") + name;
    if (!f.passed) return f;
    if (!f.skipped && f.figure >= worst.figure) worst = std::move(f);
  }
  return worst.skipped && takes_any ? failed("it requests no stage and gives no answer in all easy scenes")
                                    : worst;
}

/// Returns a point near the equilibrium of a chain with a grip. The equilibrium is found in stages whose
/// stiffness increases tenfold; then all displacements are multiplied by 1.0001.
std::vector<double> near_the_answer(const PracticeScene& scene) {
  PracticeSearch search(scene);
  std::vector<double> u(scene.like.unknowns, 0.0);
  netloft_stage stage{};
  stage.size = sizeof stage;
  stage.variant = {sizeof(netloft_variant), 0, 0, 1, 1};
  stage.u = u.data();
  for (const double cap : {10.0, 100.0, 1000.0, 0.0}) {
    stage.variant.stiffness_cap = cap;
    search.interface().solve(&search, &stage);
  }
  for (double& displacement : u) displacement *= 1 + 1e-4;
  return u;
}

/// Checks that the strategy begins at the given start. Full Newton steps converge from there, but not from
/// the initial shape.
Finding answers_from_a_start(StrategyBench& b) {
  PracticeScene scene = kGripped;
  scene.start = near_the_answer(kGripped);
  return is_answered(b, scene);
}

Finding answers_with_numbers(StrategyBench& b) { return never(b, Slip::answer_no_number); }
Finding answers_the_scene_itself(StrategyBench& b) { return never(b, Slip::answer_of_variant); }

Finding hands_back_what_it_found(StrategyBench& b) {
  return over(b, scenes(), [](const PracticeSearch& search, int) -> std::string {
    return search.has_kept_an_equilibrium()
               ? "found an equilibrium that is better than all its answers, but did not answer with it"
               : "";
  });
}

Finding answers_nothing(StrategyBench& b) {
  const NamedScene nothing{"a scene without unknowns", {.like = {.unknowns = 0}}};
  return over(b, {nothing}, [](const PracticeSearch&, int status) -> std::string {
    return status == NETLOFT_OK ? "" : "returned " + std::to_string(status);
  });
}

// ---------------------------------------------------------------- failures

Finding no_equilibrium_is_no_error(StrategyBench& b) {
  return over(b, {{"a chain without an equilibrium", kRunaway}},
              [](const PracticeSearch&, int status) -> std::string {
                return status == NETLOFT_OK ? "" : "returned " + std::to_string(status);
              });
}

/// Checks that the strategy ends, even if all strategies that it calls return at once without any work, and
/// that it does not call itself in the same way as it was called.
Finding comes_to_an_end(StrategyBench& b) {
  NamedScene idle{"a chain without an equilibrium, in which every strategy that it calls returns at once",
                  kRunaway};
  idle.scene.others_decline = true;
  auto all = all_scenes();
  all.push_back(idle);
  return over(b, all, [](const PracticeSearch& search, int) -> std::string {
    if (search.stages >= PracticeSearch::kMostStages)
      return "requests stage after stage without using any work";
    return search.slip(Slip::calls_itself);
  });
}

Finding stops_at_an_error(StrategyBench& b) {
  auto broken = easy_scenes();
  for (NamedScene& one : broken) one.scene.breaks = true;
  return over(b, broken, [](const PracticeSearch& search, int status) -> std::string {
    return search.stages == 0 || status == NETLOFT_ERROR
               ? ""
               : "returned " + std::to_string(status) + " after an error of the host";
  });
}

Finding stops_when_interrupted(StrategyBench& b) { return never(b, Slip::after_interrupt); }
Finding stops_when_work_is_used_up(StrategyBench& b) { return never(b, Slip::after_budget); }

// ---------------------------------------------------------------- requests

Finding names_its_stages(StrategyBench& b) { return never(b, Slip::stage_without_name); }
Finding fills_its_stages(StrategyBench& b) { return never(b, Slip::stage_not_filled); }
Finding asks_for_what_there_is(StrategyBench& b) { return never(b, Slip::out_of_range); }
Finding keeps_within_its_work(StrategyBench& b) { return never(b, Slip::over_budget); }
Finding starts_from_numbers(StrategyBench& b) { return never(b, Slip::start_no_number); }

Finding leaves_the_search_alone(StrategyBench& b) {
  auto all = all_scenes();
  all.push_back({"a chain with a start", kLinear});
  all.back().scene.start.assign(kLinear.like.unknowns, 0.1);
  return over(b, all, [](const PracticeSearch& search, int) -> std::string {
    return search.is_left_alone()
               ? ""
               : "it has overwritten the start, the struct of the search or memory behind the message";
  });
}

Finding strategy_has_no_hidden_state(StrategyBench& b) {
  return over(b, all_scenes(), [&b](const PracticeSearch& first, int) -> std::string {
    PracticeSearch other(kTwoMeshes), again(first.scene());
    if (b.takes(other)) b.run(other);
    b.run(again);
    return first.trace() == again.trace() ? "" : "two runs of the same search differ in stages or answers";
  });
}

// ---------------------------------------------------------------- parameters

using Setting = std::pair<std::string, Value>;

/// Lists settings of parameters: both ends of every bounded range, every word of a choice, both truth values.
std::vector<Setting> bounds_of(const std::vector<netloft_parameter>& table) {
  std::vector<Setting> all;
  for (const auto& p : table)
    for (const double end : {p.lo, p.hi}) {
      if (p.kind == NETLOFT_REAL && std::isfinite(end)) all.emplace_back(p.name, end);
      if (p.kind == NETLOFT_INTEGER && std::isfinite(end))
        all.emplace_back(p.name, static_cast<std::int64_t>(end));
      if (p.kind == NETLOFT_BOOLEAN) all.emplace_back(p.name, end == p.hi);
    }
  for (const auto& p : table)
    for (auto word = p.choices; p.kind == NETLOFT_CHOICE && word && *word; ++word)
      all.emplace_back(p.name, std::string(*word));
  return all;
}

std::string fault_at(StrategyBench& b, const Setting& setting) {
  Values values = required_of(b.type.parameters, ParameterSampler(b.type.parameters, b.seed).parameters(0));
  values[setting.first] = setting.second;
  std::vector<std::string> faults;
  const ParameterBlock block(b.type.parameters, b.type.strategy.parameter_bytes, values, faults);
  for (PracticeScene scene : {kLinear, kGripped, kTwoMeshes, kBuckling}) {
    scene.claims = b.type.strategy.needs & kMayBeClaimed;
    scene.budget = 200;
    PracticeSearch search(scene);
    if (!faults.empty() || !b.takes(search)) continue;
    if (b.run(search, block.data()) != NETLOFT_OK) return "`run` ends in an error";
    if (!search.any_slip().empty()) return search.any_slip();
  }
  return "";
}

Finding survives_its_bounds(StrategyBench& b) {
  const auto bounds = bounds_of(b.type.parameters);
  for (const auto& setting : bounds)
    if (const std::string fault = fault_at(b, setting); !fault.empty())
      return failed(fault + ", with " + setting.first + " at an end of its range");
  return bounds.empty() ? not_applicable("none of its parameters has a bounded range") : Finding{};
}

// ---------------------------------------------------------------- explain

constexpr std::size_t kExplainGuard = 64;

/// Calls `explain` with `room` bytes for its text, and returns a fault or an empty text. If `asks`, it is a
/// fault to request a stage or to give an answer; otherwise, to fail, to write beyond the room, or to leave
/// the text without an end.
std::string fault_of_explaining(StrategyBench& b, const PracticeScene& like, std::uint32_t room, bool asks) {
  PracticeScene scene = like;
  scene.claims = b.type.strategy.needs & kMayBeClaimed;
  PracticeSearch search(scene);
  if (!b.takes(search)) return "";
  std::vector<char> text(room + kExplainGuard, kUntouched);
  const int status = b.explain(search, text.data(), room);
  if (asks) return search.stages == 0 && search.answers().empty() ? "" : "requests a stage, or answers";
  if (status != NETLOFT_OK) return "returned " + std::to_string(status);
  const bool is_guard_whole =
      std::all_of(text.begin() + room, text.end(), [](char c) { return c == kUntouched; });
  const bool ends = room == 0 || std::find(text.begin(), text.begin() + room, '\0') != text.begin() + room;
  return is_guard_whole && ends
             ? ""
             : "writes more than " + std::to_string(room) + " bytes, or does not end the text with a zero";
}

Finding explains(StrategyBench& b, bool asks) {
  if (!b.type.strategy.explain) return not_applicable("it has no explain");
  for (const auto& [name, scene] : scenes())
    for (const std::uint32_t room : {8192u, 16u, 1u})
      if (const std::string fault = fault_of_explaining(b, scene, room, asks); !fault.empty())
        return failed(fault + ", on " + name);
  return {};
}

Finding explains_within_its_room(StrategyBench& b) { return explains(b, false); }
Finding explains_without_solving(StrategyBench& b) { return explains(b, true); }

// The order matters: a check comes after the checks on which it depends.
const std::vector<Check<StrategyBench>>& strategy_table() {
  static const std::vector<Check<StrategyBench>> checks = {
      {"defaults-are-allowed",
       method_defaults_are_allowed,
       {},
       "a default must lie in the range that its own parameter allows"},
      {"no-exception-escapes",
       strategy_lets_no_exception_escape,
       {"defaults-are-allowed"},
       "catch every exception before it leaves the plugin, as the code of strategy.hpp does; leave rounding "
       "and traps as they were"},
      {"fills-its-stages",
       fills_its_stages,
       {"no-exception-escapes"},
       "set `size` of a stage and of its variant; its displacements are on the level of the variant"},
      {"answers-easy-searches",
       answers_easy_searches,
       {"no-exception-escapes"},
       "solve an easy scene in one stage of the scene itself; pass its final point to `answer`"},
      {"answers-from-a-start",
       answers_from_a_start,
       {"answers-easy-searches"},
       "start at `search.start()`: the user may have given displacements near the solution"},
      {"answers-with-numbers",
       answers_with_numbers,
       {"no-exception-escapes"},
       "a stage that has not converged may end at NaN or infinity: check its point before `answer`"},
      {"answers-the-scene-itself",
       answers_the_scene_itself,
       {"answers-easy-searches"},
       "start a stage of the scene itself from the equilibrium of a variant; answer with its result"},
      {"hands-back-what-it-found",
       hands_back_what_it_found,
       {"answers-easy-searches"},
       "pass every equilibrium of the scene to `answer` as soon as it is found, also before you return "
       "early"},
      {"no-equilibrium-is-no-error",
       no_equilibrium_is_no_error,
       {"no-exception-escapes"},
       "return as usual if nothing converged; an error is for what the host or the user must repair"},
      {"comes-to-an-end",
       comes_to_an_end,
       {"no-exception-escapes"},
       "does a loop wait until the work is used up? A refused stage uses no work. Does the strategy call "
       "itself?"},
      {"stops-at-an-error",
       stops_at_an_error,
       {"no-exception-escapes"},
       "an error of the host ends the strategy with an error; no other attempt helps"},
      {"stops-when-interrupted",
       stops_when_interrupted,
       {"no-exception-escapes"},
       "return when a stage ends with Ending::interrupted, or call `work_left` before every stage: it is "
       "zero "
       "then"},
      {"stops-when-work-is-used-up",
       stops_when_work_is_used_up,
       {"no-exception-escapes"},
       "call `work_left` before every stage, and return when it is zero"},
      {"names-its-stages",
       names_its_stages,
       {"no-exception-escapes"},
       "describe the purpose of a stage in `name`: the report has a line for each"},
      {"asks-for-what-there-is",
       asks_for_what_there_is,
       {"no-exception-escapes"},
       "levels are below `levels()`, factors in [0, 1]; a cap of zero means that there is none"},
      {"keeps-within-its-work",
       keeps_within_its_work,
       {"no-exception-escapes"},
       "give a stage a budget of at most `work_left()`, or zero for all work that is left"},
      {"starts-from-numbers",
       starts_from_numbers,
       {"no-exception-escapes"},
       "`growing` of a stage is valid until the next call of the search only; or did you divide by zero?"},
      {"leaves-the-search-alone",
       leaves_the_search_alone,
       {"no-exception-escapes"},
       "do not change the start or the search: copy the start; write at most `message_size` bytes of "
       "message"},
      {"no-hidden-state",
       strategy_has_no_hidden_state,
       {"no-exception-escapes"},
       "no static or mutable variables, no clock: the same search must run the same stages, bit for bit"},
      {"answers-nothing", answers_nothing, {"no-exception-escapes"}, "a scene may have no unknowns at all"},
      {"survives-its-bounds",
       survives_its_bounds,
       {"no-equilibrium-is-no-error", "comes-to-an-end", "stops-when-work-is-used-up", "fills-its-stages",
        "asks-for-what-there-is", "keeps-within-its-work", "starts-from-numbers", "answers-with-numbers",
        "answers-the-scene-itself", "names-its-stages"},
       "both ends of a range are allowed values: is anything divided by a parameter that is zero there?"},
      {"explains-without-solving",
       explains_without_solving,
       {"no-exception-escapes"},
       "`explain` describes the attempts; only `run` requests stages"},
      {"explains-within-its-room",
       explains_within_its_room,
       {"explains-without-solving"},
       "write at most `text_size` bytes, including the terminating zero; the layer of strategy.hpp does"},
      {"starts-no-threads",
       method_starts_no_threads,
       {},
       "the program runs threads of its own; a thread started by a plugin slows them down"},
  };
  return checks;
}

}  // namespace
}  // namespace conformance

ConformanceReport check_strategy(const StrategyType& type, const ConformanceOptions& options) {
  using namespace conformance;
  ConformanceReport report;
  report.type = type.type;
  StrategyBench bench(type, options);
  Doubtful doubtful;
  report.checks = run_all(strategy_table(), bench, doubtful);
  return report;
}

std::vector<std::string> strategy_checks() { return conformance::names_of(conformance::strategy_table()); }

}  // namespace netloft
