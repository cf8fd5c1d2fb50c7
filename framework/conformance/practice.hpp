// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/solver.h>

#include <cstdint>
#include <string>
#include <vector>

namespace netloft::conformance {

/// Properties of a practice problem: a chain of springs, whose solution is known, and additional forces.
struct Practice {
  double stiffness = 100;  // stiffness k of every spring [N/m]
  double load = 1;         // force f on every mass [N]
  double stiffening = 0;   // stiffening c of (1) [N/m³]
  double wall = 0;         // position at which the energy is infinite, for every mass [m]; 0: none
  double swirl = 0;        // s in the force s (u_{i+1} − u_{i−1}), which has no potential [N/m]
  double grip = 0;         // S [N/m], stiffness of every mass near one position only
  double runaway = 0;      // length l [m] in the load f (1 + u²/l²); 0: the load is constant
  double buckling = 0;  // h [N/m]; the last unknown is a deflection v of a column that buckles, without mass
  bool no_factor = false;      // no matrix can be factorised
  bool no_number = false;      // every evaluation away from the start overflows
  int interrupted_after = -1;  // iterations before the user interrupts; -1: never
  std::uint32_t unknowns = 12;
};

/// A problem with a known solution, behind the same functions as a scene:
///   E(u) = Σ k/2 e² + c/4 e⁴ − Σ f u − b Σ log(1 − u/w),  e = u_i − u_{i−1},  u_0 = 0     (1)
///        + Σ F²/S γ(S (u − a)/F) − Σ f u³/(3 l²) − h/2 v² + q/4 v⁴,  γ(x) = x atan x − log(1 + x²)/2
///   r = ∂E/∂u + s (u_{i+1} − u_{i−1})                                                    (2)
/// b = 0.1 J, F = 100 N, q = 100 h/m²; w is the wall, and the other symbols are members of Practice. For the
/// mass at the fraction x of the chain, a = R (2 x − x²) + d with R = 0.72 m is the equilibrium of the
/// springs alone plus d = 25 mm. Without runaway and buckling, the energy is convex and has one minimum. The
/// metric is the stiffness k of the chain. Calls are counted as for a scene.
class PracticeProblem {
 public:
  explicit PracticeProblem(const Practice& like);

  netloft_problem& interface() { return interface_; }
  std::uint32_t size() const { return n_; }
  /// Largest residual at u relative to the load; infinite outside the wall.
  double imbalance(const std::vector<double>& u) const;
  const std::vector<double>& u() const { return u_; }
  double load() const { return like_.load; }
  double energy(const double* u) const;
  /// Whether a small deflection v grows: h − 3 q v² > 0. All other stationary points of (1) are stable.
  bool is_unstable(const double* u) const;
  bool told_to_stop() const { return stopped_; }

  int iterations = 0, evaluations = 0, factorisations = 0;
  int evaluations_after_stop = 0;  // calls of `evaluate` after `progress` ended the iteration
  double worst_report = 0;         // largest error of a residual passed to `progress`, relative to the load
  std::vector<double> reported;    // the last point passed to `progress`

 private:
  using Matrix = std::vector<double>;  // n x n, row by row
  std::vector<double> residual(const double* u, bool gradient_only) const;
  Matrix tangent(const double* u) const;
  Matrix shifted(int matrix, double shift) const;
  bool is_inside(const double* u) const;
  double energy_of_mass(std::uint32_t i, double u) const;
  double force_on_mass(std::uint32_t i, double u) const;
  double stiffness_of_mass(std::uint32_t i, double u) const;
  double gripped(std::uint32_t i, double u) const;
  double stretch(const double* u, std::uint32_t i) const { return i ? u[i] - u[i - 1] : u[0]; }

  int evaluate(std::uint32_t want, const double* u, double* energy, double* residual);
  int evaluate_both(const double* u, double* energy, double* residual, double* gradient);
  int factorise(int matrix, double shift);
  int factorise_between(double blend, double shift);
  int solve(const double* rhs, double* x) const;
  int multiply(int matrix, double shift, const double* x, double* y) const;
  int row_sums(int matrix, double shift, double* y) const;
  int progress(const double* u, const double* residual);

  template <auto Member, class... Args>
  static int call(void* host, Args... args) {
    return (static_cast<PracticeProblem*>(host)->*Member)(args...);
  }

  Practice like_;
  std::uint32_t n_, masses_;
  netloft_problem interface_{};
  std::vector<double> u_;
  Matrix matrix_, metric_, factor_;  // tangent of the last evaluation; linear stiffness; last factor
  std::uint32_t kept_ = 0;           // union of all `want` of the evaluations so far
  bool stopped_ = false;
  char message_[256] = "";
};

}  // namespace netloft::conformance
