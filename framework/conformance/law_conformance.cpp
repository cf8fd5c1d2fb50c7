// SPDX-License-Identifier: BSD-3-Clause
// Checks of a law: whether it answers and keeps to its outputs, and the table of all checks.
#include "framework/conformance/checklist.hpp"
#include "framework/conformance/law_checks.hpp"
#include "framework/conformance/timing.hpp"

#include <cmath>

namespace netloft {

namespace conformance {
namespace {

using conformance::same_lane;

bool same_lane(const LawAnswer& a, std::size_t i, const LawAnswer& b, std::size_t j) {
  return same_lane(a.force, i, b.force, j) && same_lane(a.d_flow, i, b.d_flow, j) &&
         same_lane(a.d_direction, i, b.d_direction, j) && same_lane(a.d_solidity, i, b.d_solidity, j);
}

/// Calls `question(part, flows)` for all sets of parameters. `question` returns a fault or an empty string.
template <class Question>
Finding ask_all(LawBench& b, Question&& question) {
  for (std::size_t part = 0; part < b.tiles.size(); ++part)
    if (const std::string fault = question(part, b.tiles[part]); !fault.empty()) return failed(fault);
  return {};
}

Finding law_defaults_are_allowed(LawBench& b) {
  return judged_defaults(b.type.parameters, b.type.law.parameter_bytes, b.values[0]);
}

Finding law_lets_no_exception_escape(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& f) { return b.evaluate(part, f, true).thrown; });
}

Finding law_evaluates_without_error(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& f) -> std::string {
    for (const bool derivatives : {false, true})
      if (!b.evaluate(part, f, derivatives).ok)
        return "parameters " + std::to_string(part) + ": status is not OK";
    return {};
  });
}

Finding law_outputs_are_finite(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& f) -> std::string {
    const LawAnswer a = b.evaluate(part, f, true);
    const std::pair<const char*, const std::vector<double>*> arrays[] = {{"force", &a.force},
                                                                         {"d_flow", &a.d_flow},
                                                                         {"d_direction", &a.d_direction},
                                                                         {"d_solidity", &a.d_solidity}};
    for (const auto& [name, values] : arrays)
      for (std::size_t i = 0; i < values->size(); ++i)
        if (!std::isfinite((*values)[i]))
          return b.place(part, i % kLanes) + ": " + name + "[" + std::to_string(i / kLanes) +
                 "] is not written or not finite";
    return {};
  });
}

/// Checks that the law does not change outputs in unused lanes (from `count` on), whatever the inputs in
/// these lanes.
Finding law_writes_nothing_past_count(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& all) -> std::string {
    for (const std::uint32_t count : {1u, 3u, 31u, 63u}) {
      Flows f = all;
      f.count = count;
      const LawAnswer a = b.evaluate(part, f, true);
      for (const auto* values : {&a.force, &a.d_flow, &a.d_direction, &a.d_solidity})
        for (std::size_t i = 0; i < values->size(); ++i)
          if (i % kLanes >= count && !std::isnan((*values)[i]))
            return "with " + std::to_string(count) + " flows, lane " + std::to_string(i % kLanes) +
                   " was written";
    }
    return {};
  });
}

Finding law_has_no_hidden_state(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& f) -> std::string {
    const LawAnswer before = b.evaluate(part, f, true);
    b.evaluate(part, b.tiles.front(), true);
    const LawAnswer after = b.evaluate(part, f, true);
    for (std::size_t lane = 0; lane < f.count; ++lane)
      if (!same_lane(before, lane, after, lane))
        return b.place(part, lane) + ": two calls give different answers";
    return {};
  });
}

/// Checks that results do not depend on bytes that no row of the table declares.
Finding law_reads_what_it_declares(LawBench& b) {
  const auto ranges = undeclared(b.type.parameters, b.type.law.parameter_bytes);
  if (ranges.empty()) return not_applicable("its table declares every byte of its parameters");
  return ask_all(b, [&](std::size_t part, const Flows& f) -> std::string {
    const LawAnswer before = b.evaluate(part, f, true);
    for (const auto& range : ranges) {
      b.parameters[part].spoil(range);
      const LawAnswer after = b.evaluate(part, f, true);
      b.parameters[part].clear(range);
      for (std::size_t lane = 0; lane < f.count; ++lane)
        if (before.ok != after.ok || !same_lane(before, lane, after, lane))
          return "the force reads " + undeclared_text(range);
    }
    return {};
  });
}

Finding law_is_the_same_in_any_lane(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& f) -> std::string {
    Flows turned = f;  // flows in reverse order
    for (auto field : {&Flows::flow, &Flows::direction, &Flows::diameter, &Flows::solidity})
      for (std::size_t i = 0; i < (f.*field).size(); ++i)
        (turned.*field)[at(i / kLanes, kLanes - 1 - i % kLanes)] = (f.*field)[i];
    const LawAnswer here = b.evaluate(part, f, true), there = b.evaluate(part, turned, true);
    for (std::size_t lane = 0; lane < f.count; ++lane)
      if (!same_lane(here, lane, there, kLanes - 1 - lane))
        return b.place(part, lane) + ": differs in another lane";
    return {};
  });
}

