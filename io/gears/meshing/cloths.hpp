// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/gear.hpp"

#include <map>

namespace netloft::gears {

/// One side of a cloth (a piece of netting, see Cloth): an edge of an outline, or half of an edge that
/// crosses the middle.
struct ClothSide {
  std::size_t cloth = 0;
  EdgeRef edge;              // edge of the outline; unused if `is_inside`
  bool is_inside = false;    // whether it is the line between both halves of a middle panel
  bool is_reversed = false;  // whether it runs against the direction of the edge of the outline
  EdgeKind kind{};
  bool is_on_plane = false;           // whether it is on the plane of symmetry of half a gear
  bool goes_aft = false;              // whether it is an outer or inner side that runs aft
  PanelPoint from, to;                // ends of the side; x is outwards on either side of the gear
  double edge_from = 0, edge_to = 1;  // part of the edge, as fractions in the direction of the edge
  double meshes = 0, stretched = 0;   // counted meshes; length of its straight twines [m]
  double length = 0;                  // length in half-open netting [m]

  bool is_across() const { return kind == EdgeKind::fore || kind == EdgeKind::aft; }
};

/// A piece of netting without symmetry: a panel of a pair, a single panel, or one half of a middle panel. Its
/// sides are listed counter-clockwise, with x outwards and y aft, from the inner fore corner, so that
/// corresponding sides to port and to starboard have the same index.
struct Cloth {
  std::size_t panel = 0;
  bool is_port = false;
  double sign = 1;                             // the sign of its x in the outline
  std::vector<std::size_t> sides;              // indices in Cloths::sides
  std::map<std::string, std::size_t> corners;  // "fore-outer" -> the side that starts there
};

/// Returns the position [m] of a point of a panel in half-open netting, whose bars are at 30 degrees to the
/// aft direction: x = U m sin 30°, y = V m cos 30°, where U, V [meshes] are the coordinates across and deep,
/// and m [m] is the mesh size. In square netting and turned netting, meshes are opened to squares instead.
PanelPoint spread(const Panel& panel, PanelPoint point);

struct Cloths {
  std::vector<Cloth> cloths;
  std::vector<ClothSide> sides;
  std::map<std::size_t, std::vector<std::size_t>> of_panel;  // the sides of each panel, in increasing order
};

Cloths cloths_of(const Gear& gear);

}  // namespace netloft::gears
