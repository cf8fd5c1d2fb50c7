// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/balance/limits.hpp"
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_control.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace netloft {

/// Achieved accuracy of a march (an integration in time), relative to the longest element: the estimated
/// errors of single steps (only if steps are adaptive), and the error of the path (only if the user requested
/// it). Errors of single steps do not give the error of the path, because a motion can amplify them, and
/// fixed steps have no error estimate. Therefore the host can integrate a second time, with steps r times as
/// long (r = 2, or ½ if stability limits the steps). It estimates the error of the path as
///   the largest distance of a node between the two marches at an output / min(1, |r − 1|)       (1)
/// where r is the ratio of the mean steps. Outputs at which r differs from 1 by less than a tenth are
/// ignored; if all outputs are ignored, the error is unknown. The estimate is an upper bound if the error is
/// at least proportional to the step. In a chaotic motion, such as the fall of a slack chain or the motion
/// after a snap, any error grows until it is as large as the motion, no matter how short the steps are. The
/// host therefore compares the second march with a third one, which has the same steps and a start displaced
/// by 1e-7 of the longest element. As soon as the second and the third march differ by more than the
/// accuracy, the path cannot be predicted any more, and (1) is no longer updated.
struct AchievedAccuracy {
  double asked = 0;    // requested accuracy of the path
  double element = 0;  // extent of the longest element along one axis [m]
  double allowed = 0;  // largest error of one step, by (2) of step_control.hpp
  double largest = 0;  // largest estimated error of an accepted step, at time t and node `node`
  double t = 0;        // [s]
  std::string node = {};
  // Sum of the largest errors of all steps: the error of the path, if the motion neither amplifies nor damps
  // errors.
  double sum = 0;
  bool is_checked =
      false;  // whether the march was compared with another one; only then are the following members known
  // Error of the path by (1), at time path_at and node path_of. Infinite if the second march failed (path_of
  // is then the reason); NaN if the error is unknown because both marches had steps of the same length.
  double path = 0;
  double path_at = 0;  // [s]
  std::string path_of = {};
  /// First output at which the disturbed march differs by more than `asked` [s]; infinite if there is none.
  double unpredictable_from = std::numeric_limits<double>::infinity();
  bool is_predictable() const { return std::isinf(unpredictable_from); }
  /// Whether the path is less accurate than requested.
  bool is_missed() const { return is_checked && !(path <= asked && is_predictable()); }
};

/// Settings of the second march, with which a march is compared: `settings` with steps r times as long.
MarchSettings settings_of_comparison(const MarchSettings& settings, bool is_bounded_by_stability);

/// Limits of the second and the third march (integration in time, see AchievedAccuracy): `limits`, but with a
/// tolerance no larger than the relative displacement of disturb(), because larger errors of steps would hide
/// the displaced start.
Limits limits_of_comparison(const Limits& limits);

/// Settings of the third march, with which the second one is compared.
MarchSettings settings_of_disturbed(const MarchSettings& settings);
/// Displaces the start of a march by 1e-7 of the longest element, whose length is `element` [m].
void disturb(MarchState& start, double element);

/// Stores the estimated error of an accepted step that ends at time t, over all unknowns [m].
void note_step_error(const StepControl& control, const Numbering& numbering, std::span<const double> error,
                     double t, MarchState& state);

/// Evaluates (1) for the node positions of two marches (integrations in time) at time t, and stores the
/// result if it exceeds all previous ones. `longer` is r: the steps of the other march are r times as long.
void note_path_error(const std::vector<double>& here, const std::vector<double>& there, double t,
                     double longer, MarchState& state);

/// Stores t as the time from which two marches differ by more than `allowed` [m], unless an earlier time is
/// stored.
void note_parting(const std::vector<double>& here, const std::vector<double>& there, double t, double allowed,
                  MarchState& state);

AchievedAccuracy achieved_accuracy(const AssembledScene& of, const MarchSettings& settings,
                                   const StepControl& control, const MarchState& state);

}  // namespace netloft
