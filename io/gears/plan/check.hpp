// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"

#include <array>
#include <string>
#include <vector>

namespace netloft::gears {

/// Limits above which a difference causes a warning or an error. Limits without a unit are relative to the
/// value in the plan.
struct CheckLimits {
  double closing_meshes = 1;    // difference between cuttings and aft count [meshes] that seams can hide
  double closing_error = 0.05;  // relative difference of cuttings and aft count, above which it is an error
  double joining_meshes = 2;    // difference between edges that are sewn mesh to mesh [meshes]
  double joining = 0.02;  // relative difference of such edges; a warning requires both limits to be exceeded
  double joining_error = 0.10;  // relative difference above which the plan must state a take-up ratio
  double stretching = 0.02;     // relative excess of a rope over the straight twines that are hung on it
  double bunching = 0.2;        // hanging ratio below which meshes bunch up
  double loose_rope = 0.5;      // if hung edges take less than this fraction of a rope, there is a warning
  double crowded = 4;  // width of all floats relative to the length of their rope, above which they do not
                       // even fit in bunches
  double short_rope = 0.02;  // fraction of its length by which a rope may be too short
  double rounding = 1e-3;    // relative rounding of lengths in plans
};

/// Checks whether the net can be sewn: the cuttings agree with the counts, sewn edges fit each other, ropes
/// are long enough, everything is connected. Errors go to the diagnostics, each with its place and the likely
/// cure. If a cutting is not a valid rate, the remaining checks use the rate that it probably means.
void check_plan(NetPlan& plan, formats::Diagnostics& diagnostics, const CheckLimits& limits = {});

/// The part of check_plan() that reads only lengths, mesh counts and connections of panels and ropes. It
/// changes a panel only if a cutting is not a valid rate: the cutting then gets the rate that it probably
/// means.
void check_net(NetPlan& plan, formats::Diagnostics& diagnostics, const CheckLimits& limits = {});

/// Two points of the whole gear and the length of the shortest path along ropes between them [m].
struct RopeSpan {
  struct End {
    std::size_t point;  // index in NetPlan::points
    bool is_mirrored;   // whether it is the point to port of a pair
    std::string name;   // name of the point in the gear
  };
  std::array<End, 2> ends;
  double length;
};

/// All pairs of points with ropes between them. The plan must be free of errors.
std::vector<RopeSpan> rope_spans(const NetPlan& plan);
/// The part of check_plan() that reads materials, floats and weights, and positions of points. `spans` are
/// the rope spans of the plan, or empty after an error.
void check_fittings(const NetPlan& plan, const std::vector<RopeSpan>& spans,
                    formats::Diagnostics& diagnostics, const CheckLimits& limits = {});

// These functions are the parts of check_net.
void check_panels(NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_joins(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_hangings(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
/// Reports edges on rims of bodies that do not exist, or not on the same sides as the body.
void check_rims(const NetPlan& plan, formats::Diagnostics& diagnostics);
void check_ropes(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_connections(const NetPlan& plan, formats::Diagnostics& diagnostics);
/// Reports a loose loop, which is a rope that begins and ends at the same point and has no edge hung on it.
/// The plan must be free of errors.
void check_loops(const NetPlan& plan, formats::Diagnostics& diagnostics);
/// Warns of ropes if the edges hung on them take only a small part of their length. The plan must be free of
/// errors.
void check_loose_ropes(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
/// Checks that every edge is sewn, hung or declared open. The plan must be free of errors.
void check_open_edges(const NetPlan& plan, formats::Diagnostics& diagnostics);

// These functions are parts of check_fittings.
void check_pieces(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
/// Checks that two points are not farther apart than the ropes between them are long. The plan must be free
/// of errors.
void check_spans(const NetPlan& plan, const std::vector<RopeSpan>& spans, const CheckLimits& limits,
                 formats::Diagnostics& diagnostics);

/// Numbers as net makers write them: 25.8 meshes, 12.35 m and +1.7 %. The texts of `in_meshes` and
/// `in_metres` have no unit.
std::string in_meshes(double meshes);
std::string in_metres(double metres);
std::string in_percent(double fraction);

}  // namespace netloft::gears
