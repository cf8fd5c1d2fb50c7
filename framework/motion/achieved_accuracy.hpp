// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_control.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft {

/// How accurate a march was, over the longest element: what control of the error came to where steps are
/// adaptive, and the error of the path where that was asked for.
/// Errors of single steps say nothing of a motion that enlarges them, or of steps that are given. So the host
/// may go through time a second time, in steps r times as long (2, or ½ where stability bounds them), and
/// takes for the error of the path
///   the largest distance of a node between both at an output / min(1, |r − 1|)                  (1)
/// r as the mean steps were; where they differ by less than a tenth, nothing is told, and if that is so at
/// all outputs the error is not known. It is not below the error where that falls with the step by the power
/// 1 or more; in a motion that errors have taken over, both are off alike, and so is their difference.
struct AchievedAccuracy {
  double asked = 0;    // accuracy of the path
  double element = 0;  // the longest, along one axis [m]
  double allowed = 0;  // error of one step by (2) of step_control.hpp
  double largest = 0;  // estimated for an accepted step, at time t and of a node
  double t = 0;        // [s]
  std::string node = {};
  double sum = 0;  // of the largest errors of all steps: that of the path, if no motion enlarges or damps it
  bool is_checked = false;  // against another march: what follows is known
  // error of the path by (1), at a time and of a node; infinite: the other was lost; NaN: not told, for its
  // steps were the same
  double path = 0;
  double path_at = 0;  // [s]
  std::string path_of = {};
  /// The path is not known as well as was asked for.
  bool is_missed() const { return is_checked && !(path <= asked); }
};

/// Settings of the march that one with these `settings` is compared with: the same in steps r times as long.
MarchSettings settings_of_comparison(const MarchSettings& settings, bool is_bounded_by_stability);

/// Keeps the estimated error of an accepted step that ends at time t, over all unknowns [m].
void note_step_error(const StepControl& control, const Numbering& numbering, std::span<const double> error,
                     double t, MarchState& state);

/// Keeps (1), where it is larger than before: of node positions in two marches at time t, whose steps are
/// `longer` times as long in the other.
void note_path_error(const std::vector<double>& here, const std::vector<double>& there, double t,
                     double longer, MarchState& state);

/// What was kept in `state`. `why_lost`: why the march that it is compared with failed, if it did.
AchievedAccuracy achieved_accuracy(const AssembledScene& of, const MarchSettings& settings,
                                   const StepControl& control, const MarchState& state,
                                   const std::string& why_lost);

}  // namespace netloft
