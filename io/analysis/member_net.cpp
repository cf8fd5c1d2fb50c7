// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/member_net.hpp"

#include "framework/assembler/pattern.hpp"

#include <cmath>
#include <stdexcept>

namespace netloft::io {

double norm_of(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a * a;
  return std::sqrt(sum);
}

double dot(const MemberNet::Vector& a, const MemberNet::Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

MemberNet::MemberNet(const Scene& scene, Registry& registry, int threads)
    : loose_(without_axial_stiffness(scene, registry)),
      plan_(make_plan(loose_, registry)),
      members_(axial_members(scene, registry)) {
  if (!scene.bodies.empty() || !scene.frames.empty())
    throw std::invalid_argument("tensions are unknowns only where nodes move along x, y and z");
  rest_ = std::make_unique<Assembler>(loose_, plan_, threads);
  x_ = rest_->start();
  for (const AxialMember& m : members_) places_.push_back(places_of(m));
  lines_.resize(members_.size());
  update_lines();
}

MemberNet::Places MemberNet::places_of(const AxialMember& m) const {
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

MemberNet::Line MemberNet::line_of(std::size_t e) const {
  const AxialMember& m = members_[e];
  const Places& at = places_[e];
  Line line{};
  for (std::uint32_t k = 0; k < m.nodes; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      line.w[axis] += m.c[k] * x_[static_cast<std::size_t>(at.dof[3 * k + axis])];
  line.l = std::sqrt(dot(line.w, line.w));
  for (std::size_t axis = 0; axis < 3; ++axis) line.t[axis] = line.w[axis] / line.l;
  line.strain = line.l / m.l0 - 1;
  return line;
}

void MemberNet::update_lines() {
  for (std::size_t e = 0; e < members_.size(); ++e) lines_[e] = line_of(e);
}

bool MemberNet::evaluate(std::vector<double>& residual, std::vector<double>& values) {
  residual.resize(x_.size()), values.resize(rest_->value_slots());
  Request request;
  request.residual = residual.data(), request.matrix = MatrixKind::exact, request.values = values.data();
  return rest_->evaluate(x_, request);
}

void MemberNet::add_force(std::size_t e, const Vector& f, std::vector<double>& residual) const {
  const AxialMember& m = members_[e];
  for (std::uint32_t i = 0; i < 3 * m.nodes; ++i)
    residual[static_cast<std::size_t>(places_[e].dof[i])] += m.count * m.c[i / 3] * f[i % 3];
}

void MemberNet::add_block(std::size_t e, const std::array<double, 9>& K, std::vector<double>& values) const {
  const AxialMember& m = members_[e];
  for (std::uint32_t p = 0; p < m.nodes; ++p)
    for (std::uint32_t q = 0; q < m.nodes; ++q)
      if (const std::int32_t block = places_[e].block[3 * p + q]; block >= 0)
        for (std::size_t i = 0; i < 9; ++i)
          values[static_cast<std::size_t>(block) + i] += m.count * m.c[p] * m.c[q] * K[i];
}

MemberNet::Vector MemberNet::change_of(std::size_t e, std::span<const double> step) const {
  const AxialMember& m = members_[e];
  Vector change{};
  for (std::uint32_t i = 0; i < 3 * m.nodes; ++i)
    if (const auto dof = static_cast<std::size_t>(places_[e].dof[i]); dof < step.size())
      change[i % 3] += m.c[i / 3] * step[dof];
  return change;
}

void MemberNet::move(std::span<const double> step, double a) {
  for (std::size_t i = 0; i < step.size(); ++i) x_[i] += a * step[i];
  update_lines();
}

std::vector<double> MemberNet::positions() const {
  std::vector<double> all(x_.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = x_[static_cast<std::size_t>(
        rest_->numbering().index(static_cast<std::uint32_t>(i / 3), static_cast<int>(i % 3)))];
  return all;
}

}  // namespace netloft::io
