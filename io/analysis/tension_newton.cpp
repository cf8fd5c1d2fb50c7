// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/tension_newton.hpp"

#include "framework/assembler/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace netloft::io {

namespace {

constexpr double kLeastDamping = 1e-13, kMostDamping = 1;
constexpr double kDrop = 0.1;                                // of damping with a whole step
constexpr double kLargestDrop = 0.06, kLeastDrop = 1 / 0.7;  // of damping with the residual, from afar
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStrainOfTaut = 1e-3;  // at the most, of a member the step makes taut

double norm_of(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a * a;
  return std::sqrt(sum);
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

TensionNewton::TensionNewton(const Scene& scene, Registry& registry, MakeFactorisation make, int threads)
    : loose_(without_axial_stiffness(scene, registry)),
      plan_(make_plan(loose_, registry)),
      members_(axial_members(scene, registry)),
      stiffness_(scene.parts.size(), 0.0) {
  if (!scene.bodies.empty() || !scene.frames.empty())
    throw std::invalid_argument("tensions are unknowns only where nodes move along x, y and z");
  rest_ = std::make_unique<Assembler>(loose_, plan_, threads);
  const SparsePattern& pattern = rest_->pattern();
  factorisation_ = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation_->analyse(pattern);
  x_ = rest_->start();
  residual_.resize(x_.size()), mixed_.resize(x_.size());
  values_.resize(rest_->value_slots()), step_.resize(static_cast<std::size_t>(pattern.size));
  for (const AxialMember& m : members_) stiffness_[m.part] = std::max(stiffness_[m.part], m.EA);
  for (const AxialMember& m : members_) places_.push_back(places_of(m));
  lines_.resize(members_.size()), changes_.resize(members_.size());
  update_lines();
}

TensionNewton::Places TensionNewton::places_of(const AxialMember& m) const {
  const Numbering& numbering = rest_->numbering();
  const SparsePattern& pattern = rest_->pattern();
  Places places;
  places.dof.fill(0), places.block.fill(-1);
  for (std::uint32_t i = 0; i < 3 * m.nodes; ++i)
    places.dof[i] = numbering.index(m.node[i / 3], static_cast<int>(i % 3));
  for (std::uint32_t row = 0; row < 3 * m.nodes; ++row)
    for (std::uint32_t column = 0; column < 3 * m.nodes; ++column) {
      const std::int32_t i = places.dof[row], j = places.dof[column];
      const bool kept = i < pattern.size && j < pattern.size && (!pattern.symmetric || i >= j);
      if (!kept) continue;
      const auto slot = static_cast<std::int32_t>(find_slot(pattern, i, j));
      places.block[3 * (row / 3) + column / 3] = slot - static_cast<std::int32_t>(3 * (row % 3) + column % 3);
    }
  return places;
}

TensionNewton::Line TensionNewton::line(std::size_t e) const {
  const AxialMember& m = members_[e];
  const Places& at = places_[e];
  Line line{};
  for (std::uint32_t k = 0; k < m.nodes; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      line.t[axis] += m.c[k] * x_[static_cast<std::size_t>(at.dof[3 * k + axis])];
  line.l = std::sqrt(dot(line.t, line.t));
  for (double& t : line.t) t /= line.l;
  line.strain = line.l / m.l0 - 1;
  return line;
}

void TensionNewton::update_lines() {
  for (std::size_t e = 0; e < members_.size(); ++e) lines_[e] = line(e);
}

/// k of (1).
double TensionNewton::stiffness_now(std::size_t e) const {
  const AxialMember& m = members_[e];
  return share_[m.part] * (tension_[e] > 0 ? m.EA : m.EA_compression);
}

/// What the law of the member has at a strain.
double TensionNewton::own_tension(std::size_t e, double strain) const {
  const AxialMember& m = members_[e];
  return share_[m.part] * (strain > 0 ? m.EA : m.EA_compression) * strain;
}

void TensionNewton::follow_positions() {
  tension_.resize(members_.size());
  for (std::size_t e = 0; e < members_.size(); ++e) tension_[e] = own_tension(e, lines_[e].strain);
}

Leg TensionNewton::solve(const TensionStage& stage) {
  const double wall = wall_seconds(), cpu = cpu_seconds();
  books_ = {};
  share_ = stage.share;
  if (tension_.empty()) follow_positions();
  damping_ = stage.damping;
  Leg leg{stage.name, "tensions", step_.size(), SolveStatus::not_converged, "", {}};
  double turn = kNever, norm = 0;
  while (assemble()) {
    const double before = std::exchange(norm, norm_of({residual_.data(), step_.size()}));
    if (is_done(stage, turn)) {
      leg.status = SolveStatus::converged;
      break;
    }
    const bool called_off =
        (stage.interrupt && stage.interrupt->load()) || wall_seconds() - wall > stage.seconds;
    if (called_off || books_.iterations >= stage.iterations) break;
    ++books_.iterations;
    if (stage.from_afar && before > 0) damping_ *= std::clamp(norm / before, kLargestDrop, kLeastDrop);
    damping_ = std::clamp(damping_, kLeastDamping, kMostDamping);
    if (!find_step()) {
      damping_ = std::max(100 * damping_, 1e-6);
      continue;
    }
    const double a = std::min(1.0, stage.farthest_turn / largest_turn(false));
    turn = a < 1 ? kNever : largest_turn(true);
    take(a, stage.from_afar);
    if (!stage.from_afar) adapt(a);
  }
  books_.total_seconds = wall_seconds() - wall;
  books_.total_cpu_seconds = books_.solver_cpu_seconds = cpu_seconds() - cpu;
  leg.books = books_;
  return leg;
}

/// The matrix and the right-hand side of (2), and the residual of the members' own law.
bool TensionNewton::assemble() {
  Timed timed(books_.assembly_seconds);
  ++books_.residuals, ++books_.matrices;
  Request request;
  request.residual = residual_.data(), request.matrix = MatrixKind::exact, request.values = values_.data();
  if (!rest_->evaluate(x_, request)) return false;
  mixed_ = residual_;
  for (std::size_t e = 0; e < members_.size(); ++e) add_member(e);
  return std::isfinite(norm_of(residual_));
}

void TensionNewton::add_member(std::size_t e) {
  const AxialMember& m = members_[e];
  const Places& at = places_[e];
  const Line& now = lines_[e];
  const double k = stiffness_now(e), T = tension_[e], own = own_tension(e, now.strain),
               linear = k * now.strain;
  const double all = T / now.l + damping_ * share_[m.part] * m.EA / m.l0, along = k / m.l0 - T / now.l;
  std::array<double, 9> K;
  for (std::size_t i = 0; i < 9; ++i) K[i] = along * now.t[i / 3] * now.t[i % 3] + (i % 4 == 0 ? all : 0.0);
  for (std::uint32_t p = 0; p < m.nodes; ++p) {
    const double c = m.count * m.c[p];
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const auto dof = static_cast<std::size_t>(at.dof[3 * p + axis]);
      residual_[dof] += c * own * now.t[axis];
      mixed_[dof] += c * linear * now.t[axis];
    }
    for (std::uint32_t q = 0; q < m.nodes; ++q)
      if (const std::int32_t block = at.block[3 * p + q]; block >= 0)
        for (std::size_t i = 0; i < 9; ++i) values_[static_cast<std::size_t>(block) + i] += c * m.c[q] * K[i];
  }
}

bool TensionNewton::is_done(const TensionStage& stage, double turn) {
  if (stage.settled_turn > 0 && !(turn < stage.settled_turn)) return false;
  double largest = 0, reaction = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    double& of = i < step_.size() ? largest : reaction;
    of = std::max(of, std::abs(residual_[i]));
  }
  return largest <= stage.tolerance * reaction;
}

bool TensionNewton::find_step() {
  FactorResult result;
  {
    Timed timed(books_.factorisation_seconds);
    ++books_.factorisations;
    result = factorisation_->factorise(values_);
  }
  if (result.status != FactorStatus::ok) return false;
  Timed timed(books_.solve_seconds);
  ++books_.solves;
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = -mixed_[i];
  factorisation_->solve(step_, step_);
  update_changes();
  return std::isfinite(norm_of(step_));
}

void TensionNewton::update_changes() {
  for (std::size_t e = 0; e < members_.size(); ++e) changes_[e] = change_of(e);
}

TensionNewton::Vector TensionNewton::change_of(std::size_t e) const {
  const AxialMember& m = members_[e];
  Vector change{};
  for (std::uint32_t i = 0; i < 3 * m.nodes; ++i)
    if (const auto dof = static_cast<std::size_t>(places_[e].dof[i]); dof < step_.size())
      change[i % 3] += m.c[i / 3] * step_[dof];
  return change;
}

double TensionNewton::largest_turn(bool taut_only) const {
  double largest = 0;
  for (std::size_t e = 0; e < members_.size(); ++e) {
    if (taut_only && tension_[e] <= 0) continue;
    const Line& now = lines_[e];
    const double along = dot(changes_[e], now.t);
    const double across = std::sqrt(std::max(0.0, dot(changes_[e], changes_[e]) - along * along));
    largest = std::max(largest, across / std::max(now.l, members_[e].l0));
  }
  return largest;
}

/// (3).
void TensionNewton::take(double a, bool from_afar) {
  if (!from_afar)
    for (std::size_t e = 0; e < members_.size(); ++e) {
      const Line& now = lines_[e];
      const double strain = now.strain + dot(now.t, changes_[e]) / members_[e].l0;
      const double next = tension_[e] <= 0 && strain > 0 ? own_tension(e, std::min(strain, kStrainOfTaut))
                                                         : stiffness_now(e) * strain;
      tension_[e] += a * (next - tension_[e]);
    }
  for (std::size_t i = 0; i < step_.size(); ++i) x_[i] += a * step_[i];
  update_lines();
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
    largest[members_[e].part] = std::max(largest[members_[e].part], std::abs(tension_[e]));
  return largest;
}

std::vector<double> TensionNewton::positions() const {
  std::vector<double> all(x_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = x_[static_cast<std::size_t>(
        rest_->numbering().index(static_cast<std::uint32_t>(i / 3), static_cast<int>(i % 3)))];
  return all;
}

}  // namespace netloft::io
