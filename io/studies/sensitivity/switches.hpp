// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace netloft::studies {

/// Distances of a shape from the states at which the stiffness of the scene jumps: a member becomes taut or
/// slack, a node touches or leaves the ground. A derivative is valid until one of these signed distances
/// changes its sign.
struct Switches {
  struct OfKind {
    std::vector<double> distance;
    std::vector<std::uint32_t> part;  // scene part of each member or node
  };
  OfKind members;  // l/l₀ − 1 of bars and twines: taut above 0, slack below
  OfKind nodes;    // height of nodes over the ground [m]: nodes touch it below 0
};

/// The switches of a scene at positions x of all degrees of freedom. Members are those that elements declare
/// (ext/members.h), except members that are as stiff in compression as in tension. Nodes are those with the
/// output output::kGap. The switch between sticking and sliding on a bed at rest is left out.
Switches switches_at(const Scene& scene, Assembler& assembler, std::span<const double> x);

/// For a scene, which members are slack and which nodes touch the ground.
struct SwitchSides {
  std::size_t members = 0, slack = 0;   // all members, and those that are slack
  std::size_t nodes = 0, touching = 0;  // all nodes that can touch the ground, and those that touch it
};
SwitchSides sides_of(const Switches& at);

/// The number of switches that change sides, by part of the scene.
struct SwitchChanges {
  std::map<std::string, std::size_t> members, nodes;
  bool any() const { return !members.empty() || !nodes.empty(); }
};

/// The switches that change sides, to first order, if a number changes by ± `change`. `above` and `below` are
/// the switches of the equilibria at two values of the number whose difference is `distance`. A distance d in
/// `at` changes its sign in one of the two directions if
///   |dd/dp| change ≥ |d|,   dd/dp ≠ 0                                                    (1)
/// No changes if the scenes have different switches.
SwitchChanges switch_changes(const Scene& scene, const Switches& at, const Switches& above,
                             const Switches& below, double distance, double change);

}  // namespace netloft::studies
