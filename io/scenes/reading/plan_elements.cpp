// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/plan_elements.hpp"

#include "io/formats/toml/merge.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/scenes/reading/gear_model.hpp"
#include "io/scenes/reading/part_names.hpp"
#include "io/scenes/reading/plan_contact.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

/// Removes numbers of a catalogue part that the element type does not take.
void drop_unknown_numbers(formats::Table& numbers, const ElementType& type, const std::string& key) {
  std::erase_if(numbers.members, [&](const formats::Member& number) {
    const std::string name = key + "." + number.key;
    return std::none_of(type.parameters.begin(), type.parameters.end(),
                        [&](const auto& p) { return name == p.name; });
  });
}

const formats::Value* find_exception(const std::map<std::string, formats::Value>& exceptions,
                                     const std::string& name) {
  const auto said = exceptions.find(name);
  return said == exceptions.end() ? nullptr : &said->second;
}

}  // namespace

PlanElements::PlanElements(const gears::NetPlan& plan, const gears::Gear& gear,
                           formats::TableReader& elements, const ElementChoice& choice, GearMemory& memory)
    : plan_(plan), choice_(choice), memory_(memory), diagnostics_(elements.diagnostics()) {
  for (const auto& of : gear_elements())
    if (of.kind != std::string_view(kContact))
      made_.push_back(read_elements(elements, of));
    else if (const formats::Value* said = elements.has(of.kind) ? elements.raw(of.kind) : nullptr;
             said && said->as<formats::Table>())
      contact_ = *said;
  read_exceptions(elements, gear);
}

/// Whether `[elements.NAME]` may have keys for contact: NAME is a rope or a body that rests on the bed, or
/// the word "contact".
bool PlanElements::touches_bed(const std::string& name) const {
  if (!contact_) return false;
  const gears::Rope* rope = plan_.find_rope(name);
  const gears::PlanBody* body = plan_.find_body(name);
  return name == kContact || (rope && rests_on_bed(*rope)) || (body && !shoes_of(*body).empty());
}

/// Reads tables such as `[elements.top-codend]`, which override `[elements.KIND]` for one panel, rope or body
/// of the plan.
void PlanElements::read_exceptions(formats::TableReader& elements, const gears::Gear& gear) {
  std::vector<std::string> names;
  for (const auto& panel : gear.panels) names.push_back(panel.name);
  for (const auto& rope : gear.ropes) names.push_back(rope.name);
  for (const auto& pieces : gear.pieces) names.push_back(pieces.name);
  for (const auto& body : gear.bodies) names.push_back(body.name);
  for (const auto& of : gear_elements()) names.push_back(of.kind);
  for (const auto& name : elements.keys()) {
    const formats::Value* said = elements.raw(name);
    const auto meant = meant_by(name, names);
    if (meant.empty())
      elements.error(name, "there is nothing named " + formats::in_quotes(name) + " in the net plan",
                     name_hint(name, names));
    else if (said->as<formats::Table>() && said->as<formats::Table>()->find(contact_elements().key) &&
             !touches_bed(name))
      elements.error(
          name,
          std::string("has the key ") + contact_elements().key + ", but " +
              (contact_ ? "does not touch the bed" : "no [elements.contact] makes the plan rest on the bed"),
          contact_ ? "leave the key out; only footropes, bridles, sweeps, legs and boards with a toe or heel "
                     "touch the bed"
                   : "add [elements.contact], so that footropes, bridles, sweeps, legs and boards rest on "
                     "the bed");
    else if (!said->as<formats::Table>())
      elements.error(name, "a table is expected, such as { drag = \"hydro/morison\" }");
    else if (meant.front() == name)
      exceptions_[name] = *said;
    else
      for (const auto& side : meant) exceptions_of_pairs_[side] = *said;
  }
}

PlanElements::Made PlanElements::read_elements(formats::TableReader& elements, const GearElements& of) const {
  formats::TableReader table = elements.table(of.kind, formats::Presence::optional);
  for (const auto& key : table.keys()) table.raw(key);  // known, because each part reads these keys later
  Made made{&of, {table.place(), formats::Table{}}, nullptr};
  if (const formats::Value* said = elements.raw(of.kind); said && said->as<formats::Table>())
    made.said = *said;
  made.type = choice_.find(
      table.has("type") ? read_name(table, "type", "element type, such as priour/triangle") : of.type, table);
  if (made.type && made.type->element.stencil != of.stencil) {
    table.error("type", made.type->type + " cannot be used for " + of.doc,
                std::string("use a type such as ") + of.type);
    made.type = nullptr;
  }
  return made;
}

const PlanElements::Made& PlanElements::made(std::string_view kind) const {
  return *std::find_if(made_.begin(), made_.end(), [&](const auto& m) { return m.of->kind == kind; });
}

bool PlanElements::read_part(std::string_view kind, const std::string& path, formats::Value numbers,
                             bool is_of_catalogue, Part& part) const {
  const Made& how = made(kind);
  if (formats::Table* table = numbers.as<formats::Table>(); table && is_of_catalogue)
    drop_unknown_numbers(*table, *how.type, how.of->key);
  formats::Value whole{numbers.place, formats::Table{}};
  formats::put(*whole.as<formats::Table>(), how.of->key, std::move(numbers));
  formats::merge(whole, how.said);
  for (const auto* exceptions : {&exceptions_of_pairs_, &exceptions_})
    if (const auto said = exceptions->find(part.name); said != exceptions->end())
      formats::merge(whole, without_contact(said->second));
  auto& recent = memory_.parts.try_emplace(part.name, 1).first->second;
  const auto read = recent.of({how.type, path, std::move(whole)}, [&](const PartTable& input) {
    return read_table(input, diagnostics_.without_messages());
  });
  if (!read->is_sound)
    memory_.parts.erase(part.name);  // not stored: the cause may be a plugin, which may be fixed later
  diagnostics_.take_messages(read->messages);
  part.type = read->part.type;
  part.parameters = read->part.parameters;
  part.laws = read->part.laws;
  return read->is_sound;
}

std::shared_ptr<const PartTableRead> PlanElements::read_table(const PartTable& input,
                                                              formats::Diagnostics said) const {
  auto read = std::make_shared<PartTableRead>();
  formats::TableReader reader(input.table, said, input.path);
  reader.has("type");
  choice_.read(*input.type, reader, read->part);
  reader.finish();
  read->messages = said.messages();
  read->is_sound = said.errors() == 0;
  return read;
}

formats::Value PlanElements::contact_of(const std::string& name, std::vector<std::string> on,
                                        formats::Place place) const {
  const GearElements& of = contact_elements();
  formats::Value table{contact_->place, formats::Table{}};
  formats::put(*table.as<formats::Table>(), "type", {contact_->place, std::string(of.type)});
  if (const double radius = radius_along(plan_, name); radius > 0) {
    formats::Table seabed;
    formats::put(seabed, "radius", {place, radius});
    formats::put(*table.as<formats::Table>(), of.key, {place, std::move(seabed)});
  }
  formats::merge(table, *contact_);
  for (const auto* said :
       {find_exception(exceptions_of_pairs_, "starboard-" + name), find_exception(exceptions_, name)})
    if (said) formats::merge(table, only_contact(*said));
  formats::Array names;
  for (auto& point : on) names.items.push_back({place, std::move(point)});
  formats::put(*table.as<formats::Table>(), "on", {place, std::move(names)});
  return table;
}

}  // namespace netloft::scenes
