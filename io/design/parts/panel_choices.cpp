// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/parts/panel_choices.hpp"

#include "io/design/texts/scene_texts.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::design {

namespace {

bool is_end(gears::EdgeKind kind) { return kind == gears::EdgeKind::fore || kind == gears::EdgeKind::aft; }

/// The number of a choice; `usual` if it is empty.
double meshes_in(const PartChoices& choices, const char* name, double usual) {
  const std::string& text = choices.at(name);
  if (text.empty()) return usual;
  try {
    std::size_t read = 0;
    const double meshes = std::stod(text, &read);
    if (read == text.size() && meshes >= 0 && std::isfinite(meshes)) return meshes;
  } catch (const std::logic_error&) {  // no number
  }
  throw Refused("\"" + text + "\" is not a number of meshes");
}

/// The keys of the netting of a panel, which a neighbour of the same cloth repeats.
std::string cloth_of(const formats::Table& panel) {
  std::string text;
  for (const char* key : {"netting", "mesh", "twine", "twines", "orientation"})
    if (const formats::Member* member = panel.find(key))
      text += std::string(key) + " = " + formats::spell_in_file(member->value) + "\n";
  return text;
}

/// An edge that is declared open is declared so no more. Returns whether it was.
bool close_edge(formats::Table& panel, const std::string& edge) {
  formats::Member* open = panel.find("open");
  if (!open) return false;
  const auto is_edge = [&](const formats::Value& name) {
    const auto* text = name.as<std::string>();
    return text && *text == edge;
  };
  auto* list = open->value.as<formats::Array>();
  const bool was_open = list ? std::erase_if(list->items, is_edge) > 0 : is_edge(open->value);
  if (was_open && (!list || list->items.empty()))
    std::erase_if(panel.members, [](const formats::Member& m) { return m.key == "open"; });
  return was_open;
}

/// Counts and sides of a panel, for one cutting of its slanting sides.
class NewPanel {
 public:
  NewPanel(const gears::EdgeSet& edge, double depth, double far, bool is_open)
      : is_aft_(edge.edges.front().kind == gears::EdgeKind::aft),
        is_round_(edge.panel->is_round),
        is_across_(edge.is_across_middle()),
        is_alone_(edge.panel->stands == gears::Standing::alone),
        near_meshes_(edge.meshes()),
        far_meshes_(far),
        depth_(depth),
        is_open_(is_open) {}

  const char* near() const { return is_aft_ ? "fore" : "aft"; }
  const char* other() const { return is_aft_ ? "aft" : "fore"; }

  std::vector<std::string> cuttings() const {
    const double across = std::abs(near_meshes_ - far_meshes_) / (is_across_ ? 2 : 1);
    if (across == 0) return {"AN"};
    std::vector<std::string> rates = gears::rates_near(across, depth_);
    const bool narrows = fore() > aft();
    for (std::string& rate : rates)
      if (rate != "AN") rate += narrows ? " in" : " out";
    return rates;
  }

  std::string counts() const {
    std::string text = is_across_ ? "" : is_alone_ ? "stands = \"alone\"\n" : "stands = \"pair\"\n";
    text += fmt::format("{} = {:g}\n", is_round_ ? "round" : "fore", fore());
    return text + (fore() == aft() && is_round_ ? "" : fmt::format("aft = {:g}\n", aft()));
  }

  std::string sides(const std::string& cutting) const {
    std::vector<std::string> open;
    std::string text;
    if (is_across_) {
      if (!is_round_ || cutting != "AN") text = "sides = \"" + cutting + "\"\n";
      if (!is_round_) open = {"sides"};
    } else {
      text = "outer = \"" + cutting + "\"\ninner = \"AN\"\n";
      open = {"outer", "inner"};
    }
    if (is_open_) open.emplace_back(other());
    std::string names;
    for (const std::string& name : open) names += (names.empty() ? "\"" : ", \"") + name + "\"";
    return text + (open.empty() ? "" : "open = [" + names + "]\n");
  }

 private:
  double fore() const { return is_aft_ ? near_meshes_ : far_meshes_; }
  double aft() const { return is_aft_ ? far_meshes_ : near_meshes_; }

  bool is_aft_, is_round_, is_across_, is_alone_;
  double near_meshes_, far_meshes_, depth_;
  bool is_open_;
};

}  // namespace

std::vector<std::string> edges_of(const gears::NetPlan& plan) {
  std::vector<std::string> names;
  for (const gears::Panel& panel : plan.panels)
    for (const gears::OutlineEdge& edge : panel.outline.edges)
      if (is_end(edge.kind)) names.push_back(panel.name + "." + edge.name);
  return names;
}

PanelAtEdge panel_at_edge(const PartedGear& gear, const PartChoices& choices) {
  const std::string& name = choices.at("edge");
  formats::Diagnostics said;
  const gears::EdgeSet edge = gears::find_edge(gear.plan, name, {}, "edge", said);
  if (edge.edges.empty() || !is_end(edge.edges.front().kind))
    throw Refused("\"" + name + "\" is not a fore or aft edge of a panel");
  PanelAtEdge found{gear.root, {}};
  formats::Table& owner = *found.root.as<formats::Table>()
                               ->find("panels")
                               ->value.as<formats::Table>()
                               ->find(edge.panel->name)
                               ->value.as<formats::Table>();
  const bool was_open = close_edge(owner, name.substr(edge.panel->name.size() + 1));
  const double depth = meshes_in(choices, "depth", 0);
  if (!(depth > 0)) throw Refused("a panel is at least some meshes deep");
  const NewPanel panel(edge, depth, meshes_in(choices, "far", edge.meshes()), was_open);
  for (const std::string& cutting : panel.cuttings())
    found.ways.push_back({{"cloth", cloth_of(owner)},
                          {"counts", panel.counts()},
                          {"sides", panel.sides(cutting)},
                          {"near", panel.near()},
                          {"other", panel.other()}});
  return found;
}

}  // namespace netloft::design
