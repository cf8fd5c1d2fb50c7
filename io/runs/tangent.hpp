// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/static_problem.hpp"
#include "io/runs/prepared_scene.hpp"

#include <optional>
#include <vector>

namespace netloft::runs {

/// Whether displacements of scene `a` are valid for scene `b`: both have the same unknowns in the same order.
bool have_same_topology(const PreparedScene& a, const PreparedScene& b);

/// Positions x + x_low of all degrees of freedom. x_low has the digits that rounding removes from x [m].
struct ExactPlace {
  std::vector<double> x, x_low;
};
/// Moves a place by `times` dx; the x_low of `from` may be empty. If two places are moved from the same
/// place, their difference has all digits of dx.
ExactPlace moved(const ExactPlace& from, const std::vector<double>& dx, double times);

/// First-order changes of the equilibrium x of a scene when its values change a little. From the scene
/// `before` to the scene `after`, which have slightly different values and the same topology,
///   K(x) dx = −(r_after(x) − r_before(x))                                                (1)
/// where r are residuals and K is the exact tangent of the scene at x. K is factorised once, at the first
/// change. All scenes must outlive this object.
class Tangent {
 public:
  Tangent(PreparedScene& scene, std::vector<double> x);

  /// The change from the scene itself to `near`, over all degrees of freedom, including held ones. nullopt if
  /// K cannot be factorised, if x cannot be evaluated in one of the two scenes, or if the scene leaves
  /// quantities to the search (Scene::settings), because these would have to change as well.
  std::optional<std::vector<double>> towards(PreparedScene& near);
  /// The change between the scenes `before` and `after`. The scene itself is between them, at the fraction 1
  /// − θ of the way from `before`. If lengths of a stiff member differ, it may be slack in one of the scenes,
  /// which makes (1) inaccurate. Further steps remove this error and rounding errors:
  ///   K ddx = −(r_after(x + θ dx) − r_before(x + (θ − 1) dx))                             (2)
  /// nullopt as for towards().
  std::optional<std::vector<double>> between(PreparedScene& before, PreparedScene& after, double theta);
  /// The positions at which the scene `near` is in equilibrium, with an error of second order. They are
  /// y − K⁻¹ r_near(y), one step with K from positions y that are already close to this equilibrium. nullopt
  /// as for towards().
  std::optional<std::vector<double>> corrected(PreparedScene& near, const std::vector<double>& y);

  /// The displacements K⁻¹ b by which forces −b on the unknowns [N] move them, to first order. nullopt if K
  /// cannot be factorised.
  std::optional<std::vector<double>> solved(const std::vector<double>& b);
  /// The adjoint variables λ of a number g at the equilibrium, for w = ∂g/∂u, the derivatives of g with
  /// respect to the unknowns:
  ///   Kᵀ λ = w                                                                              (5)
  /// λ is the change of g per force on each unknown, with the opposite sign. With (1), the change of g from
  /// the scene `before` to the scene `after` is
  ///   dg = g_after(x) − g_before(x) − λ·(r_after(x) − r_before(x))                          (6)
  /// for any number of changes with one solve. nullopt if K cannot be factorised.
  std::optional<std::vector<double>> adjoint(const std::vector<double>& w);

  /// Relative growth of the change dx = between(before, after, theta) from one such change to the next, if dx
  /// is about to diverge at a fold; 0 if it is not. If the stiffness alone changes along dx, (1) has the
  /// second derivative
  ///   K d²x = −dK dx,   growth = dx·d²x / dx·dx                                            (3)
  /// Near a fold, where K has the null vector φ, every dx is parallel to φ and grows with the distance s to
  /// the fold as s^−½, in units of the change. Then d²x is parallel to dx, too, and
  ///   growth = 1/2s                                                                         (4)
  /// s < 0 means that the fold is on the way from `after` to `before`. If d²x is more across dx than along
  /// dx, in the sum of squares over the unknowns, there is no fold. dK is the difference between K at x and K
  /// a fraction of the change away. This is computed on both sides, and the side with the smaller dK dx
  /// counts, because a member may become slack on the other side. nullopt as for towards().
  std::optional<double> growth(PreparedScene& before, PreparedScene& after, double theta,
                               const std::vector<double>& dx);

  /// The cost of all changes.
  Statistics spent() const;

 private:
  struct Point {
    std::vector<double> x, residual;  // over all degrees of freedom
  };
  struct Step {
    PreparedScene& after;
    Point a, b;              // x in the scenes before and after
    std::vector<double> du;  // of the unknowns
    std::vector<double> motion(const std::vector<double>& du) const;
  };
  std::optional<Step> first_step(PreparedScene& before, PreparedScene& after);
  std::optional<std::vector<double>> residual_at(PreparedScene& scene, const ExactPlace& place);
  std::optional<Point> evaluate(PreparedScene& scene, const std::vector<double>& x);
  bool is_defined() const;
  std::optional<std::vector<double>> stiffness_change(PreparedScene& near, double fraction,
                                                      const std::vector<double>& dx,
                                                      const std::vector<double>& du);
  bool has_factor();
  bool solve(std::vector<double> imbalance, std::vector<double>& du);
  std::optional<std::vector<double>> refined(const std::vector<double>& rhs, bool transposed);

  PreparedScene& scene_;
  std::vector<double> x_, u_;
  StaticProblem problem_;
  Statistics spent_;  // cost of the residuals in other scenes
  enum class Factor { none, ready, failed } factor_ = Factor::none;
};

}  // namespace netloft::runs
