// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/sweep/study.hpp"

#include <memory>

namespace netloft::studies {

/// An equilibrium of a study: a scene that has been solved, and the values of the variables in its path.
struct Solved {
  std::shared_ptr<runs::PreparedScene> scene;
  Solution solution;
  std::vector<VariableValue> values;
};

/// The next equilibrium, and how it was found.
struct Reached {
  Solution solution;                // its cost includes all intermediate solves
  bool was_continued = false;       // false: found by a new search
  std::vector<std::string> events;  // folds and jumps, as sentences
};

struct BranchOptions {
  int iterations = 12;  // most iterations of a step, before it is halved
  int halvings = 5;     // most halvings of a step, before the branch counts as ended
  // The fraction of a step over which residuals are differenced for a tangent. A larger one overshoots the
  // bed, which yields by millimetres, a smaller one loses digits to rounding: on four gears 2^-16 to 2^-20
  // need the fewest factorisations, and the 83-112 at sea needs two to five times as many with 2^-12 and
  // 2^-28.
  double little = 0x1p-20;
  // Limit if there are no two places to extrapolate from: a step with more iterations may have jumped, and is
  // checked. Steps of the 83-112 with 600 and 1000 nodes took 1 to 4.
  int few_iterations = 4;
  // fraction of the gear's size: a smaller move is no event, such as a twine that becomes slack
  double noticed = 1e-3;
};

/// Follows an equilibrium while the variables of a path change. The solver of the scene starts from a
/// prediction: the extrapolation of the last two equilibria if the next point is on a line with both, else
/// the tangent (runs::tangent_towards; E. L. Allgower, K. Georg, Introduction to numerical continuation
/// methods, 2003, ch. 2). If the solver fails, the step is halved; if it succeeds, the step is doubled again.
/// After `halvings` the strategy of the scene searches anew.
///
/// At a fold the branch ends: the smallest step fails, and the new search finds an equilibrium elsewhere,
/// more than four times as far as the extrapolated change. At a jump the solver converges to another branch.
/// After k halvings a step along a smooth branch changes about 2^-k of the whole, while a jump keeps its
/// size: a remainder of more than a quarter after `halvings` is a jump. Both are reported with the values on
/// either side and the node that moves most.
class Branch {
 public:
  /// Makes and opens the scene of the path at some values; null if the scene cannot be read.
  using OpenCase = std::function<std::shared_ptr<runs::PreparedScene>(const std::vector<VariableValue>&)>;

  Branch(std::vector<Variable> variables, OpenCase open, const runs::Watch& watch, BranchOptions options = {})
      : variables_(std::move(variables)), open_(std::move(open)), watch_(watch), options_(options) {}

  /// Finds the equilibrium of a scene in state `ready` at these values. If it is stable, the branch continues
  /// from it; otherwise the next point is searched for anew.
  Reached reach(std::shared_ptr<runs::PreparedScene> scene, const std::vector<VariableValue>& values);

 private:
  /// A solved point at a fraction of the step from the last point (0) to the next (1); negative: points
  /// before the last.
  struct Place {
    double at = 0;
    Solved solved;
  };
  using Way = std::vector<Place>;

  Way known_places(const std::vector<VariableValue>& values);
  Way tangent_way(const Solved& from, const std::vector<VariableValue>& to);
  bool walk(const std::shared_ptr<runs::PreparedScene>& scene, const std::vector<VariableValue>& values,
            Way& way);
  static std::vector<double> led_on(const Way& way, double at);
  Solution step(runs::PreparedScene& scene, const Way& way, double at);
  bool may_have_jumped(const Way& way, std::size_t place) const;
  bool is_noticed(double distance, const runs::PreparedScene& of) const;
  std::shared_ptr<runs::PreparedScene> open_between(const Solved& from, const std::vector<VariableValue>& to,
                                                    double t, std::vector<VariableValue>& values) const;
  void look_for_jump(Solved from, Solved to, std::vector<std::string>& events);
  void look_for_fold(const Way& way, const Solved& anew, std::vector<std::string>& events) const;
  std::string spell(const std::vector<VariableValue>& values, const std::vector<VariableValue>& other) const;

  std::vector<Variable> variables_;  // the variables in the path
  OpenCase open_;
  const runs::Watch& watch_;
  BranchOptions options_;
  std::vector<Solved> trail_;  // the last two equilibria, the newest last
  Cost spent_;                 // cost of the step to the next equilibrium
};

}  // namespace netloft::studies
