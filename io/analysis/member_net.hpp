// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/scene/plan.hpp"
#include "io/analysis/axial_members.hpp"
#include "io/analysis/member_kernels.hpp"

#include <memory>
#include <span>

namespace netloft::io {

/// The members of a scene, and all its other forces by an assembler of their own: what solvers stand on that
/// treat the tension of a member as an unknown. Positions are a vector over all dofs [m], the unknowns first.
class MemberNet {
 public:
  using Vector = std::array<double, 3>;
  using Block = MemberBlock;
  using Line = MemberLine;

  /// Bodies and frames of its own make std::invalid_argument.
  MemberNet(const Scene& scene, Registry& registry, int threads);

  const std::vector<AxialMember>& members() const { return members_; }
  std::size_t size() const { return members_.size(); }
  std::size_t dofs() const { return x_.size(); }
  std::size_t unknowns() const { return static_cast<std::size_t>(pattern().size); }
  const SparsePattern& pattern() const { return rest_->pattern(); }
  const Line& line(std::size_t member) const { return lines_[member]; }

  /// All forces but those of the members, over all dofs [N], and their tangent [N/m]; false where there are
  /// none.
  bool evaluate(std::vector<double>& residual, std::vector<double>& values);
  /// Of the values of a tangent those that the pattern knows.
  std::span<const double> matrix(const std::vector<double>& values) const {
    return {values.data(), pattern().value_slots()};
  }
  /// Adds n c f of all members, f one for each, to the forces.
  void add_forces(std::span<const Vector> f, std::vector<double>& residual) const;
  /// Adds n c cᵀ K of all members, K row by row and symmetric, to the tangent.
  void add_blocks(std::span<const Block> K, std::vector<double>& values) const;
  /// Both of what members do in their lines.
  void add_tangents(std::span<const MemberTangent> tangents, std::vector<double>& residual,
                    std::vector<double>& values) const;

  /// Σ c s: by how much a step of the unknowns changes the w of all members [m].
  void find_changes(std::span<const double> step, std::span<Vector> changes);
  /// x ← x + a s.
  void move(std::span<const double> step, double a);
  /// Of the nodes of the scene, 3 each [m].
  std::vector<double> positions() const;

 private:
  void list_sites();
  MemberSite site_of(const AxialMember& member) const;
  std::int32_t find_block(const MemberSite& site, std::uint32_t p, std::uint32_t q) const;
  template <class Visit>
  void for_weighted(std::span<const double> v, const Visit& visit) const;
  void update_lines();

  std::vector<AxialMember> members_;
  Scene loose_;
  Plan plan_;
  std::unique_ptr<Assembler> rest_;  // all but the members
  std::vector<MemberSite> sites_;
  std::vector<MemberWeights> weights_;  // by member
  std::vector<Line> lines_;             // at x_
  std::vector<double> x_, step_;
};

/// √Σ v².
double norm_of(std::span<const double> v);
inline double dot(const MemberNet::Vector& a, const MemberNet::Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace netloft::io
