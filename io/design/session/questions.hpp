// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/session/replies.hpp"

#include <cmath>
#include <functional>

namespace netloft::design {

using OnDone = std::function<void(std::size_t done, std::size_t all)>;

/// The last equilibrium as the viewer of pages reads it (pictures::results_json). Throws Refused without one,
/// as all functions here do.
Json picture_json(const LiveScene& scene);

/// Figures, and the tables of the report as HTML.
Json report_json(const LiveScene& scene);

/// The numbers that a figure depends on most, the largest effect of one percent first, and those without
/// derivatives with the reasons. Throws formats::Interrupted.
Json influences_json(LiveScene& scene, const std::string& figure, const std::atomic<bool>& interrupt,
                     const OnDone& on_done);

struct SweepQuestion {
  std::string path;
  double from = 0, to = 0;  // in the unit of the number as it is written
  int points = 0;
};
/// All figures at evenly spaced values of a number, each equilibrium continued from its neighbour, outwards
/// from the present value. A value without an equilibrium has null figures. Throws formats::Interrupted.
Json sweep_json(LiveScene& scene, const SweepQuestion& question, const std::atomic<bool>& interrupt,
                const OnDone& on_done);

struct ReachQuestion {
  std::string figure;
  double target = 0;  // in the unit of the figure
  std::string path;   // number that may change
};
/// The value of the number at which the figure has its target: by Newton's method with the tangent first,
/// then by the secant of the last two equilibria. Throws Refused with the nearest value found if there is
/// none, and formats::Interrupted.
Json reach_json(LiveScene& scene, const ReachQuestion& question, const std::atomic<bool>& interrupt);

struct RangeQuestion {
  std::string path;                              // number that changes
  std::string figure;                            // figure that has to stay within bounds; empty: none
  double least = -INFINITY, largest = INFINITY;  // in the unit of the figure
};
/// How far the number may go down and up until there is no equilibrium, the scene is wrong, a part bears more
/// than its breaking load, or the figure leaves its bounds; with the reason. Throws Refused and
/// formats::Interrupted.
Json range_json(LiveScene& scene, const RangeQuestion& question, const std::atomic<bool>& interrupt);

}  // namespace netloft::design
