// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/interior_point.hpp"

#include <algorithm>
#include <limits>

namespace netloft::tension {

namespace {

/// Limit of μ and of the residual at convergence, relative to the load.
constexpr double kSolved = 0x1p-26;

double at_most_whole(double step) { return step > 1 ? 1 : step; }

}  // namespace

InteriorPoint::InteriorPoint(const Parameters& parameters, netloft_members& members)
    : p_(parameters),
      members_(members),
      states_(members_.size()),
      g_(members_.size()),
      blocks_(members_.size()),
      w_(members_.size()),
      forces_(members_.size()),
      changes_(members_.size()),
      residual_(members_.dofs()),
      rhs_(members_.dofs()),
      step_(members_.unknowns()) {
  scaling_.reserve(members_.size());
}

InteriorPoint::Ending InteriorPoint::solve(std::span<double> u, double load) {
  load_ = load;
  begin(u);
  while (evaluate(u)) {
    if (is_within(kSolved)) return Ending::converged;
    if (!members_.progress(largest_residual(), "interior point")) return Ending::called_off;
    if (!factorise()) return Ending::no_factor;
    const double a = find_step();
    if (!std::isfinite(a) || a < p_.room()) return Ending::no_step;
    take(a, u);
  }
  return Ending::no_forces;
}

double InteriorPoint::slack_fraction(std::span<const double> u) {
  members_.find_chords(u, w_);
  double slack = 0, all = 0;
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const double length = members_[e].number * members_[e].rest_length;
    all += length;
    if (strain(e) < 0) slack += length;
  }
  return slack / all;
}

/// Sets a first point that satisfies (2) of interior_point.hpp for the given u, but not (1).
void InteriorPoint::begin(std::span<const double> u) {
  is_indefinite_ = false;
  members_.find_chords(u, w_);
  for (std::size_t e = 0; e < members_.size(); ++e) {
    states_[e].z0 = std::max(0.0, strain(e)) + 1 + p_.room();
    const cone::Point z = z_of(e), mirrored = cone::mirrored(z);
    const double scale = load_ / cone::determinant(z);
    for (std::size_t i = 0; i < 4; ++i) states_[e].y[i] = scale * mirrored[i];
  }
}

cone::Point InteriorPoint::z_of(std::size_t e) const {
  const double l0 = members_[e].rest_length;
  return {states_[e].z0, w_[e][0] / l0, w_[e][1] / l0, w_[e][2] / l0};
}

bool InteriorPoint::is_within(double fraction) const {
  return mu_ <= fraction * load_ && largest_residual() <= fraction * load_;
}

/// Returns the μ that the point has reached: the mean of z·y over all members, weighted by their length.
double InteriorPoint::mean_complementarity() const {
  double sum = 0, length = 0;
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const double own = members_[e].number * members_[e].rest_length;
    sum += own * dot(z_of(e), states_[e].y);
    length += own;
  }
  return sum / length;
}

/// Computes the matrix of (3) in interior_point.hpp, r + Σ n c q and the scaling of all members. Returns
/// false if forces are undefined at u.
bool InteriorPoint::evaluate(std::span<const double> u) {
  members_.find_chords(u, w_);
  if (!members_.evaluate(u, residual_)) return false;
  set_members();
  members_.set_matrix(blocks_);
  members_.add_forces(forces_, residual_);
  mu_ = mean_complementarity();
  return all_finite(residual_) && std::isfinite(mu_);
}

void InteriorPoint::set_members() {
  scaling_.clear();
  for (std::size_t e = 0; e < members_.size(); ++e) set_member(e);
}

/// Computes the stiffness and the force q of one member for (3) of interior_point.hpp.
void InteriorPoint::set_member(std::size_t e) {
  const double l0 = members_[e].rest_length;
  const cone::Point& y = states_[e].y;
  const cone::Scaling& H = scaling_.emplace_back(z_of(e), y);
  const double pivot = EA(e) + H.squared(0, 0);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      blocks_[e][3 * i + j] =
          (H.squared(i + 1, j + 1) - H.squared(0, i + 1) * H.squared(0, j + 1) / pivot) / l0;
  forces_[e] = {-y[1], -y[2], -y[3]};
}

