// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/tension_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace netloft::io {

namespace {

constexpr double kLeastDamping = 1e-13, kMostDamping = 1;
constexpr double kDrop = 0.1;                                // of damping with a whole step
constexpr double kLargestDrop = 0.06, kLeastDrop = 1 / 0.7;  // of damping with the residual, from afar
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStrainOfTaut = 1e-3;  // at the most, of a member the step makes taut

bool all_finite(const std::vector<double>& v) {
  return std::all_of(v.begin(), v.end(), [](double a) { return std::isfinite(a); });
}

}  // namespace

TensionNewton::TensionNewton(const Scene& scene, Registry& registry, MakeFactorisation make, int threads)
    : net_(scene, registry, threads),
      changes_(net_.size()),
      forces_(net_.size()),
      tangents_(net_.size()),
      stiffness_(scene.parts.size(), 0.0) {
  const SparsePattern& pattern = net_.pattern();
  factorisation_ = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation_->analyse(pattern);
  step_.resize(net_.unknowns());
  for (const AxialMember& m : net_.members()) stiffness_[m.part] = std::max(stiffness_[m.part], m.EA);
}

/// EA and EA_c of the stage.
void TensionNewton::set_laws() {
  laws_.resize(net_.size());
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const AxialMember& m = net_.members()[e];
    laws_[e] = {share_[m.part] * m.EA, share_[m.part] * m.EA_compression, 1 / m.l0};
  }
}

void TensionNewton::follow_positions() {
  tension_.resize(net_.size());
  for (std::size_t e = 0; e < net_.size(); ++e) tension_[e] = own_tension(e, net_.line(e).strain);
}

Leg TensionNewton::solve(const TensionStage& stage) {
  const double wall = wall_seconds(), cpu = cpu_seconds();
  books_ = {};
  share_ = stage.share;
  set_laws();
  if (tension_.empty()) follow_positions();
  damping_ = stage.damping;
  Leg leg{stage.name, "tensions", step_.size(), SolveStatus::not_converged, "", {}};
  double turn = kNever, norm = 0;
  while (find_rest()) {
    const bool has_settled = stage.settled_turn <= 0 || turn < stage.settled_turn;
    if ((has_settled || stage.from_afar) && !find_residual()) break;
    if (has_settled && is_balanced(stage.tolerance)) {
      leg.status = SolveStatus::converged;
      break;
    }
    const bool called_off =
        (stage.interrupt && stage.interrupt->load()) || wall_seconds() - wall > stage.seconds;
    if (called_off || books_.iterations >= stage.iterations) break;
    if (!assemble()) break;
    ++books_.iterations;
    if (stage.from_afar) {
      const double before = std::exchange(norm, norm_of({residual_.data(), step_.size()}));
      if (before > 0) damping_ *= std::clamp(norm / before, kLargestDrop, kLeastDrop);
    }
    damping_ = std::clamp(damping_, kLeastDamping, kMostDamping);
    if (!find_step()) {
      damping_ = std::max(100 * damping_, 1e-6);
      continue;
    }
    const Turns largest = largest_turns();
    const double a = std::min(1.0, stage.farthest_turn / largest.of_all);
    turn = a < 1 ? kNever : largest.of_taut;
    take(a, stage.from_afar);
    if (!stage.from_afar) adapt(a);
  }
  books_.total_seconds = wall_seconds() - wall;
  books_.total_cpu_seconds = books_.solver_cpu_seconds = cpu_seconds() - cpu;
  leg.books = books_;
  return leg;
}

/// All other forces and their tangent: where a stage begins, those of the last one. False: there are none.
bool TensionNewton::find_rest() {
  if (knows_rest_) return true;
  Timed timed(books_.assembly_seconds);
  ++books_.residuals, ++books_.matrices;
  return knows_rest_ = net_.evaluate(mixed_, values_);
}

/// Of the members' own law; false where it is no number.
bool TensionNewton::find_residual() {
  Timed timed(books_.assembly_seconds);
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const MemberNet::Line& now = net_.line(e);
    const double T = own_tension(e, now.strain);
    forces_[e] = {T * now.t[0], T * now.t[1], T * now.t[2]};
  }
  residual_ = mixed_;
  net_.add_forces(forces_, residual_);
  return all_finite(residual_);
}

/// The matrix and the right-hand side of (2); false where that is no number.
bool TensionNewton::assemble() {
  Timed timed(books_.assembly_seconds);
  set_tangents();
  net_.add_tangents(tangents_, mixed_, values_);
  knows_rest_ = false;
  return all_finite(mixed_);
}

/// What members add to (2): k ε t, and to the matrix.
void TensionNewton::set_tangents() {
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const MemberNet::Line& now = net_.line(e);
    const double k = stiffness_now(e), turning = tension_[e] * now.inverse;
    tangents_[e] = {k * now.strain, k * laws_[e].inverse - turning,
                    turning + damping_ * laws_[e].EA * laws_[e].inverse};
  }
}

/// By the last residual.
bool TensionNewton::is_balanced(double tolerance) const {
  double largest = 0, reaction = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    double& of = i < step_.size() ? largest : reaction;
    of = std::max(of, std::abs(residual_[i]));
  }
  return largest <= tolerance * reaction;
}

bool TensionNewton::find_step() {
  FactorResult result;
  {
    Timed timed(books_.factorisation_seconds);
    ++books_.factorisations;
    result = factorisation_->factorise(net_.matrix(values_));
  }
  if (result.status != FactorStatus::ok) return false;
  Timed timed(books_.solve_seconds);
  ++books_.solves;
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = -mixed_[i];
  factorisation_->solve(step_, step_);
  net_.find_changes(step_, changes_);
  return all_finite(step_);
}

TensionNewton::Turns TensionNewton::largest_turns() const {
  double of_all = 0, of_taut = 0;  // squares
  for (std::size_t e = 0; e < net_.size(); ++e) {
    const MemberNet::Line& now = net_.line(e);
    const double along = dot(changes_[e], now.t), across = dot(changes_[e], changes_[e]) - along * along,
                 inverse = std::min(now.inverse, laws_[e].inverse), turn = across * inverse * inverse;
    of_all = std::max(of_all, turn);
    if (tension_[e] > 0) of_taut = std::max(of_taut, turn);
  }
  return {std::sqrt(of_all), std::sqrt(of_taut)};
}

/// (3).
void TensionNewton::take(double a, bool from_afar) {
  if (!from_afar)
    for (std::size_t e = 0; e < net_.size(); ++e) {
      const MemberNet::Line& now = net_.line(e);
      const double strain = now.strain + dot(now.t, changes_[e]) * laws_[e].inverse;
      const double next = tension_[e] <= 0 && strain > 0 ? own_tension(e, std::min(strain, kStrainOfTaut))
                                                         : stiffness_now(e) * strain;
      tension_[e] += a * (next - tension_[e]);
    }
  net_.move(step_, a);
  if (from_afar) follow_positions();
}

/// With every whole step D falls, and short ones raise it.
void TensionNewton::adapt(double a) {
  if (a > 0.9)
    damping_ = std::max(kLeastDamping, damping_ * kDrop);
  else if (a < 0.2)
    damping_ = std::min(kMostDamping, damping_ * 3);
}

std::vector<double> TensionNewton::tensions_by_part() const {
  std::vector<double> largest(stiffness_.size(), 0.0);
  for (std::size_t e = 0; e < tension_.size(); ++e)
    largest[net_.members()[e].part] = std::max(largest[net_.members()[e].part], std::abs(tension_[e]));
  return largest;
}

}  // namespace netloft::io
