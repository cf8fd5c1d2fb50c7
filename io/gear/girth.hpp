// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/gear_mesh.hpp"

#include <vector>

namespace netloft::io {

/// Where nodes lie on the bag of a net: how far aft, how far round from the top, and on which side. Fields
/// (1) and (2) of start_shape.hpp.
class Girth {
 public:
  Girth(const Gear& gear, const GearMesh& mesh);

  /// Whether netting, or a rope that netting hangs on, has this node.
  bool covers(std::uint32_t node) const { return covered_[node]; }
  double aft(std::uint32_t node) const { return aft_[node]; }        // a [m]
  double around(std::uint32_t node) const { return around_[node]; }  // s [m]
  int side(std::uint32_t node) const { return side_[node]; }         // −1 to port, else 1
  /// Whether an end of the bag that is sewn to itself has it.
  bool is_closed(std::uint32_t node) const { return closed_[node]; }
  /// S [m] where this node is: by its own way to the middle of a lower panel, else by the nearest such so far
  /// aft.
  double half_girth(std::uint32_t node) const;

 private:
  void find_senses(const Gear& gear);
  void find_closed(const Gear& gear, const GearMesh& mesh);
  void find_sides(const Gear& gear, const GearMesh& mesh);
  void solve_fields(const Gear& gear, const GearMesh& mesh);
  void measure_bottom(const Gear& gear, const GearMesh& mesh);

  std::vector<int> sense_;  // by panel: the sign in (2)
  std::vector<double> aft_, around_;
  std::vector<double> own_;  // S by its own way; 0: it has none
  std::vector<int> side_;
  std::vector<bool> covered_, closed_;
  std::vector<std::pair<double, double>> bottom_;  // (a, S), ascending in a
};

}  // namespace netloft::io
