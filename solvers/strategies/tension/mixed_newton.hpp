// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/members.hpp"

namespace netloft::tension {

/// Newton's method with the tension of every member as an additional unknown: a point consists of positions u
/// and tensions T, which need not be consistent before convergence.
///   r(u) + Σ n c T t = 0,  T = k ε(u),  k = EA where T > 0, else EA_c                              (1)
/// A member has the unit vector t, length l, unstretched length l₀, strain ε, stiffness EA in tension and
/// EA_c in compression, and the number n and coefficients c of netloft_member; r are all other forces. With T
/// eliminated, a step s of length a is
///   (∂r/∂u + Σ n c cᵀ [k/l₀ t tᵀ + T/l (I − t tᵀ)] + D) s = −(r + Σ n c k ε(u) t)                   (2)
///   T ← T + a (k (ε + t·Σ c s / l₀) − T),  u ← u + a s                                             (3)
/// The standard Newton matrix has k ε(u) instead of T. After a step in which a stiff bar turns by θ, k ε(u)
/// is too large by k θ²/2 and prevents further rotation until the next step has removed the stretch: the
/// stiffer the bar, the shorter the steps. T of (3) does not contain that stretch. After D. Magisano, L.
/// Leonetti, G. Garcea, "How to improve efficiency and robustness of the Newton method in geometrically
/// non-linear structural problem discretized via displacement-based finite elements", Comput. Methods Appl.
/// Mech. Eng. 313 (2017). Deviations from that method:
/// - a < 1 if a member would turn by more than `farthest_turn`; there is no line search;
/// - D = μ Σ n c cᵀ EA/l₀ I, the linear stiffness, holds slack members; μ falls after a whole step
///   and becomes μ/(2a) after a shorter one;
/// - far from an equilibrium T = k ε(u) instead of (3), and μ follows the residual (W. A. Mulder
///   and B. van Leer, J. Comput. Phys. 59 (1985) 232-246).
class MixedNewton {
 public:
  /// Largest μ. With this μ, D is as stiff as all members together; a larger μ would only shorten steps.
  static constexpr double kMostDamping = 1;

  /// The options of all stages, which strategies.cpp explains.
  struct Parameters {
    double factor = 0;  // factor by which μ falls and rises
  };

  /// The task of one solve. The stiffness of parts may be reduced.
  struct Stage {
    const char* name = "";
    std::vector<double> factor;  // factor on EA and EA_c of each part, at most 1
    bool is_far = false;         // whether T = k ε(u), and μ follows the residual
    double damping = 0;          // damping factor μ at the start of the stage
    double farthest_turn = 0;    // limit of the rotation of a member in one step [rad]
    bool is_between = false;     // true: the stage ends after its first whole step, without a tolerance
    double tolerance = 0;        // largest residual over largest reaction at the end
    std::int64_t iterations = 0;
  };

  enum class Ending { converged, out_of_iterations, called_off, no_forces };

  MixedNewton(const Parameters& parameters, netloft_members& members);

  /// Solves from u, which it changes, starting with the final tensions of the last stage.
  Ending solve(const Stage& stage, std::span<double> u);

  /// Largest tension or compression in the members of each part [N].
  std::vector<double> tensions_by_part() const;
  /// Stiffness of the members of each part [N]; zero where there are none.
  std::vector<double> stiffness_by_part() const;

 private:
  struct Law {
    double EA, EA_compression, inverse_l0;
  };
  struct Geometry {
    Vector t;
    double inverse_l, strain;
  };
  void begin(const Stage& stage, std::span<const double> u);
  void update_geometry(std::span<const double> u);
  void follow_positions();
  double stiffness(std::size_t e) const {  // stiffness k of (1)
    return T_[e] > 0 ? laws_[e].EA : laws_[e].EA_compression;
  }
  double tension_at(std::size_t e, double strain) const {
    return (strain > 0 ? laws_[e].EA : laws_[e].EA_compression) * strain;
  }
  bool find_rest(std::span<const double> u);
  bool has_converged(const Stage& stage);
  bool find_residual();
  bool is_balanced(double tolerance) const;
  bool assemble();
  void follow_residual();
  bool find_step();
  double largest_turn() const;
  void take(const Stage& stage, std::span<double> u);
  void move_tensions(double a);
  void adapt_damping(double a);
  void set_damping(double damping);

  Parameters p_;
  Members members_;
  std::vector<Law> laws_;
  std::vector<Geometry> geometry_;
  std::vector<Vector> w_, changes_, forces_;
  std::vector<Line> lines_;
  std::vector<double> T_;  // tension of each member; empty before the first stage
  std::vector<double> rest_, residual_, mixed_, step_;  // r; residual of (1); right-hand side of (2); s
  double damping_ = 0;                                  // factor μ of the damping D
  double norm_ = 0;                                     // norm of the last residual
  bool took_whole_step_ = false;
  bool knows_rest_ = false;  // whether rest_ and its tangent belong to u
};

}  // namespace netloft::tension
