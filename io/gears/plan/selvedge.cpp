// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/plan_reader.hpp"

#include <cmath>

namespace netloft::gears {

namespace {

// A selvedge is a strip of n meshes gathered into a seam. When stretched, it has 2n twines side by side: a
// mesh is two bars long and consists of four bars. All twines carry load, except in square netting, where
// half of the twines run across. Double netting has t twines side by side; d, m, EA are diameter, mass and
// stiffness of one twine. The strip has the mass of k twines and the stiffness of e twines:
//   k = 2 n t,   e = k, for square netting k/2                                              (1)
//   d_strip = √k d,  m_strip = k m,  EA_strip = e EA                                          (2)
struct Bundle {
  double twines = 0, carrying = 0;
};

Bundle bundle_of(const Panel& panel, double meshes) {
  const double twines = 2 * meshes * panel.twines;
  return {twines, panel.orientation == "square" ? twines / 2 : twines};  // (1)
}

/// The properties of the rope that stands for a strip, from those of the twine.
formats::Value strip_of(const Panel& panel, const Bundle& bundle, formats::Diagnostics& diagnostics) {
  formats::Value strip = panel.twine;
  formats::TableReader twine(panel.twine, diagnostics, "panels." + panel.name + ".twine");
  const auto scale = [&](const char* key, const char* unit, double factor) {
    if (formats::Member* member = twine.has(key) ? strip.as<formats::Table>()->find(key) : nullptr)
      member->value.data = factor * twine.real(key, {.unit = unit});  // (2)
  };
  scale("diameter", "m", std::sqrt(bundle.twines));
  scale("mass", "kg/m", bundle.twines);
  for (const char* key : {"EA", "EA_compression", "breaking_load"}) scale(key, "N", bundle.carrying);
  return strip;
}

/// Whether the name of a strip is already in use. If an edge is sewn twice, it has a strip already;
/// check_plan() reports such an edge.
bool is_taken(const NetPlan& plan, const std::string& name, const Join& join,
              formats::Diagnostics& diagnostics) {
  const Rope* rope = plan.find_rope(name);
  const bool is_written = (rope && !rope->is_selvedge) || plan.find_panel(name) || plan.find_point(name);
  if (is_written)
    diagnostics.error(join.place, "there is something named \"" + name + "\" already",
                      "give your own rope, panel or point another name: the strip of meshes that this seam "
                      "gathers gets this name");
  return rope || is_written;
}

/// Adds a rope along an edge. The rope is as long as the straight twines of the edge, and slack until these
/// are straight.
void add_strip(NetPlan& plan, const EdgeSet& set, const OutlineEdge& edge, const Join& join,
               formats::Diagnostics& diagnostics) {
  const Panel& panel = *set.panel;
  Rope rope;
  rope.name = panel.name + "-" + edge.name + "-selvedge";
  rope.is_selvedge = true;
  if (is_taken(plan, rope.name, join, diagnostics)) return;
  rope.stands = set.times() == 2 ? Standing::pair : panel.stands;
  rope.rope = strip_of(panel, bundle_of(panel, join.selvedge), diagnostics);
  rope.length = edge.stretched * panel.mesh;
  rope.place = rope.between_place = join.place;
  Hanging hanging;
  hanging.edge = panel.name + "." + edge.name;
  hanging.rope = rope.name;
  hanging.length = rope.length;
  hanging.edge_place = hanging.rope_place = hanging.place = join.place;
  plan.ropes.push_back(std::move(rope));
  plan.hangings.push_back(std::move(hanging));
}

void gather(NetPlan& plan, const EdgeSet& set, const OutlineEdge& edge, double meshes) {
  for (auto& panel : plan.panels) {
    if (&panel != set.panel) continue;
    for (auto& cut : edge.kind == EdgeKind::outer ? panel.outer : panel.inner)
      if (cut.name == edge.name) cut.selvedge = meshes;
    panel.outline = outline_of(panel);
  }
}

void say_not_a_side(const Join& join, const std::string& edge, formats::Diagnostics& diagnostics) {
  diagnostics.error(join.place, "join.selvedge: " + edge + " is not a side",
                    "selvedges are gathered along sides; fore and aft edges are sewn mesh to mesh");
}

}  // namespace

void add_selvedges(NetPlan& plan, formats::Diagnostics& diagnostics) {
  formats::Diagnostics silent;  // unknown names are reported by the check
  for (const auto& join : plan.joins)
    for (std::size_t k = 0; join.selvedge > 0 && k < (join.is_to_itself() ? 1u : join.edges.size()); ++k)
      for (const auto& name : join.edges[k]) {
        const EdgeSet set = find_edge(plan, name, {}, "", silent);
        if (!set.edges.empty() && !set.is_side()) say_not_a_side(join, name, diagnostics);
        for (const auto& edge : set.edges)
          if (set.is_side()) {
            add_strip(plan, set, edge, join, diagnostics);
            gather(plan, set, edge, join.selvedge);
          }
      }
}

}  // namespace netloft::gears
