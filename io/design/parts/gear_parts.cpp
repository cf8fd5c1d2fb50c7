// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/parts/gear_parts.hpp"

#include "io/design/parts/panel_choices.hpp"
#include "io/design/texts/scene_texts.hpp"
#include "io/formats/toml/merge.hpp"
#include "io/formats/toml/parse.hpp"
#include "io/gears/plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace netloft::design {

namespace {

constexpr const char* kTablesOfParts[] = {"panels", "ropes", "floats", "points", "bodies"};

std::vector<std::string> points_of(const gears::NetPlan& plan) {
  std::vector<std::string> names;
  for (const gears::Point& point : plan.points) names.push_back(point.name);
  for (const gears::PlanBody& body : plan.bodies)
    for (const gears::BodyPoint& point : body.points) names.push_back(body.name + "." + point.name);
  for (const gears::Rope& rope : plan.ropes)
    for (const char* end : {"start", "middle", "end"})
      if (!rope.is_selvedge && (rope.stands != gears::Standing::middle || end != std::string_view("start")))
        names.push_back(rope.name + "." + end);
  for (const gears::Panel& panel : plan.panels)
    for (const std::string& corner : gears::corner_names(panel)) names.push_back(panel.name + "." + corner);
  return names;
}

const formats::Table* table_in(const formats::Value& root, const std::string& key) {
  const formats::Member* member = root.as<formats::Table>()->find(key);
  return member ? member->value.as<formats::Table>() : nullptr;
}

/// A name that no table of the gear has.
std::string new_name(const formats::Value& root, const std::string& kind) {
  for (int i = 1;; ++i) {
    const std::string name = kind + "-" + std::to_string(i);
    const bool is_taken = std::ranges::any_of(kTablesOfParts, [&](const char* key) {
      const formats::Table* table = table_in(root, key);
      return table && (table->find(name) || table->find(name + "-rope"));
    });
    if (!is_taken) return name;
  }
}

std::string filled(std::string text, const PartChoices& choices) {
  for (const auto& [name, value] : choices) {
    const std::string word = "{" + name + "}";
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + value.size()))
      text.replace(at, word.size(), value);
  }
  return text;
}

/// Replaces a name wherever a text is this name, or ends in it like "12 along wing.inner".
void lead(formats::Value& value, const std::string& from, const std::string& to) {
  if (auto* text = value.as<std::string>()) {
    if (*text == from || text->ends_with(" " + from))
      text->replace(text->size() - from.size(), from.size(), to);
  } else if (auto* array = value.as<formats::Array>()) {
    for (formats::Value& item : array->items) lead(item, from, to);
  } else if (auto* table = value.as<formats::Table>()) {
    for (formats::Member& member : table->members) lead(member.value, from, to);
  }
}

const std::array<double, 3>& place_of(const PartedGear& gear, const std::string& point, const char* need) {
  const auto found = gear.points.find(point);
  if (found == gear.points.end())
    throw Refused(std::string(need) + ": where " + point + " is in the equilibrium is not known");
  return found->second;
}

