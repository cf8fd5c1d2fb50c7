// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/grid_fields.hpp"
#include "io/results/file/no_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

namespace netloft::results {

namespace {

/// Whether the elements of a family (all elements of one type) become cells of the picture. They do if they
/// are between nodes of their own part, on single nodes, or on origins of bodies. Elements on nodes or
/// elements of other parts are not drawn, because they would hide those parts.
bool is_drawn(const scenes::LoadedScene& loaded, const ElementFamily& family) {
  if (family.repeated()) return false;
  if (family.type().element.stencil == NETLOFT_NODE || family.type().is_on_body()) return true;
  return family.type().element.stencil <= 0xff && !loaded.parts[family.parts()[0]].nodes.empty();
}

using PanelPoint = std::array<double, 2>;  // coordinates U, V [meshes]

/// The panel coordinates of each node of a panel. A node on a seam that closes the panel to a tube has two
/// pairs of coordinates.
class PanelPlaces {
 public:
  explicit PanelPlaces(const scenes::PartGeometry& part) {
    for (std::size_t own = 0; own < part.panel.size(); ++own)
      places_.emplace(part.nodes[own], part.panel[own]);
  }
  /// The coordinates of `node` that are nearest to `near`; NaN if the node is not on the panel.
  PanelPoint nearest(std::uint32_t node, const PanelPoint& near) const {
    PanelPoint best{kNone, kNone};
    double least = std::numeric_limits<double>::infinity();
    for (auto [it, end] = places_.equal_range(node); it != end; ++it) {
      const double d = std::hypot(it->second[0] - near[0], it->second[1] - near[1]);
      if (d < least) {
        least = d;
        best = it->second;
      }
    }
    return best;
  }
  /// The coordinates of the first of `nodes` that has only one pair. With these coordinates as `near`,
  /// nearest() chooses, for every other node, the pair on the same side of the seam.
  PanelPoint anchor(std::span<const std::uint32_t> nodes) const {
    for (const auto node : nodes)
      if (places_.count(node) == 1) return places_.find(node)->second;
    const auto any = nodes.empty() ? places_.end() : places_.find(nodes[0]);
    return any == places_.end() ? PanelPoint{kNone, kNone} : any->second;
  }

 private:
  std::multimap<std::uint32_t, PanelPoint> places_;
};

/// The coordinates U, V of three corners; NaN if the cell is not on a panel, or if two of its corners are one
/// node (gathered netting).
std::array<double, 6> corners_on_panel(const PanelPlaces& panel, std::span<const std::uint32_t> nodes) {
  std::array<double, 6> corners;
  corners.fill(kNone);
  if (nodes.size() != 3 || nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0])
    return corners;
  const PanelPoint anchor = panel.anchor(nodes);
  for (std::size_t c = 0; c < 3; ++c) {
    const PanelPoint at = panel.nearest(nodes[c], anchor);
    corners[2 * c] = at[0];
    corners[2 * c + 1] = at[1];
  }
  return corners;
}

/// Assigns cells to the elements of each family.
class CellsOfFamilies {
 public:
  static constexpr std::size_t kNoCell = std::numeric_limits<std::size_t>::max();

  CellsOfFamilies(const scenes::LoadedScene& loaded, const Assembler& assembler)
      : loaded_(loaded), assembler_(assembler) {
    for (const auto& family : assembler.families()) {
      first_.push_back(count_);
      if (!is_drawn(loaded, *family)) continue;
      for (std::size_t e = 0; e < family->size(); ++e, ++count_)
        if (family->nodes_per_element() == 3) between_.emplace(nodes_of(*family, e), count_);
    }
  }
  std::size_t count() const { return count_; }
  /// The cell of every element of a family; empty if the family has no cells.
  std::vector<std::size_t> of(std::size_t f) const {
    const ElementFamily& family = *assembler_.families()[f];
    const bool is_own = is_drawn(loaded_, family);
    std::vector<std::size_t> cells;
    if (family.repeated() || (!is_own && family.type().element.stencil != NETLOFT_TRIANGLE)) return cells;
    for (std::size_t e = 0; e < family.size(); ++e) {
      const auto there = is_own ? between_.end() : between_.find(nodes_of(family, e));
      cells.push_back(is_own ? first_[f] + e : there == between_.end() ? kNoCell : there->second);
    }
    return cells;
  }

