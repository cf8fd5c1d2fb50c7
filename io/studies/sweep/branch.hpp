// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/sweep/study.hpp"

#include <memory>

namespace netloft::studies {

/// An equilibrium on a branch: the scene, its solution, and the values of the study's variables.
struct Solved {
  std::shared_ptr<runs::PreparedScene> scene;
  Solution solution;
  std::vector<VariableValue> values;
};

/// The equilibrium at the next point, and how it was found.
struct Reached {
  Solution solution;                // equilibrium; its cost includes that of intermediate points
  bool was_continued = false;       // false: found by a new search
  std::vector<std::string> events;  // folds and jumps, as sentences
};

struct BranchOptions {
  int iterations = 12;  // limit of iterations of a step; after that it is halved
  int halvings = 5;     // limit of halvings of a step; after that the branch has ended
  // The fraction of a step over which residuals are differenced for a tangent. With a larger fraction, the
  // tangent is wrong, because the bed yields by millimetres only; a smaller fraction loses digits to
  // rounding. On four gears, 2^-16 to 2^-20 need the fewest factorisations; with 2^-12 and 2^-28, the trawl
  // 83-112 at sea needs two to five times as many.
  double little = 0x1p-20;
  // With fewer than two places, positions cannot be extrapolated. A step with more iterations than this may
  // then have jumped to another branch, and is checked. Steps of the trawl 83-112 with 600 and 1000 nodes
  // took 1 to 4 iterations.
  int few_iterations = 4;
  // A move below this fraction of the gear's size is not reported as a fold or jump; for example, the move of
  // a twine that becomes slack.
  double noticed = 1e-3;
};

/// Follows an equilibrium while variables of a study change from point to point along a path. The solver of
/// the scene starts from a prediction: the extrapolation of the last two equilibria if the next point is on a
/// line with both, else the tangent (runs::Tangent; E. L. Allgower, K. Georg, Introduction to
/// numerical continuation methods, 2003, ch. 2). If the solver fails, the step is halved; if it succeeds, the
/// step is doubled again. After `halvings` halvings the strategy of the scene searches anew.
///
/// At a fold the branch ends: the smallest step fails, and the new search finds an equilibrium elsewhere,
/// more than four times as far away as the extrapolation predicts. At a jump the solver converges to another
/// branch without failing. To tell a jump from a smooth change, the step is halved k times towards the place
/// of largest change: a smooth branch then changes by 2^-k of the whole, while a jump keeps its size. If more
/// than a quarter remains after `halvings`, the change is a jump. Folds and jumps are reported with the
/// values on either side and the node that moves most.
class Branch {
 public:
  /// Opens the scene at some values of the variables in the path; nullptr if the scene cannot be read.
  using OpenCase = std::function<std::shared_ptr<runs::PreparedScene>(const std::vector<VariableValue>&)>;

  Branch(std::vector<Variable> variables, OpenCase open, const runs::Watch& watch, BranchOptions options = {})
      : variables_(std::move(variables)), open_(std::move(open)), watch_(watch), options_(options) {}

  /// Finds the equilibrium of `scene`, which is prepared with these values, by following the branch. If this
  /// equilibrium is stable, the branch continues from it; otherwise a new search finds the equilibrium at the
  /// next point.
  Reached reach(std::shared_ptr<runs::PreparedScene> scene, const std::vector<VariableValue>& values);

 private:
  /// A solved point, and its position along the step: 0 at the last point of the path, 1 at the next one,
  /// negative before the last one.
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
  std::vector<Solved> trail_;  // the last two equilibria of the branch, in order
  Cost spent_;                 // cost of the step to the next equilibrium
};

}  // namespace netloft::studies
