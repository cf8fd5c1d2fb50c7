// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/member_net.hpp"

#include "framework/assembler/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace netloft::io {

double norm_of(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a * a;
  return std::sqrt(sum);
}

MemberNet::MemberNet(const Scene& scene, Registry& registry, int threads)
    : members_(axial_members(scene, registry)),
      loose_(without_axial_stiffness(scene, registry, members_)),
      plan_(make_plan(loose_, registry)) {
  if (!scene.bodies.empty() || !scene.frames.empty())
    throw std::invalid_argument("tensions are unknowns only where nodes move along x, y and z");
  rest_ = std::make_unique<Assembler>(loose_, plan_, threads);
  x_ = rest_->start();
  list_sites();
  lines_.resize(members_.size()), step_.resize(x_.size());
  update_lines();
}

void MemberNet::list_sites() {
  for (std::uint32_t e = 0; e < members_.size(); ++e) {
    const AxialMember& m = members_[e];
    const bool joins = e > 0 && sites_.back().members == 1 && members_[e - 1].nodes == m.nodes &&
                       members_[e - 1].node == m.node;
    if (joins) {
      sites_.back().members = 2;
    } else {
      sites_.push_back(site_of(m));
      sites_.back().first = e;
    }
    weights_.push_back({m.c, {m.count * m.c[0], m.count * m.c[1], m.count * m.c[2]}, 1 / m.l0});
  }
}

MemberSite MemberNet::site_of(const AxialMember& m) const {
  MemberSite site;
  site.nodes = m.nodes;
  for (std::uint32_t i = 0; i < 3 * m.nodes; ++i)
    site.dof[i] = rest_->numbering().index(m.node[i / 3], static_cast<int>(i % 3));
  for (std::uint32_t p = 0; p < m.nodes; ++p)
    for (std::uint32_t q = 0; q < m.nodes; ++q) site.block[3 * p + q] = find_block(site, p, q);
  return site;
}

/// By any of its entries that is kept.
std::int32_t MemberNet::find_block(const MemberSite& site, std::uint32_t p, std::uint32_t q) const {
  const SparsePattern& pattern = rest_->pattern();
  for (std::uint32_t entry = 0; entry < 9; ++entry) {
    const std::int32_t i = site.dof[3 * p + entry / 3], j = site.dof[3 * q + entry % 3];
    if (i < pattern.size && j < pattern.size && (!pattern.symmetric || i >= j))
      return static_cast<std::int32_t>(find_slot(pattern, i, j)) - static_cast<std::int32_t>(entry);
  }
  return -1;
}

namespace {

/// Calls visit(nodes, members) of a site, known at compile time so that its loops unroll.
template <class Visit>
void with_shape(std::uint32_t nodes, std::uint32_t members, const Visit& visit) {
  constexpr std::integral_constant<std::uint32_t, 1> one;
  constexpr std::integral_constant<std::uint32_t, 2> two;
  constexpr std::integral_constant<std::uint32_t, 3> three;
  if (nodes == 2)
    members == 1 ? visit(two, one) : visit(two, two);
  else
    members == 1 ? visit(three, one) : visit(three, two);
}

}  // namespace

/// Calls visit(member, Σ c v) for all members, v over all dofs.
template <class Visit>
void MemberNet::for_weighted(std::span<const double> v, const Visit& visit) const {
  for (const MemberSite& site : sites_)
    with_shape(site.nodes, site.members, [&](auto nodes, auto members) {
      std::array<double, 3 * nodes> at;
      for (std::uint32_t i = 0; i < 3 * nodes; ++i) at[i] = v[static_cast<std::size_t>(site.dof[i])];
      for (std::uint32_t i = 0; i < members; ++i) {
        const std::size_t e = std::size_t{site.first} + i;
        const auto& c = weights_[e].c;
        Vector sum;
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] = c[0] * at[axis] + c[1] * at[axis + 3];
        if constexpr (nodes == 3)
          for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += c[2] * at[axis + 6];
        visit(e, sum);
      }
    });
}

void MemberNet::update_lines() {
  for_weighted(x_, [&](std::size_t e, const Vector& w) {
    const double l = std::sqrt(dot(w, w)), inverse = 1 / l;
    lines_[e] = {
        {w[0] * inverse, w[1] * inverse, w[2] * inverse}, inverse, w, l, l * weights_[e].inverse_l0 - 1};
  });
}

bool MemberNet::evaluate(std::vector<double>& residual, std::vector<double>& values) {
  residual.resize(x_.size()), values.resize(rest_->value_slots());
  Request request;
  request.residual = residual.data(), request.matrix = MatrixKind::exact, request.values = values.data();
  return rest_->evaluate(x_, request);
}

void MemberNet::add_forces(std::span<const Vector> f, std::vector<double>& residual) const {
  for (const MemberSite& site : sites_)
    with_shape(site.nodes, site.members, [&](auto nodes, auto members) {
      const MemberWeights* weights = &weights_[site.first];
      const Vector* forces = &f[site.first];
      for (std::uint32_t k = 0; k < nodes; ++k) {
        Vector sum{};
        for (std::uint32_t i = 0; i < members; ++i)
          for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weights[i].count_c[k] * forces[i][axis];
        for (std::size_t axis = 0; axis < 3; ++axis)
          residual[static_cast<std::size_t>(site.dof[3 * k + axis])] += sum[axis];
      }
    });
}

void MemberNet::add_blocks(std::span<const Block> K, std::vector<double>& values) const {
  member_kernels().add_blocks({sites_, weights_}, K.data(), values.data());
}

void MemberNet::add_tangents(std::span<const MemberTangent> tangents, std::vector<double>& residual,
                             std::vector<double>& values) const {
  member_kernels().add_tangents({sites_, weights_}, lines_.data(), tangents.data(), residual.data(),
                                values.data());
}

void MemberNet::find_changes(std::span<const double> step, std::span<Vector> changes) {
  std::copy(step.begin(), step.end(), step_.begin());
  for_weighted(step_, [&](std::size_t e, const Vector& change) { changes[e] = change; });
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
