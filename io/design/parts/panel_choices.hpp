// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/parts/gear_parts.hpp"

namespace netloft::design {

/// The fore and aft edges at which a panel can be added.
std::vector<std::string> edges_of(const gears::NetPlan& plan);

/// The properties of a panel that follow from the edge to which it is sewn: its cloth, counts and edges, and
/// the cuttings with which it closes, in several ways, the best first. If the edge is declared open, it is
/// not any more, and the other edge of the panel is. Throws Refused.
struct PanelAtEdge {
  formats::Value root;
  std::vector<PartChoices> ways;
};
PanelAtEdge panel_at_edge(const PartedGear& gear, const PartChoices& choices);

}  // namespace netloft::design
