// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/bench.hpp"

namespace netloft::conformance {

/// What a check found.
struct Finding {
  bool passed = true, skipped = false;
  double figure = 0, limit = 0;
  std::string detail;
};

inline Finding nothing_to_ask(const char* why) { return {true, true, 0, 0, why}; }
inline Finding failed(std::string detail) { return {false, false, 0, 0, std::move(detail)}; }
/// Passed when nothing was worse than the limit; skipped when nothing was noted.
Finding judged(const Worst& worst, const char* nothing_noted);
/// A check over yes-or-no questions: passed when no fault was found.
Finding judged(const std::string& fault);
/// Whether defaults, and samples of what has none, are within the ranges of their parameters. (bench.cpp)
Finding judged_defaults(std::span<const netloft_parameter> table, std::size_t bytes, const Values& sampled);
/// Skipped where the system does not show threads. (bench.cpp)
Finding no_more_threads_than(const Threads& before);

// Does it answer at all? (answering_checks.cpp)
Finding makes_elements(Bench&);
Finding no_exception_escapes(Bench&);
Finding evaluates_without_error(Bench&);
Finding outputs_finite(Bench&);
Finding collapsed_finite(Bench&);
Finding finite_at_rest(Bench&);
Finding defaults_are_allowed(Bench&);
Finding refuses_wrong_parameters(Bench&);

// Does it read what its table declares, and no more? (declaration_checks.cpp)
Finding reads_what_it_declares(Bench&);
std::string undeclared_text(const ByteRange& range);

// Does it keep to its place and its inputs? (manners_checks.cpp)
Finding no_hidden_state(Bench&);
Finding nothing_written_past_count(Bench&);
Finding adds_not_overwrites(Bench&);
Finding same_in_any_lane(Bench&);
Finding same_force_without_tangent(Bench&);
Finding same_energy_alone(Bench&);
Finding same_from_two_threads(Bench&);
Finding starts_no_threads(Bench&);
Finding missing_inputs_are_zero(Bench&);

// Are the derivatives right? (derivative_checks.cpp)
Finding force_is_gradient(Bench&);
Finding tangent_is_derivative(Bench&);
Finding symmetric_where_claimed(Bench&);
Finding constant_where_claimed(Bench&);
Finding no_work_round_a_closed_path(Bench&);

// Are the matrices for solvers what they are said to be? (matrix_checks.cpp)
Finding convex_is_positive(Bench&);
Finding metric_is_constant(Bench&);
Finding metric_bounds_convex(Bench&);

// Is it the same wherever it is? (motion_checks.cpp)
Finding low_digits_ignored_or_taken(Bench&);
Finding translation_changes_nothing(Bench&);
Finding rotation_turns_the_force(Bench&);
Finding forces_sum_to_zero(Bench&);
Finding moments_sum_to_zero(Bench&);

// Is a rotation a rotation, on a rigid body? (body_checks.cpp)
Finding body_turns_with_the_world(Bench&);
Finding full_turns_change_nothing(Bench&);
Finding sides_mirror_each_other(Bench&);
Finding inertia_makes_kinetic_energy(Bench&);

// Is it passive in the water? (flow_checks.cpp)
Finding no_force_without_flow(Bench&);
Finding never_gains_energy(Bench&);
Finding says_how_much_it_stands_for(Bench&);

// Are the members what their term is? (member_checks.cpp)
Finding members_make_their_term(Bench&);

std::vector<TermTiming> time_terms(const Bench&);

}  // namespace netloft::conformance
