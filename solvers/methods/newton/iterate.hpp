// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>
#include <netloft/vectors.hpp>

#include <optional>
#include <span>
#include <vector>

#include "solvers/adapters/common/round_off.hpp"
#include "solvers/methods/newton/line_search.hpp"
#include "solvers/methods/newton/newton.hpp"

namespace netloft::newton {

/// The options of all searches along a line.
inline Refinement refinement_of(const Newton::Parameters& p) {
  return {.margin = p.margin, .most = static_cast<int>(p.refinements)};
}

/// The path u(t) = u + t s + ½ t² a. It is straight if `a` is empty.
struct Path {
  std::span<const double> s, a = {};
};

/// The point u of the iteration, with the residual r, the energy E, and the forces d that have no potential
/// (such as drag); and a trial point on a path that begins at u.
class Iterate {
 public:
  explicit Iterate(Problem& problem);

  Problem& problem() { return problem_; }
  std::size_t size() const { return r_.size(); }
  double energy() const { return energy_; }
  std::span<const double> residual() const { return r_; }
  /// Whether all forces have a potential, so that d = 0.
  bool is_conservative() const { return d_.empty(); }
  double slope(const Path& path) const { return dot(r_, path.s); }
  /// The rounding error of the merit along a path [J].
  double round_off(const Path& path) const;
  /// Whether the decrease that the slope predicts for a step along a path is at most the rounding error
  /// round_off(path).
  bool promises_round_off(const Path& path) const;
  std::size_t count() const { return count_; }

  /// Evaluates at u and stores the tangent if `matrix` requests it. Returns false if forces are undefined
  /// there.
  bool evaluate(Matrix matrix = Matrix::exact);
  /// Computes the forces without a potential at u, which the merit needs: d = r − g, with the gradient g of
  /// the energy E.
  bool split_residual();
  bool report(const char* note) { return problem_.progress(problem_.u(), energy_, r_, note); }

  /// Computes s = −A⁻¹ r, where A is the matrix that was factorised last.
  void solve(std::span<double> s);
  /// Returns r at u(t), or nullopt if forces are undefined there.
  std::optional<std::span<const double>> residual_at(const Path& path, double t);
  /// Returns the merit m(t), (3) of newton.hpp, and its derivative; call split_residual() first. Forces at
  /// the last trial point are kept, so that another call for this point, or a step to it, does not evaluate
  /// them again.
  std::optional<Sample> merit(const Path& path, double t);
  /// Moves u to u(t) and evaluates the tangent there. If forces are undefined at u(t), returns false and
  /// leaves u and the tangent unchanged.
  bool try_move(const Path& path, double t);
  /// Moves u like try_move, but only if ‖r‖ does not rise.
  bool try_move_if_residual_below(const Path& path, double t);

 private:
  /// The forces that have been evaluated at the trial point.
  enum class Known { nothing, residual, gradient_too };

  bool move_trial(const Path& path, double t);
  bool evaluate_trial(const Path& path, double t, Known wanted);
  bool keep_tangent_of_trial(const Path& path, double t);
  void accept_trial();
  void find_nonconservative(std::span<const double> gradient);

  Problem& problem_;
  double energy_ = 0, energy_trial_ = 0;
  std::size_t count_ = 0;
  std::vector<double> r_, trial_, r_trial_, gradient_;
  std::vector<double> d_;  // d and the gradient are empty if all forces have an energy
  bool is_split_ = false;  // whether d_ belongs to u
  Known known_ = Known::nothing;
};

}  // namespace netloft::newton
