// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/rider_reader.hpp"

#include "framework/scene/pairs.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/part_reader.hpp"
#include "io/scenes/reading/standing_riders.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

bool rests_on_bed(const ElementType& type) {
  const auto both = NETLOFT_READS_BED | NETLOFT_FROM_OUTSIDE;
  return type.element.stencil == NETLOFT_NODE && std::ranges::any_of(type.terms, [&](const auto& term) {
           return (term.traits & both) == std::uint32_t{both};
         });
}

/// Removes the parameters that only the companions of a part read; the companions have copies of these
/// parameters.
void keep_own_parameters(Part& part, const ElementType& type) {
  std::erase_if(part.parameters, [&](const auto& given) {
    return std::none_of(type.parameters.begin(), type.parameters.end(),
                        [&](const auto& p) { return given.first == p.name; });
  });
}

}  // namespace

void RiderReader::read(const std::string& name, formats::TableReader& table) {
  formats::report({"reading", name, draft_.geometries.size(), "parts"});
  const int errors_before = diagnostics_.errors();
  const ElementType* type = elements_.find(read_type_name(draft_, name, table), table);
  Part part;
  part.name = name;
  if (type) {
    elements_.read(*type, table, part);
    stand_on_others(*type, table, draft_, part);
  } else {
    for (const auto& key : table.keys()) table.raw(key);
  }
  draft_.add_rider(std::move(part), table.place(), type, diagnostics_.errors() == errors_before);
}

void RiderReader::read_undivided(const std::string& name, formats::TableReader& table) {
  const int errors_before = diagnostics_.errors();
  const ElementType* type = elements_.find(read_type_name(draft_, name, table), table);
  Part part;
  part.name = name;
  if (type) {
    elements_.read(*type, table, part);
    for (const char* key : {"on", "number", "each"}) table.has(key);
    for (const auto& datum : type->data) table.has(datum.name);
  } else {
    for (const auto& key : table.keys()) table.raw(key);
  }
  Geometry none;
  none.names.name = name;
  none.names.place = table.place();
  draft_.add_part(std::move(part), std::move(none), type, diagnostics_.errors() == errors_before);
}

void RiderReader::read_contacts() {
  const std::set<std::uint32_t> carried = carried_by_beds();
  const auto all = gear_.contacts(carried);
  if (!all.empty() && !out_.scene.bed.is_there)
    return diagnostics_.error(
        all.front().second.place,
        "elements." + std::string(kContact) + ": there is no bed that the gear could touch",
        "add [bed] depth = \"100 m\"");
  for (const auto& [name, said] : all) {
    formats::TableReader table(said, diagnostics_, "elements." + std::string(kContact));
    const ElementType* type = elements_.find(read_type_name(draft_, name, table), table);
    if (type && !rests_on_bed(*type))
      return table.error("type", type->type + " does not rest on the bed of the scene",
                         "use a type such as seabed/bed");
    read(name, table);
    table.finish();
    if (diagnostics_.errors()) return;  // these errors are reported once, not for every rope
  }
  if (out_.scene.bed.is_there && gear_.sinks_into_bed(carried))
    diagnostics_.warning(
        root_.table("bed").place(), "the footrope passes through the bed: no part carries the gear there",
        "[elements.contact] seabed = { friction = 0.47 } lets all of the plan that touches the bed "
        "rest on it");
}

void RiderReader::read_contacts_undivided() {
  for (const auto& [name, said] : gear_.contacts({})) {
    const int errors_before = diagnostics_.errors();
    formats::TableReader table(said, diagnostics_, "elements." + std::string(kContact));
    read_undivided(name, table);
    table.finish();
    if (diagnostics_.errors() > errors_before) return;  // these errors are reported once, not for every rope
  }
}

/// The nodes of all contact parts of the scene, which rest on a bed.
std::set<std::uint32_t> RiderReader::carried_by_beds() const {
  std::set<std::uint32_t> nodes;
  for (std::size_t p = 0; p < draft_.types.size(); ++p)
    if (draft_.types[p] && rests_on_bed(*draft_.types[p]))
      nodes.insert(out_.scene.parts[p].nodes.begin(), out_.scene.parts[p].nodes.end());
  return nodes;
}

void RiderReader::add_companions() {
  if (diagnostics_.errors()) return;
  for (std::size_t p = 0, parts = out_.scene.parts.size(); p < parts; ++p) {
    const ElementType& type = *draft_.types[p];
    const auto riders = elements_.companions_of(type);
    for (const auto* rider : riders) {
      Part companion = make_companion(out_.scene.parts[p], type, *rider);
      // A companion without elements is not added.
      if (companion.nodes.empty() && may_act(*rider, companion.parameters)) continue;
      companions_.push_back(rider);
      out_.scene.parts.push_back(std::move(companion));
      out_.parts.push_back({out_.scene.parts[p].name, out_.parts[p].place, {}, {}, {}, {}});
    }
    if (!riders.empty()) keep_own_parameters(out_.scene.parts[p], type);
  }
}

}  // namespace netloft::scenes
