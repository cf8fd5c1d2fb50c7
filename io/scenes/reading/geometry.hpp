// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>

namespace netloft::scenes {

/// The geometry of a rigid body. Its nodes are its origin and its points.
/// A closed rim on which an edge of netting is hung: an ellipse in a plane across the body axis x.
struct BodyRim {
  std::string edge;  // of a panel of the net plan
  formats::Place place;
  std::array<double, 3> at = {};  // centre in body axes [m]
  double width = 0, height = 0;   // [m]
};

struct BodyGeometry {
  double side = 1;                             // 1: starboard; -1: port, with y of all body axes reversed
  std::array<double, 3> rotation = {};         // initial rotation vector [rad]
  std::uint8_t held_rotation = 0;              // bits of the components that cannot change
  std::vector<std::string> names;              // names of the points
  std::vector<std::array<double, 3>> r;        // positions of the points in body axes [m]
  std::vector<std::array<double, 3>> outline;  // a polygon in body axes, for pictures [m]
  std::optional<BodyRim> rim = {};
};

/// The nodes and elements of one part, and data of its elements, before parts are joined. "Own" numbers of
/// nodes are their numbers within the part, from 0.
struct Geometry {
  PartGeometry names;                   // sets of own nodes, panel coordinates; `nodes` stays empty
  std::vector<double> positions;        // 3 per own node [m]
  std::vector<std::uint32_t> elements;  // own nodes of each element
  ElementData data;
  /// Triangles between the bars of a panel in bars, on which pressure acts: the own nodes of each,
  /// counter-clockwise seen from outside, and its data.
  struct Faces {
    std::vector<std::uint32_t> nodes;
    ElementData data;
  } faces = {};
  std::optional<BodyGeometry> body = {};

  std::size_t node_count() const { return positions.size() / 3; }
};

/// A key of the scene that describes the position or shape of a part. A dot in the name marks a key within a
/// table.
struct GeometryKey {
  enum class Shape { real, integer, integers, points, named_points, word };
  std::string name, unit, doc;
  Shape shape;
  formats::Range range;
  formats::Count count;  // allowed number of integers or points
  bool required = true;
  std::vector<std::string> words = {};  // allowed words, the first one is the default
};

/// The shape of parts with elements of a type. It follows from what the type declares, never from its name:
/// elements on nodes make points, elements on bars make ropes, elements on triangles make panels, and
/// elements on bars with the datum `parallel` make panels in bars.
enum class Layout { point, line, panel_in_triangles, panel_in_bars, body };
Layout layout_of(const ElementType& type);

/// The geometry keys of parts with this layout.
const std::vector<GeometryKey>& geometry_keys(Layout layout);

/// The point on a line through one or more points, at the fraction `t` of its length.
std::array<double, 3> along_line(const std::vector<std::array<double, 3>>& line, double t);

/// Reads a part that is a single node. Its set is `point`; the data of its element are pieces = 1 and length
/// = 0 m.
Geometry read_point(formats::TableReader& part);

/// Reads a rope, divided into bars. Keys: `length` unstretched; `cells`, the number of bars; `sketch`, the
/// initial line through two or more points, along which nodes are spread evenly. Sets of nodes: start, end,
/// and middle (if the number of bars is even). Data of elements: rest_length [m].
Geometry read_line(formats::TableReader& part);

/// Reads a rectangle of netting, divided into triangles. Keys: `panel`, its size in meshes; `cells` across
/// and along; and either `sketch`, the initial corners fore left, fore right, aft right and aft left, or
/// `tube`. In cell (i, j) the diagonal runs from node (i,j) to node (i+1,j+1) if i+j is even, else between
/// the other two corners. With `division = "crossed"` a cell has both diagonals, that is four triangles
/// around its centre. Nodes are numbered row by row from the fore edge, j (across+1) + i, then the centres
/// row by row, (across+1)(along+1) + j across + i. Sets of nodes: fore, aft, left, right and the corners
/// fore-left … Data of elements: twine coordinates u, v [bars], bar_length [m], and to_aft, the meshes from
/// each corner to the aft edge. Netting of another orientation, such as square meshes, differs only in u and
/// v (io/gears/plan/twine_coordinates.hpp). A tube runs from the point `from` to the point `to`, with
/// `radius` at the fore edge and `radius_aft` at the aft edge. Its left and right edges meet on top (towards
/// +x for an upright tube). From the left edge to the right one, nodes run clockwise for an observer who
/// looks aft; the corners of triangles are then counter-clockwise seen from outside.
Geometry read_panel(formats::TableReader& part);

/// Reads a rectangle of diamond netting, divided into bars along its twines, from the keys of read_panel(). A
/// cell of m by m meshes has nodes at its four corners and its centre, and a bar from the centre to each
/// corner, in the order fore left, fore right, aft right, aft left. Each bar stands for m parallel twines
/// (`parallel`) of m mesh bars each, where `bar` is the length of a mesh bar:
///   rest_length = m bar,  parallel = m                                                              (1)
/// The total length of twine (2) is that of the panel for every m. No bar lies on an edge, so that edges need
/// no special bars. With m = 1, nodes are the knots and bars the bars of the net. Cells must be square in
/// meshes; otherwise their bars would run across twines. Nodes and sets are those of
/// read_panel() with crossed cells, but sets have no centres. Data of elements: rest_length [m], parallel.
/// Faces (Geometry::Faces): four triangles per cell, from its centre to each side, with to_aft as in
/// read_panel().
Geometry read_panel_in_bars(formats::TableReader& part);

}  // namespace netloft::scenes
