// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace netloft {

class Assembler;

/// All that the rest of a march follows from, to the bit: what is kept to go on later.
struct MarchState {
  double t = 0, h = 0;                      // reached, and the step that was wanted next [s]
  std::vector<double> u, v, a;              // of the unknowns [m], [m/s], [m/s²]
  std::vector<double> memory;               // of the elements
  std::vector<double> budget;               // sums of it [J]
  std::vector<double> judged;               // sums of who judges it [J]
  std::vector<double> winches;              // Winches::state()
  double error_sum = 0, largest_error = 0;  // of steps, over the longest element
  double largest_at = 0;                    // time of the largest [s]
  std::uint64_t largest_of = 0;             // and its node
  double least_load = 0;                    // [N]
  double stable_step = 0;                   // by the tangent when it was last asked for [s]; 0: not yet
  std::size_t outputs = 0;                  // written before
  std::int64_t steps = 0, rejected = 0;
  double t_before = 0;  // begin of the last step, of a march that is compared between steps [s]
  std::vector<double> u_before, v_before;  // there [m], [m/s]
  std::vector<MarchState> other;           // the march that this one is compared with, if it is
  // largest so far by (1) of achieved_accuracy.hpp [m], its time [s]; NaN: not compared yet
  double path_error = std::numeric_limits<double>::quiet_NaN(), path_at = 0;
  std::uint64_t path_of = 0;  // and its node

  /// NaN before the first step [s].
  double mean_step() const { return t / static_cast<double>(steps); }
};

/// At rest where the scene starts, or with displacements u of its unknowns.
MarchState state_at_rest(const Assembler& assembler, std::span<const double> u = {});

}  // namespace netloft
