// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/girth.hpp"

#include "io/gears/meshing/equal_points.hpp"
#include "io/gears/meshing/knot_graph.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace netloft::gears {

namespace {

const double kTowedHalfAngle = std::numbers::pi / 8;  // angle β of start_shape.hpp; sin β = 0.38
constexpr double kRopeWeight = 1e-4;                  // weight of a bar relative to a side of a triangle

bool is_lateral(EdgeKind kind) { return kind == EdgeKind::outer || kind == EdgeKind::inner; }

EdgeKind kind_of(const Gear& gear, const EdgeRef& ref) {
  return gear.panels[ref.panel].outline.edges[ref.edge].kind;
}

/// Whether a seam closes an end of the net: it joins two fore edges or two aft edges of different panels.
bool closes(const Gear& gear, const Seam& seam) {
  if (seam.edges[0].empty() || seam.edges[1].empty() || seam.is_to_itself) return false;
  const EdgeKind one = kind_of(gear, seam.edges[0][0]), other = kind_of(gear, seam.edges[1][0]);
  return one == other && !is_lateral(one);
}

/// Whether two edges are the same edge of a pair of panels, to starboard and to port.
bool are_mirror_images(const Gear& gear, const EdgeRef& one, const EdgeRef& other) {
  const GearPanel &a = gear.panels[one.panel], &b = gear.panels[other.panel];
  return a.panel == b.panel && a.is_mirrored != b.is_mirrored && kind_of(gear, one) == kind_of(gear, other);
}

/// Whether the outward direction of panel `one` continues across the seam as the inward direction of panel
/// `other`. In a panel and in its mirror image, outwards means away from the middle.
bool turns(const Gear& gear, const Seam& seam, const EdgeRef& one, const EdgeRef& other) {
  if (are_mirror_images(gear, one, other)) return false;
  const auto comes_back = [&](const EdgeRef& ref) {
    return gear.last_of_ring(seam.edges[0]) == ref.panel || gear.last_of_ring(seam.edges[1]) == ref.panel;
  };
  const EdgeKind a = kind_of(gear, one), b = kind_of(gear, other);
  return (a == b && is_lateral(a)) != (comes_back(one) != comes_back(other));
}

/// The coordinate U outwards [meshes], from the middle in a middle panel, otherwise from the start of the
/// inner side.
double outwards(const GearPanel& panel, double U) {
  return panel.panel->stands == Standing::middle ? std::abs(U) : U;
}

bool is_to_port(const GearPanel& panel, double U) {
  return panel.panel->stands == Standing::middle ? U < 0 : panel.is_mirrored;
}

}  // namespace

Girth::Girth(const Gear& gear, const GearMesh& mesh)
    : sense_(gear.panels.size(), 0),
      folds_(gear.panels.size()),
      side_(mesh.nodes, 1),
      covered_(mesh.nodes, false),
      closed_(mesh.nodes, false) {
  find_layers(gear, mesh);
  find_senses(gear);
  find_folds(gear);
  find_sides(gear, mesh);
  find_closed(gear, mesh);
  solve_fields(gear, mesh);
  measure_bottom(gear, mesh);
}

void Girth::find_layers(const Gear& gear, const GearMesh& mesh) {
  EqualPoints sewn;  // panels that are sewn to each other, other than as a further layer
  for (std::size_t p = 0; p < gear.panels.size(); ++p) sewn.add();
  const auto unite = [&](const Seam& seam) {
    for (const auto& row : seam.edges)
      for (const auto& ref : row) sewn.unite(seam.edges[0].front().panel, ref.panel);
  };
  for (const auto& seam : gear.seams)
    if (!seam.is_of_layer && !seam.edges[0].empty()) unite(seam);
  std::map<std::size_t, std::size_t> layers;
  for (const auto& seam : gear.seams)
    for (const auto& ref : seam.edges[1])
      if (seam.is_of_layer && !sewn.are_one(seam.edges[0].front().panel, ref.panel))
        layers.emplace(sewn.root(ref.panel), layers.size() + 1);
  bottom_.resize(layers.size() + 1);
  layer_of_node_.assign(mesh.nodes, 0);
  for (std::size_t p = 0; p < gear.panels.size(); ++p) {
    const auto own = layers.find(sewn.root(p));
    layer_.push_back(own == layers.end() ? 0 : own->second);
  }
  for (std::size_t p = gear.panels.size(); p-- > 0;)  // a common node belongs to the first of its panels
    for (const auto node : mesh.panels[p].nodes) layer_of_node_[node] = layer_[p];
}

