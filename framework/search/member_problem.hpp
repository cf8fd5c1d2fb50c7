// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factors.hpp"
#include "framework/balance/limits.hpp"
#include "framework/search/member_kernels.hpp"

#include <functional>

namespace netloft {

/// A static scene as members and all its other forces apart (netloft_members): what methods see that treat
/// the tension of a member as an unknown of its own.
///   r(u) + Σ n c T t = 0                                                                    (1)
/// r are the terms without NETLOFT_OF_MEMBERS, n, c, T and t those of netloft_member. Counts and times every
/// call as StaticProblem does, on the same assembler. Everything is at rest, at time zero.
///
/// Rigid bodies move and keep their attitude: c is then constant for members that lead to their points, as
/// these methods want it, and a board stands upright while the ropes that will hold it come taut. What is
/// found is a start for a solver that turns them.
class MemberProblem {
 public:
  /// Members are those of elements that tell them and whose term of members acts; those without any
  /// stiffness (a rope at constant tension) are left out.
  MemberProblem(Assembler& assembler, MakeFactorisation make, Limits limits,
                std::function<void(const IterationRecord&)> on_iteration = {});

  /// Whether a scene has members on nodes that move along the axes of the world: no frames.
  static bool serves(const Scene& scene, const Assembler& assembler);

  netloft_members& interface() { return interface_; }
  const Statistics& statistics() const { return statistics_; }
  /// Why `progress` told a method to give up.
  Stop stop() const { return stop_; }

 private:
  void list_members();
  void list_members(const ElementFamily& family);
  void add_site(const ElementFamily& family, std::size_t element, std::span<const netloft_member> told);
  std::int32_t find_block(const MemberSite& site, std::uint32_t p, std::uint32_t q) const;
  void list_rotations();
  void fill_interface();
  void keep_attitudes(double* residual);
  MemberTable table() const { return {sites_, weights_}; }
  void combine(const double* v, double* w) const;

  int chords(const double* u, double* w);
  int changes(const double* step, double* w);
  int evaluate(const double* u, double* residual);
  int add_forces(const double* f, double* residual);
  int set_matrix(const double* K);
  int set_matrix_along(const double* lines, double* residual);
  int factorise(int how);
  int solve(const double* rhs, double* x);
  int progress(double residual, const char* note);

  Assembler& assembler_;
  Limits limits_;
  std::function<void(const IterationRecord&)> on_iteration_;
  netloft_members interface_{};
  Statistics statistics_;
  Factors factors_;
  Stop stop_ = Stop::none;
  double begun_ = 0, begun_cpu_ = 0, load_ = 0;  // [s], [s]; largest of r in the last evaluation [N]

  std::vector<netloft_member> members_;
  std::vector<std::uint32_t> part_;
  /// A node that a body carries, at which member `member` has c[k], and the origin of that body, by the first
  /// of their coordinates in vectors over all degrees of freedom.
  struct Carried {
    std::size_t member, k, axis;
    std::int32_t point, origin;
  };
  std::vector<Carried> carried_;
  std::vector<std::size_t> rotations_;              // of bodies, among the unknowns
  std::vector<std::size_t> of_rotations_, beside_;  // their places on the diagonal, and off it
  std::vector<MemberSite> sites_;
  std::vector<MemberWeights> weights_;    // by member
  std::vector<double> x_, step_;          // over all degrees of freedom
  std::vector<double> tangent_, values_;  // of r; of (1)
};

}  // namespace netloft
