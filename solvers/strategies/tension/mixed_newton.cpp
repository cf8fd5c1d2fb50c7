// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/mixed_newton.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace netloft::tension {

namespace {

// Least damping μ. A smaller μ would be less than the rounding error of the matrix.
constexpr double kLeastDamping = std::numeric_limits<double>::epsilon();

}  // namespace

MixedNewton::MixedNewton(const Parameters& parameters, netloft_members& members)
    : p_(parameters),
      members_(members),
      laws_(members_.size()),
      geometry_(members_.size()),
      w_(members_.size()),
      changes_(members_.size()),
      forces_(members_.size()),
      lines_(members_.size()),
      rest_(members_.dofs()),
      residual_(members_.dofs()),
      mixed_(members_.dofs()),
      step_(members_.unknowns()) {}

MixedNewton::Ending MixedNewton::solve(const Stage& stage, std::span<double> u) {
  begin(stage, u);
  for (std::int64_t i = 0; find_rest(u); ++i) {
    if (has_converged(stage)) return Ending::converged;
    if (i >= stage.iterations) return Ending::out_of_iterations;
    if (!assemble()) break;
    if (!members_.progress(largest_of({mixed_.data(), step_.size()}), stage.name)) return Ending::called_off;
    if (stage.is_far) follow_residual();
    if (find_step())
      take(stage, u);
    else
      set_damping(p_.factor * damping_);
  }
  return Ending::no_forces;
}

void MixedNewton::begin(const Stage& stage, std::span<const double> u) {
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const Member& m = members_[e];
    const double factor = stage.factor[members_.part(e)];
    laws_[e] = {factor * m.EA, factor * m.EA_compression, 1 / m.rest_length};
  }
  if (T_.empty()) {
    T_.resize(members_.size());
    update_geometry(u);
    follow_positions();
  }
  damping_ = stage.damping;
  took_whole_step_ = false;
  norm_ = 0;
}

void MixedNewton::update_geometry(std::span<const double> u) {
  members_.find_chords(u, w_);
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const double l = std::sqrt(dot(w_[e], w_[e])), inverse = 1 / l;
    geometry_[e] = {
        {w_[e][0] * inverse, w_[e][1] * inverse, w_[e][2] * inverse}, inverse, l * laws_[e].inverse_l0 - 1};
  }
}

void MixedNewton::follow_positions() {
  for (std::size_t e = 0; e < members_.size(); ++e) T_[e] = tension_at(e, geometry_[e].strain);
}

/// Computes r and its tangent at u, unless the last stage ended at this u and has computed them. Returns
/// false if elements cannot compute their forces.
bool MixedNewton::find_rest(std::span<const double> u) {
  if (!knows_rest_) knows_rest_ = members_.evaluate(u, rest_);
  return knows_rest_;
}

/// Whether the stage has reached its end. Computes the residual unless the stage `is_between`.
bool MixedNewton::has_converged(const Stage& stage) {
  if (stage.is_between) return took_whole_step_;
  return find_residual() && is_balanced(stage.tolerance);
}

/// Computes the residual (1) of mixed_newton.hpp with T = k ε(u). Returns false if it is not finite.
bool MixedNewton::find_residual() {
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const Geometry& g = geometry_[e];
    const double T = tension_at(e, g.strain);
    forces_[e] = {T * g.t[0], T * g.t[1], T * g.t[2]};
  }
  residual_ = rest_;
  members_.add_forces(forces_, residual_);
  return all_finite(residual_);
}

/// Whether the residual that find_residual() computed last is small against the largest reaction.
bool MixedNewton::is_balanced(double tolerance) const {
  const auto unknowns = static_cast<std::ptrdiff_t>(step_.size());
  const double largest = largest_of({residual_.begin(), residual_.begin() + unknowns}),
               reaction = largest_of({residual_.begin() + unknowns, residual_.end()});
  return largest <= tolerance * reaction;
}

/// Computes matrix and right-hand side of (2) in mixed_newton.hpp. Returns false if the right-hand side is
/// not finite.
bool MixedNewton::assemble() {
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const Geometry& g = geometry_[e];
    const double k = stiffness(e), across = T_[e] * g.inverse_l;
    lines_[e] = {g.t, k * g.strain, k * laws_[e].inverse_l0 - across,
                 across + damping_ * laws_[e].EA * laws_[e].inverse_l0};
  }
  mixed_ = rest_;
  members_.set_matrix(lines_, mixed_);
  return all_finite(mixed_);
}

/// Adapts the damping of the next matrices to the residual.
void MixedNewton::follow_residual() {
  const double before = std::exchange(norm_, norm({residual_.data(), step_.size()}));
  if (before > 0) set_damping(damping_ * std::clamp(norm_ / before, 1 / p_.factor, p_.factor));
}

bool MixedNewton::find_step() {
  if (members_.factorise_indefinite() != Factor::ok) return false;
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = -mixed_[i];
  members_.solve(step_, step_);
  members_.find_changes(step_, changes_);
  return all_finite(step_);
}

/// Largest rotation of a member if the whole step is taken [rad].
double MixedNewton::largest_turn() const {
  double square = 0;
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const Geometry& g = geometry_[e];
    const double along = dot(changes_[e], g.t), across = dot(changes_[e], changes_[e]) - along * along,
                 inverse = std::min(g.inverse_l, laws_[e].inverse_l0);
    square = std::max(square, across * inverse * inverse);
  }
  return std::sqrt(square);
}

/// Takes the step (3) of mixed_newton.hpp, shortened if a member would turn too far, and adapts the damping.
void MixedNewton::take(const Stage& stage, std::span<double> u) {
  const double a = std::min(1.0, stage.farthest_turn / largest_turn());
  took_whole_step_ = a == 1;
  if (!stage.is_far) move_tensions(a);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += a * step_[i];
  knows_rest_ = false;
  update_geometry(u);
  if (stage.is_far)
    follow_positions();
  else
    adapt_damping(a);
}

/// Updates the tensions by (3) of mixed_newton.hpp. If a step makes a slack member taut, the linearised
/// stretch of the member is arbitrary; therefore its strain is limited to kMatters.
void MixedNewton::move_tensions(double a) {
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const Geometry& g = geometry_[e];
    const double strain = g.strain + dot(g.t, changes_[e]) * laws_[e].inverse_l0;
    const bool becomes_taut = T_[e] <= 0 && strain > 0;
    const double next = becomes_taut ? tension_at(e, std::min(strain, kMatters)) : stiffness(e) * strain;
    T_[e] += a * (next - T_[e]);
  }
}

/// Lowers the damping after a whole step and raises it after a shorter one, as solvers/methods/newton does.
void MixedNewton::adapt_damping(double a) { set_damping(a == 1 ? damping_ / p_.factor : damping_ / (2 * a)); }

void MixedNewton::set_damping(double damping) { damping_ = std::clamp(damping, kLeastDamping, kMostDamping); }

std::vector<double> MixedNewton::tensions_by_part() const {
  std::vector<double> largest(members_.parts(), 0.0);
  for (std::size_t e = 0; e < T_.size(); ++e)
    largest[members_.part(e)] = std::max(largest[members_.part(e)], std::abs(T_[e]));
  return largest;
}

std::vector<double> MixedNewton::stiffness_by_part() const {
  std::vector<double> stiffness(members_.parts(), 0.0);
  for (std::size_t e = 0; e < members_.size(); ++e)
    stiffness[members_.part(e)] = std::max(stiffness[members_.part(e)], members_[e].EA);
  return stiffness;
}

}  // namespace netloft::tension
