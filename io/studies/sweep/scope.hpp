// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/variables/variable.hpp"

#include <functional>

namespace netloft::studies {

/// For which depths and which lengths of warp a gear is looked at, and how its boards ought to stand.
struct ScopeRequest {
  std::vector<double> depths;      // [m]
  std::vector<double> scopes;      // length of warp over depth, ascending
  Interval heel;                   // of the boards [deg]
  std::optional<Interval> spread;  // of the boards [m]
};

/// The gear behind one length of warp. Numbers but the length are NaN where no stable equilibrium was found.
struct ScopePoint {
  double warp = 0;                                                // [m]
  double heel = 0, spread = 0, wing = 0, headline = 0, pull = 0;  // [deg], [m], [m], [m], [N]
  std::string why_not = {};                                       // there are no numbers
};

/// The results at one depth.
struct ScopeRow {
  double depth = 0;
  std::vector<ScopePoint> points;     // warps ascending; all of them, unless the user interrupted
  std::optional<Interval> warp;       // lengths for which the boards stand as they ought to
  std::optional<std::size_t> chosen;  // of the points in it: heel nearest to the middle of its band
  std::vector<std::string> events;    // folds and jumps on the way
};

/// Called with the number of lengths that were solved, at all depths, and with the last.
using OnScopePoint = std::function<void(std::size_t, const ScopeRow&, const ScopePoint&)>;

/// Finds the lengths for which heel and spread lie in their bands: `row.warp` and `row.chosen`, out of the
/// points. Between two points figures are taken to change evenly. Of several such intervals it is the one
/// around the chosen point.
void find_lengths(const ScopeRequest& request, ScopeRow& row);

/// Follows the equilibrium of a scene with a ship, a bed and one pair of boards over lengths of warp, depth
/// by depth (branch.hpp). An interruption leaves out what was not solved, and the lengths of its depth.
/// Throws std::invalid_argument with a sentence for other scenes, and where no length can be read.
std::vector<ScopeRow> find_scope(const runs::CaseSource& source, Registry& registry,
                                 const ScopeRequest& request, const runs::Watch& watch,
                                 const OnScopePoint& on_point = {});

/// Lengths of warp over depth, as a picture: SVG or an HTML page.
std::string draw_scope(const std::string& scene, const std::vector<ScopeRow>& rows, bool as_page);

}  // namespace netloft::studies
