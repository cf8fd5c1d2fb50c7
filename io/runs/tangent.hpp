// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/static_problem.hpp"
#include "io/runs/prepared_scene.hpp"

#include <optional>
#include <vector>

namespace netloft::runs {

/// Whether displacements of scene `a` are valid for scene `b`: both have the same unknowns in the same order.
bool have_same_topology(const PreparedScene& a, const PreparedScene& b);

/// First-order changes of the equilibrium x of a scene when its values change a little. From the scene
/// `before` to the scene `after`, which have slightly different values and the same topology,
///   K(x) dx = −(r_after(x) − r_before(x))                                                (1)
/// where r are residuals and K is the exact tangent of the scene at x. K is factorised once, at the first
/// change. All scenes must outlive this object.
class Tangent {
 public:
  Tangent(PreparedScene& scene, std::vector<double> x);

  /// dx over all degrees of freedom, the held ones included. nullopt if K cannot be factorised, or if x
  /// cannot be evaluated in one of the scenes. nullopt also if the scene leaves quantities to the search
  /// (Scene::settings), because these would have to change as well.
  std::optional<std::vector<double>> between(PreparedScene& before, PreparedScene& after);
  /// The change from the scene itself to `near`.
  std::optional<std::vector<double>> towards(PreparedScene& near) { return between(scene_, near); }
  /// The positions at which the scene `near` is in equilibrium, to second order: one step with K from
  /// positions y near its equilibrium, y − K⁻¹ r_near(y). nullopt as for between().
  std::optional<std::vector<double>> corrected(PreparedScene& near, const std::vector<double>& y);

  /// The cost of all changes.
  Statistics spent() const;

 private:
  struct Point {
    std::vector<double> x, residual;  // over all degrees of freedom
  };
  std::optional<Point> evaluate(PreparedScene& scene, const std::vector<double>& x);
  bool is_defined() const;
  bool solve(std::vector<double> imbalance, std::vector<double>& du);

  PreparedScene& scene_;
  std::vector<double> x_, u_;
  StaticProblem problem_;
  Statistics spent_;  // cost of the residuals in other scenes
  enum class Factor { none, ready, failed } factor_ = Factor::none;
};

}  // namespace netloft::runs
