// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/gear.hpp"

#include <array>
#include <cstdint>
#include <map>
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
  // Factors by which triangle sides and bars of single panels or ropes are shorter than elsewhere.
  std::map<std::string, double> finer;
  bool operator==(const Fineness&) const = default;
};

/// A panel divided into triangles. Its nodes are numbered from 0; each of them is also a node of the gear.
struct PanelMesh {
  // For each node of the panel: its number in the gear, and (U, V), counted in meshes outwards and aft.
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

/// A gear divided into elements: everything that meets at a point of a seam or a hanging shares one node
/// there. The mesh has no positions yet (start_shape.hpp). Panels and ropes have the order of the gear.
struct GearMesh {
  std::size_t nodes = 0;
  std::vector<PanelMesh> panels;
  std::vector<RopeMesh> ropes;
  std::map<std::string, std::uint32_t> points;  // points by name, such as "headrope.end"
  std::vector<std::uint32_t> middle;            // nodes on the plane of symmetry, in half a gear
  MeshQuality quality;
};

/// Divides every panel into triangles, in coordinates counted in meshes (section 2.2 of the trawl-gear
/// paper), and ropes into bars.
///
/// If every knot is a node, the triangles in half-open netting (bars at 30 degrees to the aft direction) are
/// equilateral. Two sides of each triangle are bars, one of each twine direction, and every bar is a side of
/// two triangles. Priour's triangle has the energy of half a bar of each direction, so the triangles together
/// have exactly the energy of the bars. Triangles have other shapes only along borders, which are straight
/// instead of stepped.
///
/// Throws std::invalid_argument, with a sentence for the user, for a panel whose border crosses itself, and
/// for a size that would give millions of nodes.
GearMesh divide(const Gear& gear, const Fineness& fineness);

}  // namespace netloft::gears
