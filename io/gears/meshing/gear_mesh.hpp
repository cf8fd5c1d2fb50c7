// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/triangulation.hpp"
#include "io/gears/plan/gear.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace netloft::gears {

/// The fineness of a mesh, by number of nodes, by size, or by the knots of the netting.
struct Fineness {
  // Whether every knot is a node, and both twines of every triangle run from knot to knot; `nodes` and `size`
  // are then ignored.
  bool knots = false;
  std::size_t nodes = 2000;  // approximate number of nodes of ropes and netting in the modelled part
  double size = 0;           // length of triangle sides in half-open netting [m]; if not 0, replaces `nodes`
  // Factors by which triangle sides of the named panels, or bars of the named ropes, are shorter than
  // elsewhere.
  std::map<std::string, double> finer;
  bool operator==(const Fineness&) const = default;
};

/// A panel divided into triangles. Its nodes are numbered from 0; each of them is also a node of the gear.
struct PanelMesh {
  // For each node of the panel: its number in the gear, and its coordinates (U, V) outwards and aft [meshes].
  std::vector<std::uint32_t> nodes;
  std::vector<std::array<double, 2>> meshes;
  std::vector<std::uint32_t> triangles;  // 3 nodes of the panel each, counter-clockwise seen from outside
  // Nodes of the panel along its edges, in the direction of the outline, and at its corners.
  std::map<std::string, std::vector<std::uint32_t>> sets;
};

/// A rope divided into bars, from its start to its end. Its nodes are numbered from 0; node i ends bar i-1.
struct RopeMesh {
  std::vector<std::uint32_t> nodes;  // for each node of the rope: its number in the gear
  std::vector<double> rest_lengths;  // unstretched lengths of the bars [m]; their sum is the rope's length
  std::map<std::string, std::vector<std::uint32_t>> sets;  // nodes at start, middle (if any) and end
};

/// The quality of the triangles in half-open netting, whose bars are at 30 degrees to the aft direction.
struct MeshQuality {
  double least_angle = 0, greatest_angle = 0;  // [rad]
  std::size_t triangles = 0;
};

/// All decisions of a division. With them, a gear with slightly different lengths and counts gets a mesh with
/// the same nodes and elements, only in other places.
struct MeshTopology {
  double size = 0;                               // size of elements in half-open netting [m]
  std::size_t points = 0;                        // number of points at which lines of knots end
  std::vector<std::array<std::size_t, 2>> ends;  // of each line of knots: the points at its ends
  std::vector<std::vector<double>> fractions;    // of each line: fractions of its length at its inner nodes
  // For each cloth, its triangles [meshes]. The first points are those of its border.
  std::vector<PlaneMesh> cloths;
  std::vector<std::size_t> borders;  // for each cloth, the number of points of its border
};

/// A gear divided into elements. Panels and ropes that meet at a point of a seam or a hanging share one node
/// there. The mesh has no positions yet (start_shape.hpp). Panels and ropes are in the order of the gear.
struct GearMesh {
  std::size_t nodes = 0;
  std::vector<PanelMesh> panels;
  std::vector<RopeMesh> ropes;
  std::map<std::string, std::uint32_t> points;  // points by name, such as "headrope.end"
  std::vector<std::uint32_t> middle;            // nodes on the plane of symmetry, in half a gear
  std::shared_ptr<const MeshTopology> topology;
};

/// Divides every panel into triangles, in panel coordinates [meshes] (section 2.2 of the trawl-gear paper),
/// and every rope into bars.
///
/// If every knot is a node, the triangles in half-open netting (bars at 30 degrees to the aft direction) are
/// equilateral. Two sides of each triangle are bars, one of each twine direction, and every bar is a side of
/// two triangles. Priour's triangle has the energy of half a bar of each direction. The triangles together
/// therefore have exactly the energy of the bars. Only triangles along borders have other shapes, because
/// borders are straight instead of stepped.
///
/// Throws std::invalid_argument, with a sentence for the user, for a panel whose border crosses itself, and
/// for a size that would give millions of nodes.
GearMesh divide(const Gear& gear, const Fineness& fineness);

MeshQuality quality_of(const Gear& gear, const GearMesh& mesh);

/// Divides a gear in the same way as another one, whose mesh has the topology `like`. Lines are divided at
/// the same fractions, and inner nodes of panels move with the border of their panel (moved_with_border() in
/// triangulation.hpp), so that the mesh is a smooth function of the lengths and counts of the gear. Throws
/// std::invalid_argument, with a sentence for the user, if the order of corners along a seam would change, or
/// a triangle would turn over.
GearMesh divide_alike(const Gear& gear, const Fineness& fineness, const MeshTopology& like);

}  // namespace netloft::gears