/// Adds what the places of the chosen points suggest: the length of a rope between them, and where a body
/// behind a point is.
void add_places(const PartedGear& gear, PartChoices& choices) {
  if (choices.contains("from") && choices["length"].empty()) {
    const auto &a = place_of(gear, choices["from"], "give the length"),
               &b = place_of(gear, choices["to"], "give the length");
    choices["length"] = fmt::format("{:.3f}", std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  if (!choices.contains("at")) return;
  const auto& at = place_of(gear, choices["at"], "this board needs a place");
  choices["behind"] =
      fmt::format("[{:.3f}, {:.3f}, {:.3f}]", at[0] + std::atof(choices["length"].c_str()), at[1], at[2]);
}

/// Completes the choices, and refuses those that the gear or the catalogue does not have.
void settle_choices(const PartedGear& gear, const PartTemplate& kind, PartChoices& choices) {
  for (const PartField& field : kind.fields) {
    std::string& value = choices[field.name];
    const bool is_number = field.of == std::string_view("metres") || field.of == std::string_view("count");
    if (value.empty()) value = field.usual;
    if (is_number) continue;
    const auto known = choices_of(field, gear);
    if (value.empty() && !known.empty()) value = known.front();
    if (std::ranges::find(known, value) == known.end())
      throw Refused(std::string(field.words) + ": \"" + value + "\" is not among " +
                    (known.empty() ? "the parts: there are none"
                                   : "those that can be chosen, such as " + known.front()));
  }
  add_places(gear, choices);
  for (const auto& [name, value] : choices)
    if (value.find_first_of("\"\\\n{") != std::string::npos)
      throw Refused(name + ": a quotation mark or a line break cannot stand here");
  choices["name"] = new_name(gear.root, kind.kind);
}

bool belongs_to(const formats::Value& name, const std::string& part) {
  const auto* text = name.as<std::string>();
  return text && (*text == part || text->starts_with(part + "."));
}

/// Takes a part out of one side of a seam, an edge or a row of edges. Returns whether edges are left.
bool keep_others(formats::Value& side, const std::string& part) {
  if (auto* row = side.as<formats::Array>()) {
    std::erase_if(row->items, [&](const formats::Value& edge) { return belongs_to(edge, part); });
    return !row->items.empty();
  }
  return !belongs_to(side, part);
}

/// Whether a seam, a hanging or a hold remains when a part is removed.
bool remains_without(formats::Value& item, const std::string& part) {
  auto* table = item.as<formats::Table>();
  if (!table) return true;
  for (const char* key : {"edge", "on"})
    if (const formats::Member* member = table->find(key); member && belongs_to(member->value, part))
      return false;
  formats::Member* edges = table->find("edges");
  auto* sides = edges ? edges->value.as<formats::Array>() : nullptr;
  return !sides ||
         std::ranges::all_of(sides->items, [&](formats::Value& side) { return keep_others(side, part); });
}

}  // namespace

std::vector<std::string> choices_of(const PartField& field, const PartedGear& gear) {
  const std::string_view of = field.of;
  std::vector<std::string> names;
  if (of == "points") return points_of(gear.plan);
  if (of == "edges") return edges_of(gear.plan);
  if (of == "ropes") {
    for (const gears::Rope& rope : gear.plan.ropes)
      if (!rope.is_selvedge) names.push_back(rope.name);
  } else if (of != "metres" && of != "count") {
    const auto kinds = gears::kinds_under(of);
    for (const gears::CataloguePart& part : gear.catalogue.parts())
      if (std::ranges::find(kinds, part.kind->name) != kinds.end()) names.push_back(part.name);
  }
  return names;
}

std::vector<std::string> parts_of(const formats::Value& root) {
  std::vector<std::string> names;
  for (const char* key : kTablesOfParts)
    if (const formats::Table* table = table_in(root, key))
      for (const formats::Member& member : table->members)
        names.push_back(formats::join_path(key, member.key));
  return names;
}

std::vector<formats::Value> with_part(const PartedGear& gear, const PartTemplate& kind, PartChoices choices) {
  if (gear.plan.panels.empty() && gear.plan.ropes.empty())
    throw Refused("this scene has no net plan to which a part could be added; write it into the text");
  settle_choices(gear, kind, choices);
  PanelAtEdge base{gear.root, std::vector<PartChoices>(1)};
  if (choices.contains("edge")) base = panel_at_edge(gear, choices);
  std::vector<formats::Value> documents;
  for (const PartChoices& way : base.ways) {
    PartChoices all = choices;
    all.insert(way.begin(), way.end());
    for (const char* text : kind.texts) {
      formats::Diagnostics said;
      auto added = formats::parse_toml(filled(text, all), -1, said);
      if (!added) throw Refused("these choices make no valid text: " + first_error_of(said));
      formats::Value& document = documents.emplace_back(base.root);
      for (const std::string& key : kind.moves_in)
        if (formats::Member* member = document.as<formats::Table>()->find(key))
          lead(member->value, filled(kind.moves_from, all), filled(kind.moves_to, all));
      formats::merge(document, std::move(*added));
    }
  }
  return documents;
}

formats::Value without_part(formats::Value root, const std::string& part) {
  const auto known = parts_of(root);
  if (std::ranges::find(known, part) == known.end()) throw Refused("there is no part \"" + part + "\"");
  const auto steps = formats::read_change(part + "=0").steps;
  const std::string &group = steps.front().key, &name = steps.back().key;
  auto* tables = root.as<formats::Table>();
  const auto drop = [&](const std::string& key) {
    formats::Member* member = tables->find(key);
    auto* table = member ? member->value.as<formats::Table>() : nullptr;
    if (table) std::erase_if(table->members, [&](const formats::Member& m) { return m.key == name; });
    if (table && table->members.empty())  // no statement says that there is an empty table
      std::erase_if(tables->members, [&](const formats::Member& m) { return m.key == key; });
  };
  drop(group);
  if (group != "floats" && group != "points") drop("elements");  // how the part is computed
  for (const char* key : {"join", "hang"}) {
    formats::Member* member = tables->find(key);
    if (auto* array = member ? member->value.as<formats::Array>() : nullptr)
      std::erase_if(array->items, [&](formats::Value& item) { return !remains_without(item, name); });
  }
  return root;
}

}  // namespace netloft::design
