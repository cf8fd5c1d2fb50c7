// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/plan.hpp"

namespace netloft::io {

/// From where on a difference is told, and from where on it is an error. Shares of what the plan says.
struct CheckLimits {
  double closing_meshes = 1;    // of an aft edge: half a mesh a side is a matter of the selvedge
  double closing_error = 0.05;  // cuttings that miss the aft count by more cannot be what was meant
  double joining_meshes = 2;    // of edges sewn mesh to mesh
  double joining = 0.02;        // the same as a share
  double joining_error = 0.10;  // beyond it a take-up ratio has to be said
  double stretching = 0.02;     // of netting beyond its twines pulled straight
  double bunching = 0.2;        // hanging ratio below which meshes are bunched
  double short_rope = 0.02;     // of rope that is missing
  double rounding = 1e-3;       // of lengths, as plans round them
};

/// Asks whether the net can be sewn: cuttings that close, joins that match, ropes long enough, nothing left
/// over. What is wrong goes into the diagnostics, each with its place and the likely cure. A cutting that is
/// no rate is replaced by the one that the plan may have meant, so that the rest is checked as if it said so.
void check_plan(Plan& plan, Diagnostics& diagnostics, const CheckLimits& limits = {});

// The parts of it.
void check_panels(Plan& plan, const CheckLimits& limits, Diagnostics& diagnostics);
void check_joins(const Plan& plan, const CheckLimits& limits, Diagnostics& diagnostics);
void check_hangings(const Plan& plan, const CheckLimits& limits, Diagnostics& diagnostics);
void check_ropes(const Plan& plan, const CheckLimits& limits, Diagnostics& diagnostics);
void check_pieces(const Plan& plan, Diagnostics& diagnostics);
void check_connections(const Plan& plan, Diagnostics& diagnostics);
/// Points that are known and farther apart than all ropes between them; of a plan without errors.
void check_spans(const Plan& plan, const CheckLimits& limits, Diagnostics& diagnostics);

/// Numbers as a net maker writes them: 43, 25.8, +1.7 %.
std::string in_meshes(double meshes);
std::string in_metres(double metres);
std::string in_percent(double share);

}  // namespace netloft::io
