// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>

namespace netloft::scenes {

/// The geometry of a rigid body. Its own nodes are its origin and its points.
struct BodyGeometry {
  double side = 1;                             // 1: starboard; -1: port, with y of its axes reversed
  std::array<double, 3> rotation = {};         // initial rotation vector [rad]
  std::uint8_t held_rotation = 0;              // bits of the components that cannot change
  std::vector<std::string> names;              // names of its points
  std::vector<std::array<double, 3>> r;        // positions of its points in its own axes [m]
  std::vector<std::array<double, 3>> outline;  // a polygon in its own axes, for pictures [m]
};

/// The geometry of a part with nodes of its own before parts are joined: nodes, elements and their data.
struct Geometry {
  PartGeometry names;                   // sets and panel coordinates; `nodes` is left empty
  std::vector<double> positions;        // 3 per own node [m]
  std::vector<std::uint32_t> elements;  // own nodes of each element, in the order of its stencil
  ElementData data;
  /// Triangles between the bars of a panel, for pressure on netting: own nodes, counter-clockwise seen from
  /// outside, and data per triangle.
  struct Faces {
    std::vector<std::uint32_t> nodes;
    ElementData data;
  } faces = {};
  std::optional<BodyGeometry> body = {};

  std::size_t node_count() const { return positions.size() / 3; }
};

/// A key that describes the position and shape of a part. A dot in the name marks a key within a table.
struct GeometryKey {
  enum class Shape { real, integer, integers, points, named_points, word };
  std::string name, unit, doc;
  Shape shape;
  formats::Range range;
  formats::Count count;  // allowed number of integers or points
  bool required = true;
  std::vector<std::string> words = {};  // allowed, the first being the default
};

/// The shape of the parts of an element type. It follows from what the type declares, never from its name:
/// elements on nodes are points, on bars ropes, on triangles panels; elements on bars that declare the datum
/// datum::kParallel are panels in bars.
enum class Layout { point, line, panel_in_triangles, panel_in_bars, body };
Layout layout_of(const ElementType& type);

/// The geometry keys of parts with this layout.
const std::vector<GeometryKey>& geometry_keys(Layout layout);

/// The point at fraction `t` of the length of a line through one or more points.
std::array<double, 3> along_line(const std::vector<std::array<double, 3>>& line, double t);

/// Reads a point: one node. Set: point. Data: pieces [1], which is one; length [m], which is zero.
Geometry read_point(formats::TableReader& part);

/// Reads a rope in bars: `length` is unstretched, `cells` is the number of bars, and `sketch` is a line of
/// two or more points along which the nodes are spread evenly. Sets: start, end, and middle (with an even
/// number of bars). Data: rest_length [m].
Geometry read_line(formats::TableReader& part);

/// Reads a rectangle of netting in triangles, as in section 2.2 of the paper for a panel cut along meshes.
/// Keys: `panel` in meshes; `cells` across and along; and either `sketch`, the corners fore left, fore right,
/// aft right and aft left, or `tube`. In cell (i, j) the diagonal runs (i,j)-(i+1,j+1) if i+j is even; with
/// `division = "crossed"` a cell has both diagonals, that is four triangles around its centre. Nodes are
/// numbered row by row from the fore edge, j (across+1) + i, then the centres row by row, (across+1)(along+1)
/// + j across + i. Sets: fore, aft, left, right and the corners fore-left … Data: u, v [bars], bar_length
/// [m], and to_aft, the meshes from each corner to the aft edge. Netting of another orientation differs only
/// in (u, v), which follow from the meshes across and along: io/gears/plan/twine_coordinates.hpp (1).
/// A tube runs `from` a point `to` another, with `radius` at the fore edge and `radius_aft` at the aft edge.
/// Its left and right edges lie on the same line on top (towards +x for an upright tube); from left to right,
/// the nodes turn clockwise for an observer who looks aft, so that corners are counter-clockwise seen from
/// outside.
Geometry read_panel(formats::TableReader& part);

/// Reads the same panel in bars along the twines of diamond netting, from the same keys. A cell of m by m
/// meshes, m = across/cells across = along/cells along, has its four corners and its centre as nodes, and a
/// bar from the centre to each corner, in the order fore left, fore right, aft right, aft left:
///   rest_length = m bar,  parallel = m                                                              (1)
///   4 rest_length parallel = 4 m² bar, the bars of m² meshes                                        (2)
/// The total length of twine is therefore that of the panel for every division; no bar lies on an edge, so
/// edges need no special bars. With m = 1, nodes are the knots and bars the bars of the net. Cells that are
/// not square in meshes are refused: their bars would run across twines.
/// Nodes and sets are those of read_panel with crossed cells; sets contain corners only. Data: rest_length
/// [m], parallel. Faces: four triangles per cell, from its centre to each side, with to_aft as in read_panel.
Geometry read_panel_in_bars(formats::TableReader& part);

}  // namespace netloft::scenes
