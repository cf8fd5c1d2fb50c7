// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/variables/variable.hpp"

#include <functional>

namespace netloft::studies {

/// The depths and warp lengths to solve, and the bands in which attitude and spread of the boards should be.
struct ScopeRequest {
  std::vector<double> depths;      // [m]
  std::vector<double> scopes;      // length of warp over depth, ascending
  Interval heel;                   // allowed heel of the boards [deg]
  std::optional<Interval> spread;  // allowed spread of the boards [m]
};

/// The gear behind one length of warp. Numbers other than the length are NaN if no stable equilibrium was
/// found.
struct ScopePoint {
  double warp = 0;                                                // [m]
  double heel = 0, spread = 0, wing = 0, headline = 0, pull = 0;  // [deg], [m], [m], [m], [N]
  std::string why_not = {};                                       // the reason if there are no numbers
};

/// The results at one depth.
struct ScopeRow {
  double depth = 0;
  std::vector<ScopePoint> points;  // points by increasing warp; complete unless the user interrupted
  std::optional<Interval> warp;    // lengths for which the boards are within their bands
  // Index of the point, among those within `warp`, whose heel is nearest to the middle of its band.
  std::optional<std::size_t> chosen;
  std::vector<std::string> events;  // folds and jumps along the warp lengths
};

/// Called after every point with the number of points solved so far, and with the last row and point.
using OnScopePoint = std::function<void(std::size_t, const ScopeRow&, const ScopePoint&)>;

/// Sets `row.warp`, the interval of lengths for which heel and spread are within their bands, and
/// `row.chosen`. Heel and spread are interpolated linearly between points. If there are several such
/// intervals, `row.warp` is the one around the chosen point.
void find_lengths(const ScopeRequest& request, ScopeRow& row);

/// Finds, for each depth, how long the warps should be, for a scene with a ship, a bed and one pair of
/// boards. Follows the equilibrium over lengths of warp, depth by depth (branch.hpp). After an interruption,
/// unsolved points and the lengths for the interrupted depth are missing. Throws std::invalid_argument with a
/// sentence for other scenes, and if the scene cannot be read at any length.
std::vector<ScopeRow> find_scope(const runs::CaseSource& source, Registry& registry,
                                 const ScopeRequest& request, const runs::Watch& watch,
                                 const OnScopePoint& on_point = {});

/// A picture of the lengths of warp as a function of depth: SVG or an HTML page.
std::string draw_scope(const std::string& scene, const std::vector<ScopeRow>& rows, bool as_page);

}  // namespace netloft::studies
