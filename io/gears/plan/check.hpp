// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"

namespace netloft::gears {

/// Limits from which a difference is reported as a warning, and from which as an error; relative to the value
/// in the plan where no unit is given.
struct CheckLimits {
  double closing_meshes =
      1;  // of an aft edge [meshes]; half a mesh on either side may belong to the selvedge
  double closing_error = 0.05;  // a larger misfit of cuttings and aft count cannot be intended
  double joining_meshes = 2;    // of edges sewn mesh to mesh [meshes]
  double joining = 0.02;        // the same, relative
  double joining_error = 0.10;  // beyond it the plan must state a take-up ratio
  double stretching = 0.02;     // of netting beyond the length of its straight twines
  double bunching = 0.2;        // hanging ratio below which meshes are bunched
  double loose_rope = 0.5;      // least part of a rope with hangings that is given to edges
  double crowded = 4;           // floats in a row over the length they are spread along, that fit in no bunch
  double short_rope = 0.02;     // of missing rope
  double rounding = 1e-3;       // of lengths, as they are rounded in plans
};

/// Checks whether the net can be sewn: cuttings close, joins match, ropes are long enough, nothing is
/// unconnected. Errors go into the diagnostics, each with its place and the likely cure. A cutting that is
/// not a rate is replaced by the one that the plan probably means, and the remaining checks use that one.
void check_plan(NetPlan& plan, formats::Diagnostics& diagnostics, const CheckLimits& limits = {});

// The parts of check_plan.
void check_panels(NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_joins(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_hangings(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_ropes(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_pieces(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
void check_connections(const NetPlan& plan, formats::Diagnostics& diagnostics);
/// Checks that ropes with hangings are mostly on edges. The plan must be free of errors.
void check_loose_ropes(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);
/// Checks that every edge is sewn, hung or declared open. The plan must be free of errors.
void check_open_edges(const NetPlan& plan, formats::Diagnostics& diagnostics);
/// Checks points with known positions: they must not be farther apart than the ropes between them allow,
/// and no rope must lead from a point to itself. The
/// plan must be free of errors.
void check_spans(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics);

/// Numbers in the notation of net makers: 43, 25.8, +1.7 %.
std::string in_meshes(double meshes);
std::string in_metres(double metres);
std::string in_percent(double fraction);

}  // namespace netloft::gears
