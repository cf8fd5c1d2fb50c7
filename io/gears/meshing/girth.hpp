// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <vector>

namespace netloft::gears {

/// Positions of nodes on the bag of a net: distance aft, distance along the girth from the top, and side.
/// start_shape.hpp explains these fields in its equations (1) and (2).
class Girth {
 public:
  Girth(const Gear& gear, const GearMesh& mesh);

  /// Whether the node belongs to netting or to a rope on which netting is hung.
  bool covers(std::uint32_t node) const { return covered_[node]; }
  double aft(std::uint32_t node) const { return aft_[node]; }        // distance aft, a [m]
  double around(std::uint32_t node) const { return around_[node]; }  // distance around, s [m]
  int side(std::uint32_t node) const {
    return side_[node];
  }  // -1: port, 0: on the plane of symmetry, 1: starboard
  /// Whether the node belongs to an end of the bag that is sewn to itself.
  bool is_closed(std::uint32_t node) const { return closed_[node]; }
  /// Half the girth at a node [m]: the distance along the girth through this node, from the top to the middle
  /// of the lower panel. If it is unknown at the node's distance aft, it is interpolated between known ones.
  double half_girth(std::uint32_t node) const;

 private:
  void find_layers(const Gear& gear, const GearMesh& mesh);
  void find_senses(const Gear& gear);
  void find_closed(const Gear& gear, const GearMesh& mesh);
  void find_sides(const Gear& gear, const GearMesh& mesh);
  void solve_fields(const Gear& gear, const GearMesh& mesh);
  void find_folds(const Gear& gear);
  bool is_below(const Gear& gear, const EdgeRef& fold) const;
  void measure_bottom(const Gear& gear, const GearMesh& mesh);
  void measure_below(const Gear& gear, const GearMesh& mesh, const EdgeRef& fold);

  std::vector<int> sense_;  // for each panel: 1 if the distance from the top increases outwards, otherwise -1
  // For each panel, the side edges that are sewn to their mirror image. The girth begins or ends there, in
  // the middle.
  std::vector<std::vector<EdgeRef>> folds_;
  std::vector<double> aft_, around_;
  std::vector<double> own_;  // half girth through each node [m]; 0: not known
  std::vector<int> side_;
  std::vector<bool> covered_, closed_;
  // The layer of netting of each panel and of each node. Panels within others, or around them, are layers of
  // their own (Seam::is_of_layer); all other panels are layer 0.
  std::vector<std::size_t> layer_, layer_of_node_;
  // For each layer: distance aft and half girth, in ascending order.
  std::vector<std::vector<std::pair<double, double>>> bottom_;
};

}  // namespace netloft::gears
