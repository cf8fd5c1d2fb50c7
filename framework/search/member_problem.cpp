// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/member_problem.hpp"

#include <netloft/vectors.hpp>

#include "framework/assembler/members.hpp"
#include "framework/assembler/pattern.hpp"
#include "framework/registry/host_function.hpp"
#include "framework/registry/plugin_call.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace netloft {

namespace {

bool bears(const netloft_member& member) { return member.EA != 0 || member.EA_compression != 0; }

bool all_finite(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a - a;  // the sum is zero unless a number is infinite or NaN
  return sum == 0;
}

}  // namespace

MemberProblem::MemberProblem(Assembler& assembler, MakeFactorisation make, Limits limits,
                             std::function<void(const IterationRecord&)> on_iteration)
    : assembler_(assembler),
      limits_(limits),
      on_iteration_(std::move(on_iteration)),
      factors_(std::move(make), statistics_),
      begun_(wall_seconds()),
      begun_cpu_(cpu_seconds()),
      x_(assembler.start()),
      step_(x_.size(), 0.0),
      tangent_(assembler.value_slots()),
      values_(assembler.value_slots()) {
  list_members();
  list_rotations();
  fill_interface();
}

bool MemberProblem::serves(const Scene& scene, const Assembler& assembler) {
  if (!scene.frames.empty()) return false;
  return std::any_of(assembler.families().begin(), assembler.families().end(), [](const auto& family) {
    if (!has_members(*family)) return false;
    const auto reported = members_of(*family);
    return std::any_of(reported.begin(), reported.end(), bears);
  });
}

void MemberProblem::list_members() {
  for (const auto& family : assembler_.families())
    if (has_members(*family)) list_members(*family);
}

void MemberProblem::list_members(const ElementFamily& family) {
  const auto reported = members_of(family);
  const std::size_t count = family.type().members.count;
  for (std::size_t e = 0; e < family.size(); ++e) add_site(family, e, {&reported[e * count], count});
}

/// Adds the sites (groups of nodes) of one element. A site has at most two members, because the kernels
/// expect this.
void MemberProblem::add_site(const ElementFamily& family, std::size_t element,
                             std::span<const netloft_member> reported) {
  MemberSite site;
  site.nodes = static_cast<std::uint32_t>(family.nodes_per_element());
  site.members = 0;
  const auto dof = [&](std::uint32_t i, bool of_carrier) {
    const std::uint32_t node = family.node(element, static_cast<int>(i / 3));
    return assembler_.numbering()
        .dof(of_carrier ? assembler_.carrier(node) : node, static_cast<int>(i % 3))
        .place;
  };
  for (std::uint32_t i = 0; i < 3 * site.nodes; ++i) site.dof[i] = dof(i, true);
  for (std::uint32_t p = 0; p < site.nodes; ++p)
    for (std::uint32_t q = 0; q < site.nodes; ++q) site.block[3 * p + q] = find_block(site, p, q);
  for (const netloft_member& m : reported) {
    if (!bears(m)) continue;
    if (site.members == 0) site.first = static_cast<std::uint32_t>(members_.size());
    for (std::uint32_t i = 0; i < 3 * site.nodes; ++i)
      if (site.dof[i] != dof(i, false))
        carried_.push_back({members_.size(), i / 3, i % 3, dof(i, false), site.dof[i]});
    members_.push_back(m);
    part_.push_back(family.part(element));
    weights_.push_back({{m.c[0], m.c[1], m.c[2]}, {m.number * m.c[0], m.number * m.c[1], m.number * m.c[2]}});
    if (++site.members == 2) {
      sites_.push_back(site);
      site.members = 0;
    }
  }
  if (site.members > 0) sites_.push_back(site);
}

void MemberProblem::list_rotations() {
  const SparsePattern& p = assembler_.pattern();
  std::vector<bool> turns(static_cast<std::size_t>(p.size));
  for (const auto& body : assembler_.body_nodes())
    for (int axis = 0; axis < 3; ++axis)
      if (const Dof i = assembler_.numbering().dof(body[1], axis); assembler_.numbering().is_unknown(i)) {
        turns[i.at()] = true;
        rotations_.push_back(i.at());
      }
  if (rotations_.empty()) return;
  for (std::size_t c = 0; c < turns.size(); ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      if (turns[r] || turns[c]) (r == c ? of_rotations_ : beside_).push_back(p.slot_of(k));
    }
}

/// Index of a 3 x 3 block in the array of matrix values, found from an entry of the block in the pattern; −1
/// if the pattern contains no entry of the block.
std::int32_t MemberProblem::find_block(const MemberSite& site, std::uint32_t p, std::uint32_t q) const {
  const SparsePattern& pattern = assembler_.pattern();
  for (std::uint32_t entry = 0; entry < 9; ++entry) {
    const std::int32_t i = site.dof[3 * p + entry / 3], j = site.dof[3 * q + entry % 3];
    if (i < pattern.size && j < pattern.size && (!pattern.symmetric || i >= j))
      return static_cast<std::int32_t>(find_slot(pattern, i, j)) - static_cast<std::int32_t>(entry);
  }
  return -1;
}

