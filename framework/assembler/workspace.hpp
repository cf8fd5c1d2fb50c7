// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/assembler/tile_rows.hpp"

#include <algorithm>
#include <limits>

namespace netloft {

inline constexpr std::size_t kLanes = NETLOFT_LANES;

inline std::size_t packed(std::size_t dofs) { return dofs * (dofs + 1) / 2; }

/// One worker's tile: inputs, sums, and a square for unpacked tangents, in rows of 64 doubles.
struct Assembler::Workspace {
  Workspace(std::size_t dofs, const ScenePlan& plan, bool flows, bool swings)
      : current(flows ? dofs * kLanes : 0),
        current_dz(flows ? dofs * kLanes : 0),
        bed(2 * dofs * kLanes),
        water_acceleration(swings ? dofs * kLanes : 0),
        surface(water_acceleration.size() / 3),
        x(dofs * kLanes),
        x_low(x.size()),
        v(plan.kind == AnalysisKind::dynamics ? dofs * kLanes : 0),
        a(v.size()),
        force(dofs),
        packed_tangent(packed(dofs)),
        square_tangent(plan.symmetric ? 0 : dofs * dofs),
        scratch(dofs * dofs * kLanes),
        element(dofs * dofs),
        before(plan.between ? dofs * kLanes : 0),
        after(before.size()),
        energies(2 * kLanes),
        forces(2 * before.size()) {}
  std::vector<double> current, current_dz;          // empty in still water
  std::vector<double> bed;                          // six numbers a node
  std::vector<double> water_acceleration, surface;  // empty without waves
  // time of the uniform current that is filled in [s]
  double current_time = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, x_low, v, a;  // without rates if everything is at rest
  TileRows force, packed_tangent, square_tangent;
  double* open_tangent(bool symmetric, std::size_t dofs, std::size_t lanes) {
    return symmetric ? packed_tangent.open(packed(dofs), lanes) : square_tangent.open(dofs * dofs, lanes);
  }
  std::vector<double> scratch, element;
  std::vector<double> before, after, energies, forces;  // for mean forces of steps; else empty
  std::vector<netloft_member> members, members_before, members_after;
  double energy[kLanes] = {};
  char message[sizeof ElementFault::message] = "";
  ElementFault fault;
  std::size_t fault_order = std::numeric_limits<std::size_t>::max();
};

/// Calls `evaluate` for each tile of a family and passes the filled tile to `visit`. Returns false on
/// failure: see fault().
template <class Evaluate, class Visit>
bool Assembler::visit_tiles(std::span<const double> x, const Kinematics& motion, std::size_t family,
                            const Evaluate& evaluate, const Visit& visit) {
  const FamilyGroup& group = group_of(family);
  const auto dofs = static_cast<std::size_t>(families_[family]->type().dofs());
  Workspace& w = *workspaces_[0];
  for (std::size_t tile = 0; tile < group.tiling.tiles; ++tile) {
    gather(group, tile, x, motion, w);
    netloft_tile t = make_tile(family, tile, motion, w);
    w.force.begin();
    t.force = w.force.open(dofs, t.count);
    t.want = NETLOFT_WANT_FORCE;
    if (const int status = evaluate(tile, t); status != NETLOFT_OK) {
      report(family, t, status, w);
      return collect_faults();
    }
    visit(tile, t, w);
  }
  return true;
}

}  // namespace netloft
