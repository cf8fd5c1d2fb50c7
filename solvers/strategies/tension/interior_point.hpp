// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/members.hpp"
#include "solvers/strategies/tension/second_order_cone.hpp"

namespace netloft::tension {

/// Equilibrium of members that bear tension only, by an interior-point method. Two complementary points z and
/// y of the second-order cone K (z ∘ y = 0, second_order_cone.hpp) state whether a member is slack or taut.
/// Solving for z, y and the positions u together means that no step has to guess which members are slack. A
/// member has tension T, stiffness EA, unstretched length l₀, chord w, direction t, force vector q, and the
/// number n and coefficients c of netloft_member; r are all other forces:
///   r(u) + Σ n c q = 0,  z = (1 + T/EA, w/l₀) ∈ K,  y = (T, −q) ∈ K                         (1)
///   z ∘ y = μ e,  μ → 0                                                                     (2)
/// At μ = 0, either T = 0 and the member may have any shorter length, or w has the length l₀ (1 + T/EA) and q
/// = T t. Under dead loads, (1) and (2) at μ = 0 are the conditions of optimality of a convex problem, all
/// solutions of which have the same energy (Y. Kanno, M. Ohsaki, J. Ito, Int. J. Numer. Methods Eng. 55,
/// 2002). Newton's step for (1) and (2) is scaled by W (W z = W⁻¹ y, H = W²), and T, q and z₀ are eliminated
/// member by member; h = (H₁₀, H₂₀, H₃₀), H̄ is the other 3 × 3 block of H, ḡ the last three numbers of g:
///   (∂r/∂u + Σ n c cᵀ/l₀ [H̄ − h hᵀ/(EA + H₀₀)]) s = −(r + Σ n c [q − ḡ + h ζ])               (3)
///   ζ = (EA (1 − z₀) + T + g₀)/(EA + H₀₀)                                                   (4)
///   g = −y for a trial step, which reaches the boundary of K at the length a₀; then, with the same matrix,
///   g = W (v \ (σ μ e − v∘v − W δz ∘ W⁻¹ δy)),  v = W z,  σ = (1 − a₀)³,  v \ x solves v ∘ y = x   (5)
///   a = `to_boundary` of the way to the boundary of K, at most a whole step                 (6)
///   g = W (v \ (μ e − v∘v)): a step towards the centre, z ∘ y = μ e                          (7)
/// (Mehrotra's predictor and corrector for cones: E. D. Andersen, C. Roos, T. Terlaky, Math. Program. 95,
/// 2003.) Because w is linear in u, the geometry of members does not limit the length of a step. A point at
/// which some member is much nearer to the boundary of K than others allows short steps only; if (5) allows
/// less than 1 − `to_boundary` of its step, (7) takes its place. Drag does not fit into a convex problem; it
/// is linearised at every step, like all of r. The method fails if (7) allows no more. It has converged if μ
/// and the residual are less than 2⁻²⁶ of the load, half of the digits of a double; Newton's method finds the
/// other digits in one step. The resistance of members to compression is neglected.
class InteriorPoint {
 public:
  /// The options, which strategies.cpp explains.
  struct Parameters {
    double to_boundary = 0;  // (6)
    double least_slack = 0;  // slack_fraction() below which the strategy declines
    /// A step leaves this fraction of the way to the boundary of K. A taut member starts with z₀ − ‖z̄‖ equal
    /// to it.
    double room() const { return 1 - to_boundary; }
  };

  enum class Ending { converged, called_off, no_forces, no_factor, no_step };

  InteriorPoint(const Parameters& parameters, netloft_members& members);

  /// Solves from u, which it changes. `load` [N], the sum of the forces that drive the gear, is the first μ.
  Ending solve(std::span<double> u, double load);

  /// Fraction of the length of all members that is slack at u.
  double slack_fraction(std::span<const double> u);

  double largest_residual() const { return largest_of({residual_.data(), members_.unknowns()}); }
  double mu() const { return mu_; }
  /// Whether μ and the residual are at most this fraction of the load.
  bool is_within(double fraction) const;

 private:
  enum class SecondOrder { no, yes };
  struct State {
    double z0;  // first coordinate of z; the others are w/l₀
    cone::Point y;
    cone::Point dz{}, dy{};  // step of z and y
  };

  void begin(std::span<const double> u);
  double EA(std::size_t e) const { return members_[e].EA; }
  cone::Point z_of(std::size_t e) const;
  double strain(std::size_t e) const { return std::sqrt(dot(w_[e], w_[e])) / members_[e].rest_length - 1; }
  double mean_complementarity() const;

  bool evaluate(std::span<const double> u);
  void set_members();
  void set_member(std::size_t e);
  bool factorise();

  double find_step();
  void predict();
  void correct(double mu, SecondOrder second_order);
  double length_of_step() const;
  void solve_for_step();
  void set_step(std::size_t e);
  double zeta(std::size_t e, double g0, double along) const;
  double longest_step() const;
  void take(double a, std::span<double> u);

  Parameters p_;
  Members members_;
  double load_ = 0;  // [N]
  std::vector<State> states_;
  std::vector<cone::Scaling> scaling_;
  std::vector<cone::Point> g_;
  std::vector<Block> blocks_;
  std::vector<Vector> w_, forces_, changes_;
  std::vector<double> rest_, residual_, rhs_, step_;
  double mu_ = 0;               // [N]
  bool is_indefinite_ = false;  // whether r has made the matrix of (3) indefinite
};

}  // namespace netloft::tension
