// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/bench.hpp"

namespace netloft::conformance {

struct Finding {
  bool passed = true, skipped = false;
  double figure = 0, limit = 0;
  std::string detail;
};

inline Finding not_applicable(const char* why) { return {true, true, 0, 0, why}; }
inline Finding failed(std::string detail) { return {false, false, 0, 0, std::move(detail)}; }
/// The check passed if no figure exceeds the limit. It is skipped if there are no figures.
Finding judged(const Worst& worst, const char* nothing_noted);
/// Result of a check without a figure: passed if `fault` is empty.
Finding judged(const std::string& fault);
/// Fails if a default value, or a sampled value of a parameter that has no default, is outside the range of
/// the parameter. (bench.cpp)
Finding judged_defaults(std::span<const netloft_parameter> table, std::size_t bytes, const Values& sampled);
/// Fails if the plugin left threads running. Skipped if the system does not report threads. (bench.cpp)
Finding no_more_threads_than(const Threads& before);

// Evaluation: does the element give an answer at all? (answering_checks.cpp)
Finding makes_elements(Bench&);
Finding no_exception_escapes(Bench&);
Finding evaluates_without_error(Bench&);
Finding outputs_finite(Bench&);
Finding collapsed_finite(Bench&);
Finding finite_at_rest(Bench&);
Finding defaults_are_allowed(Bench&);
Finding refuses_wrong_parameters(Bench&);

// Declarations: does the element read only what its table and its traits declare? (declaration_checks.cpp)
Finding reads_what_it_declares(Bench&);
Finding reads_the_inputs_it_declares(Bench&);
std::string undeclared_text(const ByteRange& range);

// Manners: does the element write only its outputs, and depend only on its inputs? (manners_checks.cpp)
Finding no_hidden_state(Bench&);
Finding nothing_written_past_count(Bench&);
Finding adds_not_overwrites(Bench&);
Finding same_in_any_lane(Bench&);
Finding same_force_without_tangent(Bench&);
Finding same_energy_alone(Bench&);
Finding same_from_two_threads(Bench&);
Finding starts_no_threads(Bench&);
Finding missing_inputs_are_zero(Bench&);

// Derivatives: are force and tangent correct? (derivative_checks.cpp)
Finding force_is_gradient(Bench&);
Finding tangent_is_derivative(Bench&);
Finding symmetric_where_claimed(Bench&);
Finding constant_where_claimed(Bench&);
Finding no_work_round_a_closed_path(Bench&);

// Matrices for solvers: do they have the promised properties? (matrix_checks.cpp)
Finding convex_is_positive(Bench&);
Finding metric_is_constant(Bench&);
Finding metric_bounds_convex(Bench&);

// Invariance: does the element behave alike in all places and directions? (motion_checks.cpp)
Finding low_digits_ignored_or_taken(Bench&);
Finding translation_changes_nothing(Bench&);
Finding rotation_turns_the_force(Bench&);
Finding forces_sum_to_zero(Bench&);
Finding moments_sum_to_zero(Bench&);

// Rotations of rigid bodies. (body_checks.cpp)
Finding body_turns_with_the_world(Bench&);
Finding full_turns_change_nothing(Bench&);
Finding sides_mirror_each_other(Bench&);
Finding inertia_makes_kinetic_energy(Bench&);

// Water: is the element passive? (flow_checks.cpp)
Finding no_force_without_flow(Bench&);
Finding never_gains_energy(Bench&);
Finding says_how_much_it_stands_for(Bench&);

// Flows: is the water that they change consistent? (changed_water_checks.cpp)
Finding water_is_undisturbed_out_of_reach(Bench&);
Finding water_has_its_derivatives(Bench&);
Finding water_turns_with_the_current(Bench&);
Finding still_water_stays_still(Bench&);
Finding lost_momentum_is_the_drag(Bench&);
Finding mouth_is_the_same_in_any_frame(Bench&);
Finding finer_rims_converge(Bench&);

// Members: do their forces add up to the force of their term? (member_checks.cpp)
Finding members_make_their_term(Bench&);

std::vector<TermTiming> time_terms(const Bench&);

}  // namespace netloft::conformance
