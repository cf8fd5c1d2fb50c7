// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/search/search.hpp"

#include <atomic>
#include <functional>
#include <span>
#include <string>

namespace netloft::runs {

/// Callbacks of a search or a motion, and the flag that interrupts it. Each member may be empty.
struct Watch {
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const IterationRecord&)> on_iteration = {};
  KeptPoint* kept = nullptr;  // receives the best point found so far
  // Called after every stage of a search.
  std::function<void(const StageRecord&, std::span<const double> u)> on_stage = {};
  /// Called after every step in time. `run` is the name of the motion, because a comparison of methods
  /// computes several motions.
  std::function<void(const StepRecord&, const std::string& run)> on_step = {};
  /// Called with the processor time allowed from now on [s], and with infinity at the end of the search.
  std::function<void(double)> on_budget = {};
};

}  // namespace netloft::runs
