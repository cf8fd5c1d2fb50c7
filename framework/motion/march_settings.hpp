// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft {

/// How time is gone through.
struct MarchSettings {
  double duration = 0;  // [s]
  double step = 0;      // first or only one [s]; 0: found
  bool adaptive = true;
  double accuracy =
      1e-3;  // of the path: errors of single steps by (2) of step_control.hpp, over the longest element
  double longest_step = std::numeric_limits<double>::infinity();  // [s]
  double shortest_step = 1e-9;                                    // [s]
  double output_interval = 0;                                     // [s]; 0: the beginning and the end
  bool dense = false;       // outputs between steps; otherwise steps end at them
  bool budget = true;       // keep the energy budget
  bool judged = true;       // fail once there is energy that nobody gave
  bool check = false;       // compare with another march, in steps `pace` times as long
  double pace = 1;          // factor on all lengths of steps
  double mass_damping = 0;  // c of the force −c M v [1/s]

  /// Some step's energy is looked at, whether or not a budget of it is kept.
  bool watches_energy() const { return judged || adaptive; }
};

}  // namespace netloft
