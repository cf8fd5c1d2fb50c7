// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/conformance.hpp"

#include "framework/conformance/checklist.hpp"

#include <algorithm>
#include <atomic>

namespace netloft {

namespace {

using namespace conformance;

// The order matters: a check comes after the checks on which it depends.
const std::vector<Check<Bench>>& table() {
  static const std::vector<Check<Bench>> checks = {
      {"defaults-are-allowed",
       defaults_are_allowed,
       {},
       "a default must lie in the range that its own parameter allows"},
      {"refuses-wrong-parameters",
       refuses_wrong_parameters,
       {},
       "give every parameter the range in which the formulas hold, or refuse other values in check()"},
      {"makes-elements",
       makes_elements,
       {},
       "create() or check() refuses all values drawn from the declared ranges; narrow the ranges"},
      {"no-exception-escapes",
       no_exception_escapes,
       {},
       "catch every exception before it leaves the plugin, as the code of element.hpp does; leave rounding "
       "and traps as they were"},
      {"evaluates-without-error",
       evaluates_without_error,
       {"makes-elements", "no-exception-escapes"},
       "a state without a force is OUTSIDE_DOMAIN (throw OutsideDomain); ERROR stops the whole simulation"},
      {"outputs-finite",
       outputs_finite,
       {"evaluates-without-error"},
       "look for a division by zero, a root or logarithm of something negative"},
      {"no-hidden-state",
       no_hidden_state,
       {"outputs-finite"},
       "no static or mutable variables: an answer may depend on nothing but the tile"},
      {"reads-what-it-declares",
       reads_what_it_declares,
       {"no-hidden-state"},
       "declare every member that the term reads; element.hpp leaves all others at their defaults"},
      {"reads-the-inputs-it-declares",
       reads_the_inputs_it_declares,
       {"no-hidden-state"},
       "declare a trait for each input that the term reads; the program gives it no other input"},
      {"nothing-written-past-count",
       nothing_written_past_count,
       {"evaluates-without-error"},
       "loop to tile.count, not to 64"},
      {"adds-not-overwrites",
       adds_not_overwrites,
       {"no-hidden-state"},
       "use += : other terms have already added their forces there"},
      {"same-in-any-lane",
       same_in_any_lane,
       {"no-hidden-state"},
       "an element's answer may not depend on its place in the tile, nor on its neighbours"},
      {"same-force-without-tangent",
       same_force_without_tangent,
       {"no-hidden-state"},
       "compute the force in one way only; solvers compare forces with those computed together with a "
       "tangent"},
      {"same-energy-alone",
       same_energy_alone,
       {"no-hidden-state"},
       "compute the energy in one way only; line searches compare energies with those computed together with "
       "forces"},
      {"same-from-two-threads",
       same_from_two_threads,
       {"no-hidden-state"},
       "no static scratch space: tiles are evaluated by several threads at once"},
      {"missing-inputs-are-zero",
       missing_inputs_are_zero,
       {"no-hidden-state"},
       "v, a, current and current_dz may be null pointers, which means zero"},
      {"constant-where-claimed",
       constant_where_claimed,
       {"no-hidden-state"},
       "the trait `constant` is for forces that no motion changes, such as weight"},
      {"force-is-gradient",
       force_is_gradient,
       {"no-hidden-state"},
       "the force of a conservative term is +dE/dx, the residual: minus the physical force"},
      {"no-work-round-a-closed-path",
       no_work_round_a_closed_path,
       {"force-is-gradient"},
       "does the energy jump between branches (slack and taut)? Give both the same value where they meet"},
      {"tangent-is-derivative",
       tangent_is_derivative,
       {"no-hidden-state", "reads-the-inputs-it-declares", "constant-where-claimed"},
       "differentiate the force once more; does it include the change of direction (T/l), and are cu, cv "
       "and ca used?"},
      {"symmetric-where-claimed",
       symmetric_where_claimed,
       {"tangent-is-derivative"},
       "only a force that is a gradient has a symmetric tangent; drop the trait `symmetric`"},
      {"convex-is-positive",
       convex_is_positive,
       {"no-hidden-state"},
       "omit the part in compression: clamp T/l at zero"},
      {"metric-is-constant",
       metric_is_constant,
       {"no-hidden-state"},
       "the metric is the stiffness of the unloaded element, independent of its state"},
      {"metric-bounds-convex",
       metric_bounds_convex,
       {"convex-is-positive", "metric-is-constant"},
       "the metric must be at least as stiff as the convex part in every state"},
      {"low-digits-ignored-or-taken",
       low_digits_ignored_or_taken,
       {"no-hidden-state"},
       "where x_low is not null, positions are x + x_low: use both in differences, or x alone"},
      {"translation-changes-nothing",
       translation_changes_nothing,
       {"no-hidden-state"},
       "use differences of positions only, or declare the trait `from_outside`"},
      {"rotation-turns-the-force",
       rotation_turns_the_force,
       {"translation-changes-nothing"},
       "no direction of the compass is special: use lengths, dot and cross products"},
      {"forces-sum-to-zero",
       forces_sum_to_zero,
       {"force-is-gradient", "translation-changes-nothing"},
       "the force on one node must be balanced by forces on the others"},
      {"moments-sum-to-zero",
       moments_sum_to_zero,
       {"rotation-turns-the-force", "forces-sum-to-zero"},
       "forces between two nodes must lie along the line between them"},
      {"full-turns-change-nothing",
       full_turns_change_nothing,
       {"no-hidden-state"},
       "read the axes of the body, not the components of its rotation vector, which also count full turns"},
      {"body-turns-with-the-world",
       body_turns_with_the_world,
       {"full-turns-change-nothing", "translation-changes-nothing"},
       "no direction of the compass is special: use the body's own axes, dot and cross products; the moment "
       "is about the origin, in the axes of the world"},
      {"sides-mirror-each-other",
       sides_mirror_each_other,
       {"body-turns-with-the-world"},
       "with the datum `side` = -1, the body is the mirror image of that with `side` = 1 at its xz plane: y "
       "of "
       "all data in the axes of the body changes sign"},
      {"inertia-makes-kinetic-energy",
       inertia_makes_kinetic_energy,
       {"full-turns-change-nothing"},
       "the inertia of a turning body also includes omega x (omega x r) and omega x J omega"},
      {"members-make-their-term",
       members_make_their_term,
       {"force-is-gradient"},
       "the term with the trait `of_members` is the sum over the declared members: check number, rest length "
       "at this time, and both stiffnesses"},
      {"collapsed-finite",
       collapsed_finite,
       {"outputs-finite"},
       "with all nodes at one point, return finite numbers or OUTSIDE_DOMAIN (throw OutsideDomain)"},
      {"finite-at-rest",
       finite_at_rest,
       {"outputs-finite"},
       "the term divides by zero at the rest length, at zero velocity or in still water"},
      {"no-force-without-flow",
       no_force_without_flow,
       {"no-hidden-state"},
       "hydrodynamic forces come from the velocity relative to the water, current minus v"},
      {"never-gains-energy",
       never_gains_energy,
       {"no-force-without-flow"},
       "drag acts along the relative velocity; the residual is minus the physical force"},
      {"says-how-much-it-stands-for",
       says_how_much_it_stands_for,
       {"evaluates-without-error"},
       "pass FlowLanes::call the metres of twine or the area of netting of every lane, which are positive"},
      {"water-is-undisturbed-out-of-reach",
       water_is_undisturbed_out_of_reach,
       {"evaluates-without-error"},
       "water() returns the current where reach is 0"},
      {"water-has-its-derivatives",
       water_has_its_derivatives,
       {"evaluates-without-error"},
       "wrong derivatives of the velocity with respect to current or unknowns, or water() has a kink or a "
       "step"},
      {"water-turns-with-the-current",
       water_turns_with_the_current,
       {"evaluates-without-error"},
       "no direction of the compass is special, and no side of the netting: a current and a normal that are "
       "turned about the vertical change the water in the same way, turned, also if the normal is reversed"},
      {"still-water-stays-still",
       still_water_stays_still,
       {"water-turns-with-the-current"},
       "without a current, water() returns zero whatever the unknowns are"},
      {"lost-momentum-is-the-drag",
       lost_momentum_is_the_drag,
       {"water-has-its-derivatives", "water-turns-with-the-current"},
       "a slight drag D behind a mouth of area A slows the water at the net from V to w with D = 2 rho A w "
       "(V - w): check the thrust, and the weights by which drag enters the equation"},
      {"mouth-is-the-same-in-any-frame",
       mouth_is_the_same_in_any_frame,
       {"evaluates-without-error"},
       "the sum over a closed rim depends neither on the origin nor on the direction of the compass"},
      {"finer-rims-converge",
       finer_rims_converge,
       {"evaluates-without-error"},
       "the terms are integrals over the rim: half the bar, half the contribution"},
      {"starts-no-threads",
       starts_no_threads,
       {},
       "the program runs threads of its own; a thread started by a plugin slows them down"},
  };
  return checks;
}

}  // namespace

bool ConformanceReport::passed() const {
  return std::all_of(checks.begin(), checks.end(),
                     [](const CheckResult& c) { return c.passed || c.skipped; });
}

namespace {

/// The kinds of laws that the element accepts. The element is tested with each of them.
std::vector<std::uint32_t> law_kinds(const ElementType& type) {
  std::uint32_t accepted = 0;
  for (const auto& slot : type.laws) accepted |= slot.accepts;
  std::vector<std::uint32_t> kinds;
  for (const std::uint32_t kind : {NETLOFT_TWINE_LAW, NETLOFT_SCREEN_LAW})
    if (accepted & kind) kinds.push_back(kind);
  return kinds;
}

ConformanceReport check_with_law(const ElementType& type, const ConformanceOptions& options) {
  ConformanceReport report;
  report.type = type.type;
  Bench bench(type, options);
  Doubtful doubtful;
  report.checks = run_all(table(), bench, doubtful);
  if (options.timings && !doubtful.among({"evaluates-without-error"})) report.timings = time_terms(bench);
  return report;
}

/// Adds the failures of a run with another kind of law to a report.
void add_failures(ConformanceReport& report, ConformanceReport other) {
  for (std::size_t i = 0; i < report.checks.size(); ++i) {
    const CheckResult& c = other.checks[i];
    if (c.passed || c.skipped) continue;
    report.checks[i] = c;
    report.checks[i].detail += " (with a screen law)";
  }
}

}  // namespace

ConformanceReport check_element(const ElementType& type, const ConformanceOptions& options) {
  ConformanceOptions one = options;
  const auto kinds = law_kinds(type);
  if (one.law_kind == 0 && !kinds.empty()) one.law_kind = kinds.front();
  ConformanceReport report = check_with_law(type, one);
  if (options.law_kind != 0 || kinds.size() < 2) return report;
  one.law_kind = kinds[1];
  one.timings = false;
  add_failures(report, check_with_law(type, one));
  return report;
}

std::vector<std::string> conformance_checks() { return names_of(table()); }

std::string failures(const ConformanceReport& report) {
  std::string text;
  for (const auto& c : report.checks) {
    if (c.passed || c.skipped) continue;
    text += report.type + " fails " + c.name;
    if (c.limit > 0) text += " (" + number_text(c.figure) + ", allowed " + number_text(c.limit) + ")";
    text += ": " + c.detail + "\n  " + c.hint + "\n";
  }
  return text;
}

namespace conformance {

namespace {
std::atomic<const char*> under_way = nullptr;
}

UnderWay::UnderWay(const char* name) { under_way = name; }
UnderWay::~UnderWay() { under_way = nullptr; }

Finding judged(const Worst& worst, const char* nothing_noted) {
  if (worst.count() == 0) return not_applicable(nothing_noted);
  return {worst.figure() <= worst.limit(), false, worst.figure(), worst.limit(), worst.where()};
}

Finding judged(const std::string& fault) { return fault.empty() ? Finding{} : failed(fault); }

}  // namespace conformance

const char* check_under_way() { return conformance::under_way; }

}  // namespace netloft
