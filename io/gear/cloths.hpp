// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/gear.hpp"

#include <map>

namespace netloft::io {

/// One side of a cloth: an edge of an outline, or of one that lies across the middle a half.
struct ClothSide {
  std::size_t cloth = 0;
  EdgeRef edge;              // unused of the line on which both halves of a middle panel meet
  bool is_inside = false;    // this line
  bool is_reversed = false;  // runs against the outline's edge
  EdgeKind kind{};
  bool goes_aft = false;              // of outer and inner sides
  PanelPoint from, to;                // x outwards on either side of the gear
  double edge_from = 0, edge_to = 1;  // the share of the edge, in its direction
  double meshes = 0, stretched = 0;   // as counted; its twines pulled straight [m]
  double length = 0;                  // where netting is spread [m]

  bool is_across() const { return kind == EdgeKind::fore || kind == EdgeKind::aft; }
};

/// A panel without symmetry: a pair's or a single one, or one half of a middle panel. Sides follow one
/// another counter-clockwise in x outwards, y aft, from the fore inner corner on, so that what is to port has
/// the same numbers as what is to starboard.
struct Cloth {
  std::size_t panel = 0;
  bool is_port = false;
  double sign = 1;                             // of its x in the outline
  std::vector<std::size_t> sides;              // numbers of Cloths::sides
  std::map<std::string, std::size_t> corners;  // "fore-outer" -> the side that starts there
};

/// Coordinates of netting that is spread with an opening of one half: bars stand at 30 degrees to the aft
/// direction, x = U m sin 30°, y = V m cos 30°. Square netting, and netting that is turned, as squares.
PanelPoint spread(const Panel& panel, PanelPoint point);

struct Cloths {
  std::vector<Cloth> cloths;
  std::vector<ClothSide> sides;
};

Cloths cloths_of(const Gear& gear);

}  // namespace netloft::io
