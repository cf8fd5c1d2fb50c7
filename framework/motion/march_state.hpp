// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/statistics.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace netloft {

class Assembler;

/// How well forces balance at rest at the beginning of a march.
struct StartBalance {
  double residual = 0, load = 0;  // largest nodal residual, largest nodal load [N]
  std::string node;               // node with the largest residual; empty: the march has not begun
};

/// The state of a march (an integration in time), from which a later run can continue it with bit-identical
/// results, and the numbers that its report needs.
struct MarchState {
  double t = 0, h = 0;                      // current time, and length of the next step [s]
  std::vector<double> u, v, a;              // state of the unknowns [m], [m/s], [m/s²]
  std::vector<double> memory;               // memory of the elements
  std::vector<double> budget;               // sums of the energy budget [J]
  std::vector<double> judged;               // sums of the energy judge [J]
  std::vector<double> winches;              // Winches::state()
  double error_sum = 0, largest_error = 0;  // sum of the errors of all steps and largest error of a step,
                                            // relative to the longest element
  double largest_at = 0;                    // time of the largest error [s]
  std::uint64_t largest_of = 0;             // node of the largest error
  double least_load = 0;                    // [N]
  double stable_step = 0;   // longest stable step for the last tangent [s]; 0: not yet determined
  std::size_t outputs = 0;  // number of previous outputs
  std::int64_t steps = 0, rejected = 0;
  double shortest = 0, longest = 0;  // shortest and longest accepted step [s]
  Statistics statistics;             // cost so far, without the march for comparison
  StartBalance start;
  std::string remark;   // remark about the start, appended to the reason why the march ended; empty: none
  double t_before = 0;  // beginning of the last step, needed to compare marches between the ends of steps [s]
  std::vector<double> u_before, v_before;  // state at t_before [m], [m/s]
  std::vector<MarchState> other;           // the march for comparison: its state, or empty
  std::string why_lost;                    // why the march for comparison failed; empty: it did not fail
  // Largest error so far by (1) of achieved_accuracy.hpp [m], and its time [s]; NaN: not compared yet.
  double path_error = std::numeric_limits<double>::quiet_NaN(), path_at = 0;
  std::uint64_t path_of = 0;  // node of path_error
  /// Time of the first output at which a march from a disturbed start differs by more than the accuracy [s].
  double parted_at = std::numeric_limits<double>::infinity();

  /// Mean length of the steps so far [s]; NaN before the first step.
  double mean_step() const { return t / static_cast<double>(steps); }
};

/// The state in which nothing moves: nodes are at their initial positions, displaced by u if u is given.
MarchState state_at_rest(const Assembler& assembler, std::span<const double> u = {});

}  // namespace netloft