Finding law_has_the_same_force_alone(LawBench& b) {
  return ask_all(b, [&](std::size_t part, const Flows& f) -> std::string {
    const LawAnswer with = b.evaluate(part, f, true), alone = b.evaluate(part, f, false);
    for (std::size_t lane = 0; lane < f.count; ++lane)
      if (!same_lane(with.force, lane, alone.force, lane))
        return b.place(part, lane) + ": differs from the force without derivatives";
    return {};
  });
}

// The order matters: a check comes after the checks on which it depends.
const std::vector<Check<LawBench>>& law_table() {
  static const std::vector<Check<LawBench>> checks = {
      {"defaults-are-allowed",
       law_defaults_are_allowed,
       {},
       "a default must lie in the range that its own parameter allows"},
      {"no-exception-escapes",
       law_lets_no_exception_escape,
       {"defaults-are-allowed"},
       "catch every exception before it leaves the plugin, as the code of law.hpp does; leave rounding and "
       "traps as they were"},
      {"evaluates-without-error",
       law_evaluates_without_error,
       {"no-exception-escapes"},
       "an ERROR stops the whole simulation; a law must give a force for every flow"},
      {"outputs-finite",
       law_outputs_are_finite,
       {"evaluates-without-error"},
       "write every output; do you divide by zero without flow, or for flow along or across?"},
      {"nothing-written-past-count",
       law_writes_nothing_past_count,
       {"outputs-finite"},
       "loop to flow.count, not to 64"},
      {"no-hidden-state",
       law_has_no_hidden_state,
       {"outputs-finite"},
       "no static or mutable variables: an answer may depend on nothing but the flow"},
      {"reads-what-it-declares",
       law_reads_what_it_declares,
       {"no-hidden-state"},
       "declare every member that the law reads; law.hpp leaves all others at their defaults"},
      {"same-in-any-lane",
       law_is_the_same_in_any_lane,
       {"no-hidden-state"},
       "the force in a lane may not depend on the number of the lane, nor on other lanes"},
      {"same-force-without-derivatives",
       law_has_the_same_force_alone,
       {"no-hidden-state"},
       "compute the force in one way only"},
      {"no-force-without-flow", law_needs_flow, {"no-hidden-state"}, "without flow, the force must be zero"},
      {"no-kink",
       law_has_no_kink,
       {"no-hidden-state"},
       "|W·n| has a kink at grazing incidence, clamps have one at their ends: round them"},
      {"d-flow-is-derivative",
       d_flow_is_derivative,
       {"no-kink", "no-force-without-flow"},
       "differentiate the force by the flow; does the speed itself depend on it?"},
      {"d-direction-is-derivative",
       d_direction_is_derivative,
       {"no-kink", "no-force-without-flow"},
       "differentiate the force by the direction"},
      {"d-solidity-is-derivative",
       d_solidity_is_derivative,
       {"no-hidden-state"},
       "differentiate the force by the solidity; this is zero if the force does not depend on it"},
      {"never-gains-energy",
       law_never_gains_energy,
       {"no-force-without-flow"},
       "the force of a law is the physical one: its component along the flow is positive"},
      {"rotation-turns-the-force",
       rotation_turns_the_force_of_a_law,
       {"no-force-without-flow"},
       "no direction of the compass is special: use lengths, dot and cross products"},
      {"odd-in-flow",
       law_is_odd_in_flow,
       {"rotation-turns-the-force"},
       "a reversed flow must reverse the force"},
      {"even-in-direction",
       law_is_even_in_direction,
       {"odd-in-flow"},
       "twines and netting have no front and no back: t and -t must give the same force"},
  };
  return checks;
}

double nanoseconds(const LawBench& b, bool derivatives) {
  LawAnswer a = b.evaluate(0, b.tiles[0], true);
  const Flows& flows = b.tiles[0];
  netloft_law_tile f{};
  f.size = sizeof f;
  f.count = flows.count;
  f.water_density = 1025;
  f.water_viscosity = 1.19e-6;
  f.flow = flows.flow.data();
  f.direction = flows.direction.data();
  f.diameter = flows.diameter.data();
  f.solidity = flows.solidity.data();
  f.force = a.force.data();
  if (derivatives) {
    f.d_flow = a.d_flow.data();
    f.d_direction = a.d_direction.data();
    f.d_solidity = a.d_solidity.data();
  }
  std::string thrown;
  return least_nanoseconds_of([&] { b.call(0, f, thrown); }) / flows.count;
}

}  // namespace
}  // namespace conformance

ConformanceReport check_law(const LawType& type, const ConformanceOptions& options) {
  using namespace conformance;
  ConformanceReport report;
  report.type = type.type;
  LawBench bench(type, options);
  Doubtful doubtful;
  report.checks = run_all(law_table(), bench, doubtful);
  if (options.timings && !doubtful.among({"evaluates-without-error"}))
    report.timings = {{"law", "force", nanoseconds(bench, false)},
                      {"law", "force + derivatives", nanoseconds(bench, true)}};
  return report;
}

std::vector<std::string> law_checks() { return conformance::names_of(conformance::law_table()); }

}  // namespace netloft
