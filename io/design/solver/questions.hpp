// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/solver/replies.hpp"

#include <cmath>
#include <functional>

namespace netloft::design {

/// The last equilibrium in the form that the viewer reads (pictures::results_json). All functions here throw
/// Refused if there is no equilibrium.
Json picture_json(const LiveScene& scene);

/// Figures and picture of a gear that stands beside the design.
Json beside_json(const results::StoredShape& shape);

/// The plan of the last text as SVG; empty without a plan, or if it has errors.
Json plan_json(LiveScene& scene);

/// Figures, and the tables of the report as HTML.
Json report_json(const LiveScene& scene);

/// The design as a file for others: `kind` is "hdf", the result of the last equilibrium, "html", a page with
/// its report and picture, or "pdf", the plan of the last text. Throws Refused.
Json export_json(LiveScene& scene, const std::string& kind);

/// The numbers on which a figure depends, sorted by the effect of a change by one percent, and the numbers
/// without derivatives, with the reasons. Throws formats::Interrupted.
Json influences_json(LiveScene& scene, const std::string& figure, const std::atomic<bool>& interrupt,
                     const OnProgress& on_done);

struct SweepQuestion {
  std::string path;
  double from = 0, to = 0;  // in the unit of the number as it is written
  int points = 0;
};
/// All figures at evenly spaced values of a number. From the present value outwards, each search starts from
/// the equilibrium at the neighbouring value. Figures are null at a value without an equilibrium. Throws
/// formats::Interrupted.
Json sweep_json(LiveScene& scene, const SweepQuestion& question, const std::atomic<bool>& interrupt,
                const OnProgress& on_done);

struct ReachQuestion {
  std::string figure;
  double target = 0;               // in the unit of the figure
  std::vector<std::string> paths;  // numbers that may change
};
/// Values of the numbers at which the figure reaches its target, with relative changes in proportion to their
/// effects, which are the smallest that lead there to first order. The first step uses the tangents, later
/// steps the secant of the last two equilibria. If there are no such values, throws Refused with the nearest
/// ones found. Also throws formats::Interrupted.
Json reach_json(LiveScene& scene, const ReachQuestion& question, const std::atomic<bool>& interrupt);

struct RangeQuestion {
  std::string path;                              // number that changes
  std::string figure;                            // figure that has to stay within bounds; empty: none
  double least = -INFINITY, largest = INFINITY;  // in the unit of the figure
};
/// How far the number can be decreased and increased, with the reason for each limit: no equilibrium, an
/// error in the scene, a part that bears more than its breaking load, or a figure outside its bounds. Throws
/// Refused and formats::Interrupted.
Json range_json(LiveScene& scene, const RangeQuestion& question, const std::atomic<bool>& interrupt);

}  // namespace netloft::design
