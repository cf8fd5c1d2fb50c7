// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::newton {

/// The result of an attempt to move along a direction: whether u has moved, and which rule accepted the step.
struct Step {
  enum class Rule { none, energy, residual, slope };
  Rule rule = Rule::none;
  double damping = 0;          // μ of the matrix that gave the direction
  double length = 0;           // t along the direction, as the rule found it
  bool leaves_saddle = false;  // whether u has moved along negative curvature
  explicit operator bool() const { return rule != Rule::none || leaves_saddle; }
};

}  // namespace netloft::newton
