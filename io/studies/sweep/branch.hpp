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

/// How the next equilibrium was reached.
struct Reached {
  Solution solution;                // its cost is that of all that was solved on the way
  bool was_continued = false;       // else it was found anew
  std::vector<std::string> events;  // folds and jumps, as sentences
};

struct BranchOptions {
  int iterations = 12;  // of one step, before it is halved
  int halvings = 5;     // of a step, before the branch is said to end
  // The part of a step over which residuals are differenced for a tangent. More loses the bed, which yields
  // by millimetres, less is lost in rounding: on four gears 2^-16 to 2^-20 take the fewest factorisations,
  // and the 83-112 at sea two to five times as many with 2^-12 and 2^-28.
  double little = 0x1p-20;
  // Limit without two places to extrapolate: a step with more iterations may have jumped, and is checked.
  // Steps of the 83-112 with 600 and 1000 nodes took 1 to 4.
  int few_iterations = 4;
  double noticed = 1e-3;  // of the gear's size: what moves less is no event, such as a twine that goes slack
};

/// Follows an equilibrium while the variables of a path change. From the last equilibrium, led on from the
/// one before where the next point lies on a line with both, and else along the tangent
/// (runs::tangent_towards; E. L. Allgower, K. Georg, Introduction to numerical continuation methods, 2003,
/// ch. 2), the solver of the scene finds the next. Where it does not, the step is halved, and doubled again
/// where it does; after `halvings` the equilibrium is found anew by the strategy of the scene.
///
/// A fold is where the branch ends: the smallest step does not lead on, and what is found anew is elsewhere,
/// more than four times as far as the way so far would lead. A jump is where the solver leads to another
/// branch. After k halvings a step along a smooth branch is about 2^-k of the whole, while a jump stays as it
/// is: more than a quarter of the whole that is left after `halvings` is one. Both are reported with the
/// values between which they lie and the node that moves most.
class Branch {
 public:
  /// Makes the scene of the path at some values and opens it; null if it is not ready.
  using OpenCase = std::function<std::shared_ptr<runs::PreparedScene>(const std::vector<VariableValue>&)>;

  Branch(std::vector<Variable> variables, OpenCase open, const runs::Watch& watch, BranchOptions options = {})
      : variables_(std::move(variables)), open_(std::move(open)), watch_(watch), options_(options) {}

  /// The equilibrium of a scene that is ready, at these values. Where it is a stable one, the branch goes on
  /// from there, else from nowhere.
  Reached reach(std::shared_ptr<runs::PreparedScene> scene, const std::vector<VariableValue>& values);

 private:
  /// A solved place on the way from the last point (0) to the next (1); before 0, points before.
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

  std::vector<Variable> variables_;  // of the path
  OpenCase open_;
  const runs::Watch& watch_;
  BranchOptions options_;
  std::vector<Solved> trail_;  // the last two equilibria, the newest behind
  Cost spent_;                 // on the way to the next one
};

}  // namespace netloft::studies
