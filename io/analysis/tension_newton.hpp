// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/verdict.hpp"
#include "io/analysis/member_net.hpp"

namespace netloft::io {

/// One solve of a scene with its members as stiff as `share` says.
struct TensionStage {
  std::string name;
  std::vector<double> share;   // of the members' stiffness, by part; at most 1
  bool from_afar = false;      // tensions follow positions, and D begins large
  double damping = 1e-5;       // first share of the stiffness in D
  double farthest_turn = 0.3;  // of any member in one step [rad]
  double settled_turn = 0;     // done when no taut member turns more in a whole step; 0: not asked
  double tolerance = 1e-9;     // else when no residual exceeds so much of the largest reaction
  int iterations = 60;
  double seconds = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* interrupt = nullptr;
};

/// Newton's method with the tension of every member as an unknown of its own: a point is positions u and
/// tensions T that need not belong to one another until the end.
///   r(u) + Σ n c T t = 0,  T = k ε(u),  k = EA where T > 0, else EA_c                              (1)
/// with r all other forces, linearised in u and T together, T eliminated:
///   (∂r/∂u + Σ n c cᵀ [k/l₀ t tᵀ + T/l (I − t tᵀ)] + D) s = −(r + Σ n c k ε(u) t)                   (2)
///   T ← T + a (k (ε + t·Σ c s / l₀) − T),  u ← u + a s                                             (3)
/// Newton's own matrix has k ε(u) in the place of T. After a step in which a stiff bar turns by θ, that is
/// too large by k θ²/2, and it holds the bar where it is until the next step has taken it back: the stiffer
/// the bar, the shorter the steps. T of (3) knows of no such stretch. After D. Magisano, L. Leonetti, G.
/// Garcea, "How to improve efficiency and robustness of the Newton method in geometrically non-linear
/// structural problem discretized via displacement-based finite elements", Comput. Methods Appl. Mech. Eng.
/// 313 (2017). Where it deviates:
/// - a < 1 where a member would turn by more than `farthest_turn`; no energy is searched;
/// - D = μ Σ n c cᵀ EA/l₀ I, the linear stiffness, holds what is slack; μ falls with every whole step;
/// - far from an equilibrium T = k ε(u) instead of (3), and μ follows the residual (solvers/ptc, (2)).
class TensionNewton {
 public:
  /// Bodies and frames of its own make std::invalid_argument.
  TensionNewton(const Scene& scene, Registry& registry, MakeFactorisation make, int threads);

  /// Goes on from where the last stage ended.
  Leg solve(const TensionStage& stage);

  /// Largest tension or pressure of the members of each part [N].
  std::vector<double> tensions_by_part() const;
  /// Stiffness of the members of each part [N]; zero where there are none.
  const std::vector<double>& stiffness_by_part() const { return stiffness_; }
  /// Positions of the nodes of the scene, 3 each [m].
  std::vector<double> positions() const { return net_.positions(); }

 private:
  void set_laws();
  /// k of (1).
  double stiffness_now(std::size_t e) const {
    return tension_[e] > 0 ? laws_[e].EA : laws_[e].EA_compression;
  }
  /// What the law of the member has at a strain.
  double own_tension(std::size_t e, double strain) const {
    return (strain > 0 ? laws_[e].EA : laws_[e].EA_compression) * strain;
  }
  void follow_positions();
  bool find_rest();
  bool find_residual();
  bool assemble();
  void set_tangents();
  bool is_balanced(double tolerance) const;
  bool find_step();
  /// Of any member in the whole step [rad].
  struct Turns {
    double of_all, of_taut;
  };
  Turns largest_turns() const;
  void take(double a, bool from_afar);
  void adapt(double a);

  MemberNet net_;
  std::unique_ptr<Factorisation> factorisation_;
  std::vector<MemberNet::Vector> changes_;  // Σ c s, by the whole step
  std::vector<MemberNet::Vector> forces_;   // along the members [N]
  std::vector<MemberTangent> tangents_;
  struct Law {
    double EA, EA_compression, inverse;
  };
  std::vector<Law> laws_;                  // of this stage, by member [N], and 1/l₀ [1/m]
  std::vector<double> stiffness_, share_;  // by part
  std::vector<double> tension_, mixed_, residual_, values_, step_;
  double damping_ = 0;
  bool knows_rest_ = false;  // mixed_ and values_ are those of all other forces, here
  Books books_;
};

}  // namespace netloft::io