 private:
  using Nodes = std::array<std::uint32_t, 3>;
  static Nodes nodes_of(const ElementFamily& family, std::size_t e) {
    Nodes nodes = {family.node(e, 0), family.node(e, 1), family.node(e, 2)};
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  const scenes::LoadedScene& loaded_;
  const Assembler& assembler_;
  std::vector<std::size_t> first_;
  std::map<Nodes, std::size_t> between_;
  std::size_t count_ = 0;
};

}  // namespace

formats::Mesh make_mesh(const scenes::LoadedScene& loaded, const Assembler& assembler) {
  formats::Mesh mesh;
  mesh.n_points = loaded.scene.node_count();
  for (const auto& family : assembler.families()) {
    if (!is_drawn(loaded, *family)) continue;
    const int corners = family->nodes_per_element();
    const auto cell = corners == 1 ? formats::kVertex : corners == 2 ? formats::kLine : formats::kTriangle;
    for (std::size_t e = 0; e < family->size(); ++e) {
      for (int c = 0; c < corners; ++c) mesh.connectivity.push_back(family->node(e, c));
      mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
      mesh.types.push_back(cell);
    }
  }
  return mesh;
}

std::optional<std::pair<formats::FieldSpec, std::vector<double>>> rotation_field(
    const scenes::LoadedScene& loaded, const Assembler& assembler, std::span<const double> x) {
  if (loaded.scene.bodies.empty()) return {};
  std::vector<double> field(3 * loaded.scene.node_count(), kNone);
  for (std::size_t b = 0; b < loaded.scene.bodies.size(); ++b) {
    const auto psi = assembler.rotation(b, x);
    std::copy(psi.begin(), psi.end(), field.begin() + 3 * std::ptrdiff_t{loaded.scene.bodies[b].origin});
  }
  return std::pair{
      formats::FieldSpec{
          "rotation", "rad",
          "rotation vector from the axes of the body to those of the world, at the node of its origin",
          formats::Location::kPoint, 3, false},
      std::move(field)};
}

std::vector<formats::StaticField> label_points(const scenes::LoadedScene& loaded) {
  const std::size_t n = loaded.scene.node_count();
  std::vector<double> part(n), node(n), panel(2 * n, kNone);
  for (std::size_t i = 0; i < n; ++i) {
    const NodeLabel label = loaded.scene.labels[i];
    part[i] = label.part;
    node[i] = label.id;
    const auto& coordinates = loaded.parts[label.part].panel;
    if (!coordinates.empty()) {
      panel[2 * i] = coordinates[label.id][0];
      panel[2 * i + 1] = coordinates[label.id][1];
    }
  }
  return {
      {{"part", "1", "part for which the node was made, as an index into /netloft/parts/name",
        formats::Location::kPoint, 1, true},
       part},
      {{"node", "1", "number of the node within its part", formats::Location::kPoint, 1, true}, node},
      {{"panel_uv", "1", "panel coordinates U, V in meshes", formats::Location::kPoint, 2, false}, panel}};
}

formats::StaticField label_cells(const scenes::LoadedScene& loaded, const Assembler& assembler) {
  std::vector<double> part;
  for (const auto& family : assembler.families())
    for (std::size_t e = 0; e < family->size() && is_drawn(loaded, *family); ++e)
      part.push_back(family->part(e));
  return {
      {"part", "1", "part of the element, index into /netloft/parts/name", formats::Location::kCell, 1, true},
      part};
}

formats::StaticField label_corners(const scenes::LoadedScene& loaded, const Assembler& assembler) {
  const std::vector<PanelPlaces> places(loaded.parts.begin(), loaded.parts.end());
  std::vector<double> corners;
  for (const auto& family : assembler.families())
    for (std::size_t e = 0; e < family->size() && is_drawn(loaded, *family); ++e) {
      std::vector<std::uint32_t> nodes;
      for (int c = 0; c < family->nodes_per_element(); ++c) nodes.push_back(family->node(e, c));
      const auto uv = corners_on_panel(places[family->part(e)], nodes);
      corners.insert(corners.end(), uv.begin(), uv.end());
    }
  return {{"panel_corners", "1", "U, V of the corners on the cell's own panel, in meshes",
           formats::Location::kCell, 6, false},
          corners};
}

OutputFields::OutputFields(const scenes::LoadedScene& loaded, const Assembler& assembler) {
  const CellsOfFamilies cells(loaded, assembler);
  count_ = cells.count();
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    cells_.push_back(cells.of(f));
    const auto& outputs = assembler.families()[f]->type().outputs;
    for (std::size_t k = 0; k < outputs.size() && !cells_[f].empty(); ++k) {
      const auto at = std::find_if(specs_.begin(), specs_.end(), [&](const formats::FieldSpec& spec) {
        return spec.name == outputs[k].name;
      });
      sources_.push_back({f, k, static_cast<std::size_t>(at - specs_.begin())});
      if (at == specs_.end())
        specs_.push_back(
            {outputs[k].name, outputs[k].unit, outputs[k].doc, formats::Location::kCell, 1, false});
    }
  }
}

std::vector<CellField> OutputFields::gather(const FamilyOutputs& outputs) const {
  std::vector<CellField> fields;
  for (const formats::FieldSpec& spec : specs_) fields.push_back({spec, std::vector<double>(count_, kNone)});
  for (const auto& [family, output, field] : sources_) {
    const std::vector<std::size_t>& cells = cells_[family];
    const auto& from = outputs[family][output];
    std::vector<double>& to = fields[field].values;
    for (std::size_t e = 0; e < cells.size(); ++e)
      if (cells[e] != CellsOfFamilies::kNoCell && std::isnan(to[cells[e]])) to[cells[e]] = from[e];
  }
  return fields;
}

}  // namespace netloft::results