void MemberProblem::fill_interface() {
  interface_.size = sizeof interface_;
  interface_.host = this;
  interface_.count = static_cast<std::uint32_t>(members_.size());
  interface_.unknowns = static_cast<std::uint32_t>(assembler_.pattern().size);
  interface_.dofs = static_cast<std::uint32_t>(x_.size());
  for (const auto& family : assembler_.families())
    for (const std::uint32_t part : family->parts()) interface_.parts = std::max(interface_.parts, part + 1);
  interface_.traits = assembler_.pattern().symmetric ? std::uint32_t{NETLOFT_SYMMETRIC} : 0u;
  interface_.member = members_.data();
  interface_.part = part_.data();
  interface_.largest_coordinate = largest_of(x_);
  interface_.chords = HostFunction<&MemberProblem::chords>::call;
  interface_.changes = HostFunction<&MemberProblem::changes>::call;
  interface_.evaluate = HostFunction<&MemberProblem::evaluate>::call;
  interface_.add_forces = HostFunction<&MemberProblem::add_forces>::call;
  interface_.set_matrix = HostFunction<&MemberProblem::set_matrix>::call;
  interface_.set_matrix_along = HostFunction<&MemberProblem::set_matrix_along>::call;
  interface_.factorise = HostFunction<&MemberProblem::factorise>::call;
  interface_.solve = HostFunction<&MemberProblem::solve>::call;
  interface_.progress = HostFunction<&MemberProblem::progress>::call;
}

/// Computes w = Σ c v over the nodes of each member, where v is a vector over all degrees of freedom.
void MemberProblem::combine(const double* v, double* w) const {
  for_sites(table(), [&](const MemberSite& site, auto nodes, auto members) {
    std::array<double, 3 * nodes> at;
    for (std::uint32_t i = 0; i < 3 * nodes; ++i) at[i] = v[site.dof[i]];
    for (std::size_t e = site.first; e < std::size_t{site.first} + members; ++e)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (std::size_t k = 0; k < nodes; ++k) sum += weights_[e].c[k] * at[3 * k + axis];
        w[3 * e + axis] = sum;
      }
  });
}

int MemberProblem::chords(const double* u, double* w) {
  assembler_.place({u, interface_.unknowns}, x_);
  combine(x_.data(), w);
  for (const Carried& at : carried_) {
    const double beside = x_[static_cast<std::size_t>(at.point)] - x_[static_cast<std::size_t>(at.origin)];
    w[3 * at.member + at.axis] += weights_[at.member].c[at.k] * beside;
  }
  return NETLOFT_OK;
}

int MemberProblem::changes(const double* step, double* w) {
  std::copy_n(step, interface_.unknowns, step_.begin());  // step_ stays zero at held degrees of freedom
  combine(step_.data(), w);
  return NETLOFT_OK;
}

int MemberProblem::evaluate(const double* u, double* residual) {
  Timed timed(statistics_.assembly_seconds);
  ++statistics_.residuals;
  ++statistics_.matrices;
  assembler_.place({u, interface_.unknowns}, x_);
  const Request request{.without = NETLOFT_OF_MEMBERS,
                        .residual = residual,
                        .matrix = MatrixKind::exact,
                        .values = tangent_.data()};
  if (!assembler_.evaluate(x_, request)) return assembler_.fault().status;
  fix_rotations(residual);
  load_ = largest_of({residual, x_.size()});
  return all_finite({residual, x_.size()}) ? NETLOFT_OK : NETLOFT_OUTSIDE_DOMAIN;
}

/// Fixes the rotations of bodies: sets the moments to zero and removes the coupling of rotations to other
/// equations.
void MemberProblem::fix_rotations(double* residual) {
  for (const std::size_t i : rotations_) residual[i] = 0;
  for (const std::size_t slot : of_rotations_) tangent_[slot] = 1;
  for (const std::size_t slot : beside_) tangent_[slot] = 0;
}

int MemberProblem::add_forces(const double* f, double* residual) {
  Timed timed(statistics_.assembly_seconds);
  for_sites(table(), [&](const MemberSite& site, auto nodes, auto members) {
    const MemberWeights* weights = &weights_[site.first];
    const double* forces = f + 3 * std::size_t{site.first};
    for (std::size_t k = 0; k < nodes; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (std::size_t i = 0; i < members; ++i) sum += weights[i].number_c[k] * forces[3 * i + axis];
        residual[site.dof[3 * k + axis]] += sum;
      }
  });
  return NETLOFT_OK;
}

int MemberProblem::set_matrix(const double* K) {
  Timed timed(statistics_.assembly_seconds);
  values_ = tangent_;
  member_kernels().add_blocks(table(), K, values_.data());
  return NETLOFT_OK;
}

int MemberProblem::set_matrix_along(const double* lines, double* residual) {
  Timed timed(statistics_.assembly_seconds);
  values_ = tangent_;
  member_kernels().add_lines(table(), lines, residual, values_.data());
  return NETLOFT_OK;
}

int MemberProblem::factorise(int how) {
  const SparsePattern& pattern = assembler_.pattern();
  return factors_.factorise(pattern, how & NETLOFT_INDEFINITE, {values_.data(), pattern.value_slots()});
}

int MemberProblem::solve(const double* rhs, double* x) {
  const std::size_t size = interface_.unknowns;
  return factors_.solve({rhs, size}, {x, size}) ? NETLOFT_OK : NETLOFT_ERROR;
}

int MemberProblem::progress(double residual, const char* note) {
  IterationRecord record{statistics_.iterations,  residual, load_, 0, statistics_.factorisations,
                         wall_seconds() - begun_, ""};
  std::snprintf(record.note, sizeof record.note, "%s", note ? note : "");
  if (on_iteration_) on_iteration_(record);
  statistics_.total_seconds = record.seconds;
  statistics_.total_cpu_seconds = statistics_.solver_cpu_seconds = cpu_seconds() - begun_cpu_;
  stop_ = limits_.reached(statistics_.iterations, record.seconds, statistics_);
  if (stop_ != Stop::none) return NETLOFT_GIVE_UP;
  ++statistics_.iterations;
  return NETLOFT_GO_ON;
}

}  // namespace netloft
