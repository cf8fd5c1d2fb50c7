// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/verdict.hpp"
#include "io/analysis/member_net.hpp"
#include "io/analysis/second_order_cone.hpp"

namespace netloft::io {

/// What is asked of an interior-point solve.
struct ConeOptions {
  double tension = 0;       // first μ of (2) [N]: what drives the gear, all in all
  double tolerance = 1e-9;  // last μ over the first one
  int iterations = 200;
  double seconds = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const IterationRecord&)> on_iteration;
};

/// Where a scene comes to rest if its members bear tension only, by an interior-point method. That a member
/// is slack or taut is the complementarity of two points of a second-order cone K, its place in which is
/// worked out along with all others, so that no step has to guess who is slack. With r all other forces and
/// members of axial_members.hpp:
///   r(u) + Σ n c (q + p) = 0,  z = (1 + T/EA, w/l₀) ∈ K,  y = (T, −q) ∈ K                   (1)
///   z ∘ y = μ e,  μ → 0                                                                     (2)
/// At μ = 0 either T = 0 and the member is as short as it likes, or w has length l₀ (1 + T/EA) and q = T t.
/// Under dead loads these are the conditions of a convex problem, which has one energy (Y. Kanno, M. Ohsaki,
/// J. Ito, "Large-deformation and friction analysis of non-linear elastic cable networks by second-order cone
/// programming", Int. J. Numer. Methods Eng. 55, 2002). Newton's step for (1) and (2), scaled by W (W z =
/// W⁻¹ y, H = W²), T, q and z₀ eliminated member by member, h = (H₁₀, H₂₀, H₃₀), H̄ the rest:
///   (∂r/∂u + Σ n c cᵀ/l₀ [H̄ − h hᵀ/(EA + H₀₀) + D I]) s = −(r + Σ n c [q − ḡ + h ζ])         (3)
///   ζ = (EA (1 − z₀) + T + g₀)/(EA + H₀₀)                                                   (4)
///   g = −y to see how far one comes (a₀), then W (v \ (σ μ e − v∘v − W δz ∘ W⁻¹ δy)), v = W z,
///   σ = (1 − a₀)³, with the same matrix                                                     (5)
///   0.98 of the way to the boundary of K, at most a whole step                              (6)
/// (Mehrotra's predictor and corrector for cones: E. D. Andersen, C. Roos, T. Terlaky, Math. Program. 95,
/// 2003.) w is linear in u, so that the geometry of the members limits no step. Drag, whose law is none of a
/// convex problem, is linearised at every step like all of r; D [N], zero at first, grows where that leaves
/// steps short (Levenberg's damping).
///
/// Under dead loads members bear a little when pressed, too, so that they come to rest where that leaves them
/// instead of anywhere; EA in (1) to (4) is what is beyond it:
///   p = E_c (l/l₀ − 1) t,  E_c the least of EA_c and half of EA                                       (7)
///   ∂p/∂w = E_c/l₀ [t tᵀ + a (I − t tᵀ)],  a = 1 − l₀/l, or where that makes (3) indefinite max(0, a) (8)
/// but no more than a tenth of the first tension, and a hundredth where the mean EA_c is above that tenth.
/// (7) is not convex: of several shapes in balance it ends at one. Where what is pressed decides which, μ
/// that goes ahead of (1) would make up its mind too soon: (5) then aims at no less than a share of what is
/// left. A μ in the tension T of a member is worth EA μ/T by its own law, which is what a solver meets who
/// goes on: the end waits for that, too.
class TensionCones {
 public:
  /// Bodies and frames of its own make std::invalid_argument.
  TensionCones(const Scene& scene, Registry& registry, MakeFactorisation make, int threads);

  /// From the positions of the scene. Not converged: the reason says why.
  Leg solve(const ConeOptions& options);

  /// Whether a solver may start from where the last solve ended: little is left, converged or not.
  bool is_near() const;

  /// Positions of the nodes of the scene, 3 each [m].
  std::vector<double> positions() const { return net_.positions(); }

 private:
  struct Member {
    double z0;  // its w/l₀ is that of the net
    cone::Point y;
    cone::Point dz{}, dy{};  // the step
  };

  void begin(double mu);
  cone::Point z_of(std::size_t member) const;
  double mean_complementarity() const;
  bool assemble(bool convex);
  void set_member(std::size_t member, bool convex);
  void add_pressed(std::size_t member, bool convex);
  FactorStatus factorise_once();
  bool factorise();
  double EA(std::size_t member) const;
  double EA_pressed(std::size_t member) const;
  double mean_pressed() const;
  void solve_for_step(const std::vector<cone::Point>& g);
  void set_step(std::size_t member, const cone::Point& g);
  double zeta(std::size_t member, double g0, double along) const;
  double longest_step() const;
  std::vector<cone::Point> predictor() const;
  std::vector<cone::Point> corrector(double mu) const;
  double step();
  void take(double a);
  void adapt(double a, double tension);
  std::string run(const ConeOptions& options, double begun);
  std::string called_off(const ConeOptions& options, double begun);
  double largest_residual() const;
  double largest_law_error() const;

  MemberNet net_;
  MakeFactorisation make_;
  std::unique_ptr<Factorisation> factorisation_;
  std::vector<Member> members_;
  std::vector<cone::Scaling> scaling_;
  std::vector<MemberNet::Block> blocks_;
  std::vector<MemberNet::Vector> forces_, changes_;
  std::vector<double> residual_, values_, step_;
  double first_mu_ = 0, mu_ = 0, damping_ = 0, most_pressed_ = 0;  // [N]; the last of E_c
  double central_ = 0;                                             // least σ μ over the largest residual
  bool is_indefinite_ = false;                                     // the rest of (3), too
  bool has_forces_ = false;                                        // residual_ and mu_ are of where it is
  Books books_;
};

}  // namespace netloft::io
