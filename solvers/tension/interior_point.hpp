// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/tension/members.hpp"
#include "solvers/tension/second_order_cone.hpp"

namespace netloft::tension {

/// Equilibrium of members that bear tension only, by an interior-point method. Whether a member is slack or
/// taut is the complementarity of two points of a second-order cone K, which is solved for together with the
/// positions, so that no step has to guess which members are slack. With r all other forces, n and c those of
/// netloft_member:
///   r(u) + Σ n c (q + p) = 0,  z = (1 + T/EA, w/l₀) ∈ K,  y = (T, −q) ∈ K                   (1)
///   z ∘ y = μ e,  μ → 0                                                                     (2)
/// At μ = 0 either T = 0 and the member is as short as it likes, or w has length l₀ (1 + T/EA) and q = T t.
/// Under dead loads these are the conditions of a convex problem, which has one energy (Y. Kanno, M. Ohsaki,
/// J. Ito, "Large-deformation and friction analysis of non-linear elastic cable networks by second-order cone
/// programming", Int. J. Numer. Methods Eng. 55, 2002). Newton's step for (1) and (2), scaled by W (W z =
/// W⁻¹ y, H = W²), T, q and z₀ eliminated member by member, h = (H₁₀, H₂₀, H₃₀), H̄ the rest:
///   (∂r/∂u + Σ n c cᵀ/l₀ [H̄ − h hᵀ/(EA + H₀₀) + D I]) s = −(r + Σ n c [q − ḡ + h ζ])         (3)
///   ζ = (EA (1 − z₀) + T + g₀)/(EA + H₀₀)                                                   (4)
///   g = −y to see how far a step leads (a₀), then W (v \ (σ μ e − v∘v − W δz ∘ W⁻¹ δy)), v = W z,
///   σ = (1 − a₀)³, with the same matrix                                                     (5)
///   a = `to_boundary` of the way to the boundary of K, at most a whole step                 (6)
/// (Mehrotra's predictor and corrector for cones: E. D. Andersen, C. Roos, T. Terlaky, Math. Program. 95,
/// 2003.) w is linear in u, so that the geometry of the members limits no step. Drag, whose law is none of a
/// convex problem, is linearised at every step like all of r; D [N], zero at first, grows where that leaves
/// steps short (Levenberg's damping).
///
/// Where no force is unsymmetric, members bear a little in compression, too, so that slack ones come to rest
/// where that leaves them instead of anywhere; EA in (1) to (4) is what is beyond it:
///   p = E_c (l/l₀ − 1) t,  E_c the least of EA_c, EA/2 and the bound of set_compression                (7)
///   ∂p/∂w = E_c/l₀ [t tᵀ + a (I − t tᵀ)],  a = 1 − l₀/l, or where that makes (3) indefinite max(0, a) (8)
/// (7) is not convex: of several shapes in balance the method ends at one. Where compression decides which,
/// μ must not fall ahead of the residual of (1): (5) then aims at no less than a multiple of it. A μ in the
/// tension T of a member is worth EA μ/T by its own law, which a solver meets that goes on from here: the
/// method waits for that to become small, too.
class InteriorPoint {
 public:
  /// All that steers the method; plugin.cpp says what each is and where it comes from.
  struct Parameters {
    std::int64_t iterations = 0;
    double mu = 0, forces = 0, law = 0, near = 0;                    // over the load
    double room = 0, to_boundary = 0;                                // of z₀ at the start; (6)
    double short_step = 0, long_step = 0, tiny_step = 0;             // a of (6)
    double damping_factor = 0, least_damping = 0, most_damping = 0;  // of D; over the load
    double most_compression = 0, little_compression = 0;             // bounds of E_c over the load
    double deciding_compression = 0, centrality = 0;
  };

  enum class Ending { converged, called_off, no_forces, no_factor, no_step, tiny_steps };

  InteriorPoint(const Parameters& parameters, netloft_members& members);

  /// From u to where it ends. `load` is the first μ [N]: what drives the gear, all in all.
  Ending solve(std::span<double> u, double load);

  /// Whether a solver may start from where the last solve ended: little is left, converged or not.
  bool is_near() const;
  double largest_residual() const { return largest_of({residual_.data(), members_.unknowns()}); }
  double mu() const { return mu_; }

 private:
  struct State {
    double z0;  // the rest of z is w/l₀
    cone::Point y;
    cone::Point dz{}, dy{};  // the step
  };

  void begin(std::span<const double> u);
  void set_compression();
  double mean_compression_stiffness() const;
  double EA(std::size_t e) const { return members_[e].EA - E_c(e); }
  double E_c(std::size_t e) const;
  cone::Point z_of(std::size_t e) const;
  double strain(std::size_t e) const { return std::sqrt(dot(w_[e], w_[e])) / members_[e].rest_length - 1; }
  bool has_converged() const;
  double largest_law_error() const;
  double mean_complementarity() const;

  bool evaluate(std::span<const double> u);
  void set_members();
  void set_member(std::size_t e);
  void add_compression(std::size_t e);
  bool factorise();
  void make_convex();

  double find_step();
  void predict();
  void correct(double mu);
  void solve_for_step();
  void set_step(std::size_t e);
  double zeta(std::size_t e, double g0, double along) const;
  double longest_step() const;
  void take(double a, std::span<double> u);
  void adapt_damping(double a);

  Parameters p_;
  Members members_;
  double load_ = 0;  // [N]
  std::vector<State> states_;
  std::vector<cone::Scaling> scaling_;
  std::vector<cone::Point> g_;
  std::vector<Block> blocks_;
  std::vector<Vector> w_, forces_, changes_;
  std::vector<double> rest_, residual_, rhs_, step_;
  double mu_ = 0, damping_ = 0;                // [N]
  double most_compression_ = 0, central_ = 0;  // bound of E_c [N]; least σ μ over the largest residual
  bool is_convex_ = false;                     // (8) with max(0, a), in this iteration
  bool is_indefinite_ = false;                 // (3) even so, because of r
  bool has_forces_ = false;                    // residual_ and mu_ belong to u
};

}  // namespace netloft::tension
