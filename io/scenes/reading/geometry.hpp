// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>

namespace netloft::scenes {

/// How a rigid body is made: its own nodes are its origin and its points.
struct BodyGeometry {
  double side = 1;                             // 1 to starboard, -1 to port: y of its axes is reversed
  std::array<double, 3> rotation = {};         // at the start [rad]
  std::uint8_t held_rotation = 0;              // components that cannot change
  std::vector<std::string> names;              // of its points
  std::vector<std::array<double, 3>> r;        // of its points, in its own axes [m]
  std::vector<std::array<double, 3>> outline;  // a polygon in its own axes, for pictures [m]
};

/// A part on nodes of its own: what an element type needs to stand on, before parts are joined.
struct Geometry {
  PartGeometry names;                   // sets and panel coordinates; `nodes` is left empty
  std::vector<double> positions;        // 3 per own node [m]
  std::vector<std::uint32_t> elements;  // own nodes, as many each as the stencil has
  ElementData data;
  /// Triangles between the bars of a panel, for what presses on netting: own nodes, outer face
  /// counter-clockwise; data per triangle.
  struct Faces {
    std::vector<std::uint32_t> nodes;
    ElementData data;
  } faces = {};
  std::optional<BodyGeometry> body = {};

  std::size_t node_count() const { return positions.size() / 3; }
};

/// A key with which a part says where it stands; a dot is a table within.
struct GeometryKey {
  enum class Shape { real, integer, integers, points, named_points, word };
  std::string name, unit, doc;
  Shape shape;
  formats::Range range;
  formats::Count count;  // of integers or points
  bool required = true;
  std::vector<std::string> words = {};  // allowed, the first being the default
};

/// How parts of an element type stand in space. Told by what the type declares, never by its name: elements
/// on nodes are points, on bars ropes, on triangles panels; elements on bars that declare the datum
/// datum::kParallel are panels in bars.
enum class Layout { point, line, panel_in_triangles, panel_in_bars, body };
Layout layout_of(const ElementType& type);

/// The keys of parts that stand so.
const std::vector<GeometryKey>& geometry_keys(Layout layout);

/// The point at fraction `t` of the length of a line through one or more points.
std::array<double, 3> along_line(const std::vector<std::array<double, 3>>& line, double t);

/// A point: one node. Set: point. Data: pieces [1], one; length [m], none.
Geometry read_point(formats::TableReader& part);

/// A rope in bars: `length` unstretched, `cells` bars, `sketch` a line of two or more points along which the
/// nodes are spread evenly. Sets: start, end, middle (with an even number of bars). Data: rest_length [m].
Geometry read_line(formats::TableReader& part);

/// A rectangle of netting in triangles, the paper's section 2.2 for a panel cut along meshes: `panel` in
/// meshes, `cells` across and along, `sketch` four corners: fore left, fore right, aft right, aft left; or
/// `tube` instead of it. In cell (i, j) the diagonal runs (i,j)-(i+1,j+1) if i+j is even; with
/// `division = "crossed"` a cell has both, four triangles about its centre. Nodes are row by row from the
/// fore edge: j (across+1) + i, then centres row by row: (across+1)(along+1) + j across + i. Sets: fore, aft,
/// left, right and the corners fore-left … Data: u, v [bars], bar_length [m], to_aft, meshes from each corner
/// to the aft edge. Netting that is hung otherwise differs by nothing but (u, v), which follow from the
/// meshes across and along: io/gears/plan/twine_coordinates.hpp (1).
/// A tube runs `from` a point `to` another, `radius` wide at the fore edge and `radius_aft` at the aft one.
/// Left edge and right edge lie on the same line, on top (towards +x for a tube that stands upright); from
/// one to the other the nodes turn clockwise as seen by one who looks aft, so that corners are
/// counter-clockwise seen from outside.
Geometry read_panel(formats::TableReader& part);

/// The same panel in bars along the twines of diamond netting, from the same keys. A cell of m by m meshes,
/// m = across/cells across = along/cells along, has its four corners and its centre as nodes, and a bar from
/// the centre to each corner, in the order fore left, fore right, aft right, aft left:
///   rest_length = m bar,  parallel = m                                                              (1)
///   4 rest_length parallel = 4 m² bar, the bars of m² meshes                                        (2)
/// so that the length of all twines is that of the panel whatever the cells; no bar lies on an edge, none is
/// special there. With m = 1 nodes are the knots and bars the bars of the net. Cells that are not square in
/// meshes are refused: their bars would run across twines.
/// Nodes as in read_panel, cells crossed. Sets as in read_panel, of corners. Data: rest_length [m], parallel.
/// Faces: four triangles a cell, from its centre to each side, with to_aft as in read_panel.
Geometry read_panel_in_bars(formats::TableReader& part);

}  // namespace netloft::scenes
