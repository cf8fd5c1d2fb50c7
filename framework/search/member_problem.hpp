// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factors.hpp"
#include "framework/balance/limits.hpp"
#include "framework/search/member_kernels.hpp"

#include <functional>

namespace netloft {

/// A static scene with its members separated from all other forces, for methods that treat the tension T of a
/// member as an unknown:
///   r(u) + Σ n c T t = 0                                                                    (1)
/// r is the sum of the terms without NETLOFT_OF_MEMBERS. For each member, n is the number of equal twines
/// that it represents, c are the coefficients of its chord, and t is its unit vector (netloft_member). Counts
/// and times every call as StaticProblem does, on the same assembler. Everything is at rest, at time zero.
///
/// Rigid bodies move but do not turn. The coefficients c thus stay constant, as methods with unknown tensions
/// require, and a board stays upright while its ropes become taut. The result is an initial guess for a
/// solver that turns the bodies.
class MemberProblem {
 public:
  /// Uses the elements that declare members and whose term with NETLOFT_OF_MEMBERS is active. Members without
  /// any stiffness (ropes at constant tension) are ignored.
  MemberProblem(Assembler& assembler, MakeFactorisation make, Limits limits,
                std::function<void(const IterationRecord&)> on_iteration = {});

  /// Whether a scene has members, and all nodes move along the world's axes (no node has axes of its own).
  static bool serves(const Scene& scene, const Assembler& assembler);

  netloft_members& interface() { return interface_; }
  const Statistics& statistics() const { return statistics_; }
  Stop stop() const { return stop_; }

 private:
  void list_members();
  void list_members(const ElementFamily& family);
  void add_site(const ElementFamily& family, std::size_t element, std::span<const netloft_member> reported);
  std::int32_t find_block(const MemberSite& site, std::uint32_t p, std::uint32_t q) const;
  void list_rotations();
  void fill_interface();
  void fix_rotations(double* residual);
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
  double begun_ = 0, begun_cpu_ = 0, load_ = 0;  // wall and processor time at the start [s]; largest |r| at
                                                 // the last state [N]

  std::vector<netloft_member> members_;
  std::vector<std::uint32_t> part_;
  /// A coordinate of a node that a body carries. Its coefficient in the chord of `member` is c[k]. `point` is
  /// the index of this coordinate in vectors over all degrees of freedom, `origin` the index of the same
  /// coordinate of the body's origin.
  struct Carried {
    std::size_t member, k, axis;
    std::int32_t point, origin;
  };
  std::vector<Carried> carried_;
  std::vector<std::size_t> rotations_;  // indices of bodies' rotations among the unknowns
  // Indices of the matrix values in rows and columns of bodies' rotations: those on the diagonal, and those
  // beside it.
  std::vector<std::size_t> of_rotations_, beside_;
  std::vector<MemberSite> sites_;
  std::vector<MemberWeights> weights_;    // weights of each member
  std::vector<double> x_, step_;          // over all degrees of freedom
  std::vector<double> tangent_, values_;  // values of two matrices: the tangent of r, and the matrix of (1)
};

}  // namespace netloft
