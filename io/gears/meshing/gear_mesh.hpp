// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/gear.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace netloft::gears {

/// The fineness of a mesh, by number of nodes, by size, or by the knots of the netting; `nodes` counts the
/// whole modelled part.
struct Fineness {
  // every knot is a node, and both twines of every triangle run from knot to knot; `nodes` and `size` do not
  // count
  bool knots = false;
  std::size_t nodes = 2000;  // approximate number of nodes of ropes and netting
  double size = 0;           // if not 0, used instead of `nodes`: length of edges in the spread netting [m]
  // by panel or rope: the factor by which edges are shorter than elsewhere
  std::map<std::string, double> finer;
  bool operator==(const Fineness&) const = default;
};

/// Netting in triangles. Its own nodes are numbered from 0 and refer to nodes of the gear.
struct PanelMesh {
  std::vector<std::uint32_t> nodes;           // own number -> gear node
  std::vector<std::array<double, 2>> meshes;  // own number -> (U, V): meshes across, outwards, and deep, aft
  std::vector<std::uint32_t> triangles;       // 3 own nodes each, counter-clockwise seen from outside the net
  std::map<std::string, std::vector<std::uint32_t>> sets;  // edges (in the outline's direction) and corners
};

/// A rope in bars, from its start to its end.
struct RopeMesh {
  std::vector<std::uint32_t> nodes;  // own number -> gear node; own node i ends bar i-1
  std::vector<double> rest_lengths;  // of the bars [m]; they add up to the rope's length
  std::map<std::string, std::vector<std::uint32_t>> sets;  // start, middle (of a rope that has one), end
};

/// The quality of the triangles, measured in netting spread with an opening of one half.
struct MeshQuality {
  double least_angle = 0, greatest_angle = 0;  // [rad]
  std::size_t triangles = 0;
};

/// A gear divided into elements: a node on a seam, a hanging or a point is a single node by construction. No
/// positions yet (start_shape.hpp). Panels and ropes are in the order of the gear.
struct GearMesh {
  std::size_t nodes = 0;
  std::vector<PanelMesh> panels;
  std::vector<RopeMesh> ropes;
  std::map<std::string, std::uint32_t> points;  // "towing-point", "headrope.end", "top-wing.fore-outer"
  std::vector<std::uint32_t> middle;            // of the half: nodes on the plane of symmetry
  MeshQuality quality;
};

/// Called as a gear is divided, with the panel or step that begins and the number of nodes so far.
using OnMeshing = std::function<void(const std::string& step, std::size_t nodes)>;

/// Paper section 2.2: triangles between the knots of every panel, in coordinates counted in meshes.
///
/// The knots of netting that is spread with an opening of one half form a lattice of equilateral triangles.
/// Each triangle has one bar of each twine direction as a side, and every bar is a side of two triangles. The
/// energy of Priour's triangle, ½ bar of each direction, is then that of the bars themselves, twine by twine.
/// Only along borders, which are straight where cuttings go in steps, do triangles have other shapes. Throws
/// std::invalid_argument, with a sentence for the user, for a panel whose border crosses itself, and for a
/// size that would give millions of nodes.
GearMesh divide(const Gear& gear, const Fineness& fineness, const OnMeshing& on_meshing = {});

}  // namespace netloft::gears
