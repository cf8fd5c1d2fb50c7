// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace netloft::gears {

/// The area of an outline by the shoelace formula.
inline double outline_area(const Outline& outline) {
  double sum = 0;
  for (const auto& e : outline.edges) sum += (e.from.x * e.to.y - e.to.x * e.from.y) / 2;
  return sum;
}

inline double triangle_area(const PanelMesh& panel, std::size_t triangle) {
  std::array<std::array<double, 2>, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = panel.meshes[panel.triangles[3 * triangle + k]];
  return ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])) / 2;
}

/// Faults of triangles that do not fill the outline of their panel exactly once: the sum of the signed areas
/// and the sum of the unsigned areas must both be the area of the outline.
inline std::vector<std::string> area_faults(const Gear& gear, const GearMesh& mesh) {
  std::vector<std::string> faults;
  for (std::size_t p = 0; p < gear.panels.size(); ++p) {
    double sum = 0, turned = 0;
    for (std::size_t t = 0; t < mesh.panels[p].triangles.size() / 3; ++t) {
      sum += std::abs(triangle_area(mesh.panels[p], t));
      turned += triangle_area(mesh.panels[p], t);
    }
    const double expected = outline_area(gear.panels[p].outline);
    for (const double area : {sum, std::abs(turned)})
      if (!(std::abs(area - expected) <= 1e-9 * expected))
        faults.push_back(gear.panels[p].name + ": triangles of " + std::to_string(area) +
                         " square meshes in " + std::to_string(expected));
  }
  return faults;
}

using Side = std::pair<std::uint32_t, std::uint32_t>;

/// How often each directed side, from one node of the gear to the next around a triangle, occurs in the mesh.
inline std::map<Side, int> directed_sides(const GearMesh& mesh) {
  std::map<Side, int> sides;
  for (const auto& panel : mesh.panels)
    for (std::size_t t = 0; t < panel.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k)
        ++sides[{panel.nodes[panel.triangles[t + k]], panel.nodes[panel.triangles[t + (k + 1) % 3]]}];
  return sides;
}

/// The triangle sides along edges that are not sewn.
inline std::set<Side> free_sides(const Gear& gear, const GearMesh& mesh) {
  std::set<std::pair<std::size_t, std::size_t>> sewn;
  for (const auto& seam : gear.seams)
    for (const auto& row : seam.edges)
      for (const auto& ref : row) sewn.insert({ref.panel, ref.edge});
  std::set<Side> sides;
  for (std::size_t p = 0; p < gear.panels.size(); ++p)
    for (std::size_t e = 0; e < gear.panels[p].outline.edges.size(); ++e) {
      const auto& own = mesh.panels[p].sets.at(gear.panels[p].outline.edges[e].name);
      for (std::size_t k = 0; !sewn.contains({p, e}) && k + 1 < own.size(); ++k)
        sides.insert(std::minmax(mesh.panels[p].nodes[own[k]], mesh.panels[p].nodes[own[k + 1]]));
    }
  return sides;
}

/// Faults of a mesh with holes or folds. In a net without such faults, two triangles share each side, in
/// opposite directions because they show the same face outwards; a side on a free edge has one triangle.
inline std::vector<std::string> seam_faults(const Gear& gear, const GearMesh& mesh) {
  std::vector<std::string> faults;
  const auto sides = directed_sides(mesh);
  const auto free = free_sides(gear, mesh);
  std::size_t free_seen = 0;
  for (const auto& [side, times] : sides) {
    const std::string name = std::to_string(side.first) + " to " + std::to_string(side.second);
    const bool is_free = free.contains(std::minmax(side.first, side.second)),
               has_other = sides.contains({side.second, side.first});
    if (side.first == side.second) faults.push_back(name + " has no length");
    if (times > 1) faults.push_back(name + " is a side of two triangles in the same direction");
    if (is_free && has_other) faults.push_back(name + " is free, and sewn");
    if (!is_free && !has_other) faults.push_back(name + " is sewn to nothing");
    free_seen += is_free;
  }
  if (free_seen != free.size()) faults.push_back("sides of a single triangle are not those on free edges");
  return faults;
}

}  // namespace netloft::gears