/// Factorises the matrix. It counts as positive definite until r makes it indefinite for the first time.
bool InteriorPoint::factorise() {
  if (!is_indefinite_) {
    const Factor factor = members_.factorise();
    if (factor != Factor::not_positive) return factor == Factor::ok;
    is_indefinite_ = true;
  }
  return members_.factorise_indefinite() == Factor::ok;
}

/// Computes the step by (5) of interior_point.hpp, or by (7) if (5) gives too short a step, and returns the
/// length (6) of the step.
double InteriorPoint::find_step() {
  predict();
  const double reached = at_most_whole(longest_step());
  const double sigma = (1 - reached) * (1 - reached) * (1 - reached);
  correct(sigma * mu_, SecondOrder::yes);
  if (const double a = length_of_step(); !(a < p_.room())) return a;
  correct(mu_, SecondOrder::no);
  return length_of_step();
}

double InteriorPoint::length_of_step() const { return at_most_whole(p_.to_boundary * longest_step()); }

void InteriorPoint::predict() {
  for (std::size_t e = 0; e < members_.size(); ++e)
    for (std::size_t i = 0; i < 4; ++i) g_[e][i] = -states_[e].y[i];
  solve_for_step();
}

void InteriorPoint::correct(double mu, SecondOrder second_order) {
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const cone::Scaling& W = scaling_[e];
    const cone::Point v = W.unscaled(states_[e].y), vv = cone::product(v, v);
    cone::Point second{}, rest;
    if (second_order == SecondOrder::yes)
      second = cone::product(W.scaled(states_[e].dz), W.unscaled(states_[e].dy));
    for (std::size_t i = 0; i < 4; ++i) rest[i] = (i == 0 ? mu : 0) - vv[i] - second[i];
    g_[e] = W.scaled(cone::quotient(rest, v));
  }
  solve_for_step();
}

/// Solves (3) of interior_point.hpp for the step, with the present g of every member.
void InteriorPoint::solve_for_step() {
  rhs_ = residual_;
  for (std::size_t e = 0; e < members_.size(); ++e) {
    const cone::Scaling& H = scaling_[e];
    const double z = zeta(e, g_[e][0], 0);
    for (std::size_t i = 0; i < 3; ++i) forces_[e][i] = H.squared(0, i + 1) * z - g_[e][i + 1];
  }
  members_.add_forces(forces_, rhs_);
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = -rhs_[i];
  members_.solve(step_, step_);
  members_.find_changes(step_, changes_);
  for (std::size_t e = 0; e < members_.size(); ++e) set_step(e);
}

/// Returns the ζ of (4) if along = 0, and δz₀ if along = h·δw/l₀.
double InteriorPoint::zeta(std::size_t e, double g0, double along) const {
  const double T = states_[e].y[0], z0 = states_[e].z0;
  return (EA(e) * (1 - z0) + T + g0 - along) / (EA(e) + scaling_[e].squared(0, 0));
}

/// Computes the steps of a member: δz from the change of its chord, and δy = g − H δz.
void InteriorPoint::set_step(std::size_t e) {
  const cone::Scaling& H = scaling_[e];
  cone::Point &dz = states_[e].dz, &dy = states_[e].dy;
  for (std::size_t k = 0; k < 3; ++k) dz[k + 1] = changes_[e][k] / members_[e].rest_length;
  dz[0] = zeta(e, g_[e][0], H.squared(0, 1) * dz[1] + H.squared(0, 2) * dz[2] + H.squared(0, 3) * dz[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    dy[i] = g_[e][i];
    for (std::size_t j = 0; j < 4; ++j) dy[i] -= H.squared(i, j) * dz[j];
  }
}

/// Returns the length of the step at which the first z or y leaves K, or NaN if the step is not finite.
double InteriorPoint::longest_step() const {
  if (!all_finite(step_)) return std::numeric_limits<double>::quiet_NaN();
  double longest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < members_.size(); ++e)
    longest = std::min({longest, cone::step_to_boundary(z_of(e), states_[e].dz),
                        cone::step_to_boundary(states_[e].y, states_[e].dy)});
  return longest;
}

void InteriorPoint::take(double a, std::span<double> u) {
  for (State& state : states_) {
    state.z0 += a * state.dz[0];
    for (std::size_t i = 0; i < 4; ++i) state.y[i] += a * state.dy[i];
  }
  for (std::size_t i = 0; i < u.size(); ++i) u[i] += a * step_[i];
}

}  // namespace netloft::tension