/// Finds for each panel whether the distance from the top, measured along the girth, increases outwards (+1)
/// or decreases outwards (-1). Follows the seams from the first panel, which is assumed to be on top.
void Girth::find_senses(const Gear& gear) {
  std::vector<std::vector<const Seam*>> seams(gear.panels.size());  // seams of each panel
  for (const auto& seam : gear.seams)
    for (const auto& row : seam.edges)
      for (const auto& ref : row)
        if (!closes(gear, seam) && (seams[ref.panel].empty() || seams[ref.panel].back() != &seam))
          seams[ref.panel].push_back(&seam);
  for (std::size_t first = 0; first < sense_.size(); ++first) {
    if (sense_[first]) continue;
    sense_[first] = 1;
    std::vector<std::size_t> reached{first};
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (const Seam* seam : seams[reached[k]])
        for (const int way : {0, 1})
          for (const auto& from : seam->edges[static_cast<std::size_t>(way)])
            for (const auto& to : seam->edges[static_cast<std::size_t>(1 - way)]) {
              if (from.panel != reached[k] || sense_[to.panel]) continue;
              sense_[to.panel] = turns(gear, *seam, from, to) ? -sense_[from.panel] : sense_[from.panel];
              reached.push_back(to.panel);
            }
  }
}

void Girth::find_closed(const Gear& gear, const GearMesh& mesh) {
  for (const auto& seam : gear.seams) {
    const bool is_fold = seam.is_to_itself && !is_lateral(kind_of(gear, seam.edges[0][0]));
    if (!closes(gear, seam) && !is_fold) continue;
    for (const auto& ref : seam.edges[0]) {
      const PanelMesh& panel = mesh.panels[ref.panel];
      const auto& name = gear.panels[ref.panel].outline.edges[ref.edge].name;
      if (const auto set = panel.sets.find(name); set != panel.sets.end())
        for (const auto own : set->second) {
          if (is_fold)
            side_[panel.nodes[own]] = 0;
          else
            closed_[panel.nodes[own]] = true;
        }
    }
  }
}

/// Finds on which side every node of the netting lies: -1 to port, 1 to starboard. Other nodes keep 1.
void Girth::find_sides(const Gear& gear, const GearMesh& mesh) {
  for (std::size_t p = 0; p < mesh.panels.size(); ++p)
    for (std::size_t own = 0; own < mesh.panels[p].nodes.size(); ++own) {
      side_[mesh.panels[p].nodes[own]] = is_to_port(gear.panels[p], mesh.panels[p].meshes[own][0]) ? -1 : 1;
      covered_[mesh.panels[p].nodes[own]] = true;
    }
}

void Girth::solve_fields(const Gear& gear, const GearMesh& mesh) {
  std::vector<Gain> aft, around;
  std::vector<std::pair<std::uint32_t, double>> start, top;
  for (std::size_t p = 0; p < mesh.panels.size(); ++p) {
    const PanelMesh& panel = mesh.panels[p];
    const double size = gear.panels[p].panel->mesh;
    const double deep = std::cos(kTowedHalfAngle) * size, wide = std::sin(kTowedHalfAngle) * size;
    for (std::size_t t = 0; t + 2 < panel.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = panel.triangles[t + k], j = panel.triangles[t + (k + 1) % 3];
        const auto from = panel.nodes[i], to = panel.nodes[j];
        aft.push_back({from, to, deep * (panel.meshes[j][1] - panel.meshes[i][1]), 1});  // (1)
        if (sense_[p] < 0 && (closed_[from] || closed_[to]))
          continue;  // their position follows from the panel sewn to this one
        around.push_back({from, to,
                          sense_[p] * wide *
                              (outwards(gear.panels[p], panel.meshes[j][0]) -
                               outwards(gear.panels[p], panel.meshes[i][0])),
                          1});  // (2)
      }
    if (sense_[p] > 0 && gear.panels[p].panel->stands == Standing::middle)
      for (std::size_t own = 0; own < panel.nodes.size(); ++own)
        if (std::abs(panel.meshes[own][0]) < 1e-6) top.push_back({panel.nodes[own], 0});
    for (const EdgeRef& fold : folds_[p])
      if (!is_below(gear, fold))
        for (const auto own : panel.sets.at(gear.panels[p].outline.edges[fold.edge].name))
          top.push_back({panel.nodes[own], 0});
    if (start.empty() && !panel.nodes.empty()) start.push_back({panel.nodes[0], 0});
  }
  for (const auto& rope : mesh.ropes)
    for (std::size_t i = 1; i < rope.nodes.size(); ++i) {
      aft.push_back({rope.nodes[i - 1], rope.nodes[i], 0, kRopeWeight});
      around.push_back({rope.nodes[i - 1], rope.nodes[i], 0, kRopeWeight});
    }
  aft_ = by_gains(mesh.nodes, aft, start);
  around_ = by_gains(mesh.nodes, around, top.empty() ? start : top);
}

