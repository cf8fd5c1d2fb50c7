// SPDX-License-Identifier: BSD-3-Clause
#include "io/report/picture.hpp"

#include <algorithm>
#include <limits>

namespace netloft::io {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Whether the elements of a family become cells of the picture: elements between their own nodes, and
/// elements on single nodes. Elements between other parts' nodes and elements that ride on drawn elements
/// would hide those.
bool is_drawn(const LoadedScene& loaded, const ElementFamily& family) {
  if (family.type().element.stencil == NETLOFT_NODE) return true;
  return family.type().element.stencil <= 0xff && !loaded.parts[family.parts()[0]].nodes.empty();
}

}  // namespace

Mesh make_mesh(const LoadedScene& loaded, const Assembler& assembler) {
  Mesh mesh;
  mesh.n_points = loaded.scene.node_count();
  for (const auto& family : assembler.families()) {
    if (!is_drawn(loaded, *family)) continue;
    const int corners = family->nodes_per_element();
    const auto cell = corners == 1 ? kVertex : corners == 2 ? kLine : kTriangle;
    for (std::size_t e = 0; e < family->size(); ++e) {
      for (int c = 0; c < corners; ++c) mesh.connectivity.push_back(family->node(e, c));
      mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
      mesh.types.push_back(cell);
    }
  }
  return mesh;
}

std::vector<StaticField> label_points(const LoadedScene& loaded) {
  const std::size_t n = loaded.scene.node_count();
  std::vector<double> part(n), node(n), panel(2 * n, kNone);
  for (std::size_t i = 0; i < n; ++i) {
    const NodeLabel label = loaded.scene.labels[i];
    part[i] = label.part, node[i] = label.id;
    const auto& coordinates = loaded.parts[label.part].panel;
    if (!coordinates.empty())
      panel[2 * i] = coordinates[label.id][0], panel[2 * i + 1] = coordinates[label.id][1];
  }
  return {
      {{"part", "1", "part the node was made for, index into /netloft/parts/name", Location::kPoint, 1, true},
       part},
      {{"node", "1", "number of the node within its part", Location::kPoint, 1, true}, node},
      {{"panel_uv", "1", "panel coordinates U, V in meshes", Location::kPoint, 2, false}, panel}};
}

StaticField label_cells(const LoadedScene& loaded, const Assembler& assembler) {
  std::vector<double> part;
  for (const auto& family : assembler.families())
    for (std::size_t e = 0; e < family->size() && is_drawn(loaded, *family); ++e)
      part.push_back(family->part(e));
  return {{"part", "1", "part of the element, index into /netloft/parts/name", Location::kCell, 1, true},
          part};
}

std::vector<CellField> gather_outputs(const LoadedScene& loaded, const Assembler& assembler,
                                      const FamilyOutputs& outputs_of) {
  std::size_t cells = 0, first = 0;
  for (const auto& family : assembler.families())
    if (is_drawn(loaded, *family)) cells += family->size();
  std::vector<CellField> fields;
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    if (!is_drawn(loaded, *assembler.families()[f])) continue;
    const auto& outputs = assembler.families()[f]->type().outputs;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      auto at = std::find_if(fields.begin(), fields.end(),
                             [&](const CellField& c) { return c.spec.name == outputs[k].name; });
      if (at == fields.end())
        at = fields.insert(at, {{outputs[k].name, outputs[k].unit, outputs[k].doc, Location::kCell, 1, false},
                                std::vector<double>(cells, kNone)});
      std::copy(outputs_of[f][k].begin(), outputs_of[f][k].end(),
                at->values.begin() + static_cast<std::ptrdiff_t>(first));
    }
    first += assembler.families()[f]->size();
  }
  return fields;
}

/// A vector over all dofs as a vector per node. Unknowns shared by a part's elements are left out, because
/// they have no position.
std::vector<double> by_node(const LoadedScene& loaded, const Assembler& assembler,
                            const std::vector<double>& v) {
  std::vector<double> nodes(3 * loaded.scene.node_count());
  for (std::size_t d = 0; d < nodes.size(); ++d)
    nodes[d] = v[static_cast<std::size_t>(
        assembler.numbering().index(static_cast<std::uint32_t>(d / 3), static_cast<int>(d % 3)))];
  return nodes;
}

}  // namespace netloft::io
