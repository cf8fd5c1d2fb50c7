// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft {

/// Settings of the integration in time.
struct MarchSettings {
  double duration = 0;  // [s]
  double step = 0;      // length of the first step, or of all steps if not adaptive [s]; 0: the host chooses
  bool adaptive = true;
  // Accuracy of the path, relative to the longest element. The allowed errors of single steps follow from (2)
  // of step_control.hpp.
  double accuracy = 1e-3;
  double longest_step = std::numeric_limits<double>::infinity();  // [s]
  double shortest_step = 1e-9;                                    // [s]
  double output_interval = 0;  // [s]; 0: outputs at the beginning and the end
  bool dense = false;          // outputs may lie between the ends of steps; otherwise steps end at outputs
  bool budget = true;          // keep the energy budget
  bool judged = true;          // fail if the motion has energy that nothing supplied
  bool check = false;          // compare with a second integration that has longer or shorter steps
  bool disturb = false;        // displace the start slightly, for a march that is compared with another
  double pace = 1;             // factor on all step lengths
  double mass_damping = 0;     // c of the force −c M v [1/s]

  /// Whether the energy of some steps is examined, also without a budget.
  bool watches_energy() const { return judged || adaptive; }
};

}  // namespace netloft