/// Finds the side edges that are sewn to their mirror image: those of tubes, and of pairs of panels that meet
/// in the middle. In half a gear they lie on the plane of symmetry.
void Girth::find_folds(const Gear& gear) {
  const auto meets_its_image = [&](const EdgeRef& ref, const std::vector<EdgeRef>& others) {
    return std::ranges::any_of(others,
                               [&](const EdgeRef& other) { return are_mirror_images(gear, ref, other); });
  };
  for (const auto& seam : gear.seams)
    for (const std::size_t row : {0u, 1u})
      for (const auto& ref : seam.edges[row])
        if (is_lateral(kind_of(gear, ref)) &&
            (seam.is_to_itself || meets_its_image(ref, seam.edges[1 - row])))
          folds_[ref.panel].push_back(ref);
  for (std::size_t p = 0; p < gear.panels.size(); ++p)
    for (std::size_t e = 0; e < gear.panels[p].outline.edges.size(); ++e)
      if (const auto& edge = gear.panels[p].outline.edges[e]; edge.is_on_plane && is_lateral(edge.kind))
        folds_[p].push_back({p, e});
}

/// Whether a fold (a side edge sewn to its mirror image) is at the bottom of the net: whether it is on the
/// side of its panel that is farther from the top. This is the outer side if the distance from the top
/// increases outwards, otherwise the inner side.
bool Girth::is_below(const Gear& gear, const EdgeRef& fold) const {
  return (kind_of(gear, fold) == EdgeKind::outer) == (sense_[fold.panel] > 0);
}

/// Fills `bottom_` with pairs (distance aft, half girth S at this distance). S is known at nodes on the
/// middle of a lower middle panel, and at nodes on folds at the bottom. If there are no such nodes, the net
/// is open at the bottom, and S is twice the largest distance from the top, at every distance aft.
void Girth::measure_bottom(const Gear& gear, const GearMesh& mesh) {
  double most = 0;
  own_.assign(mesh.nodes, 0);
  for (std::size_t p = 0; p < mesh.panels.size(); ++p) {
    const PanelMesh& panel = mesh.panels[p];
    const double wide = std::sin(kTowedHalfAngle) * gear.panels[p].panel->mesh;
    const bool is_bottom = sense_[p] < 0 && gear.panels[p].panel->stands == Standing::middle;
    for (std::size_t own = 0; own < panel.nodes.size(); ++own) {
      const auto node = panel.nodes[own];
      most = std::max(most, around_[node]);
      if (is_bottom && !closed_[node])
        bottom_[layer_[p]].push_back(
            {aft_[node], own_[node] = around_[node] + wide * std::abs(panel.meshes[own][0])});
    }
    for (const EdgeRef& fold : folds_[p])
      if (is_below(gear, fold)) measure_below(gear, mesh, fold);
  }
  if (bottom_[0].empty()) bottom_[0].push_back({0, std::max(2 * most, 1e-3)});
  for (auto& layer : bottom_) std::sort(layer.begin(), layer.end());
}

/// Adds the half girth S at nodes on a fold at the bottom.
void Girth::measure_below(const Gear& gear, const GearMesh& mesh, const EdgeRef& fold) {
  const PanelMesh& panel = mesh.panels[fold.panel];
  for (const auto own : panel.sets.at(gear.panels[fold.panel].outline.edges[fold.edge].name)) {
    const auto node = panel.nodes[own];
    bottom_[layer_[fold.panel]].push_back({aft_[node], own_[node] = around_[node]});
  }
}

double Girth::half_girth(std::uint32_t node) const {
  if (own_[node] > 0) return std::max(own_[node], 1e-3);
  const double aft = aft_[node];
  const auto& own = bottom_[layer_of_node_[node]];
  const auto& bottom = own.empty() ? bottom_[0] : own;
  const auto next = std::lower_bound(bottom.begin(), bottom.end(), std::pair{aft, 0.0});
  if (next == bottom.begin()) return std::max(next->second, 1e-3);
  if (next == bottom.end()) return std::max(bottom.back().second, 1e-3);
  const auto before = std::prev(next);
  const double gap = next->first - before->first, t = gap > 0 ? (aft - before->first) / gap : 0;
  return std::max((1 - t) * before->second + t * next->second, 1e-3);
}

}  // namespace netloft::gears
