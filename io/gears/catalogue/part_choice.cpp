// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/part_choice.hpp"

#include "io/formats/toml/merge.hpp"
#include "io/gears/catalogue/similar_names.hpp"

#include <algorithm>

namespace netloft::gears {

namespace {

constexpr const char* kPart = "part";

/// Returns the value that names a part: if `said` is a table with the key `part`, the value of this key,
/// otherwise `said`.
const formats::Value& naming_value(const formats::Value& said) {
  const formats::Table* table = said.as<formats::Table>();
  const formats::Member* part = table ? table->find(kPart) : nullptr;
  return part ? part->value : said;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string where_it_was_sought(const Catalogue& catalogue) {
  std::string text;
  for (const auto& folder : catalogue.folders()) text += (text.empty() ? "" : ", ") + folder.string();
  return text.empty() ? "no folder of a catalogue was found; NETLOFT_CATALOGUE may name some"
                      : "looked for in " + text + "; `netloft catalogue` lists what there is";
}

bool is_of(const CataloguePart& part, const std::vector<std::string>& kinds) {
  return std::find(kinds.begin(), kinds.end(), part.kind->name) != kinds.end();
}

std::string cure(const std::string& name, const std::vector<std::string>& kinds, const Catalogue& catalogue) {
  for (const auto& part : catalogue.parts())
    if (part.name == name) return "\"" + name + "\" is a " + part.kind->name;
  std::vector<const CataloguePart*> parts;
  for (const auto& part : catalogue.parts())
    if (is_of(part, kinds)) parts.push_back(&part);
  std::vector<std::string> near;
  for (const auto& meant : similar_names(name, parts, catalogue.synonyms()))
    near.push_back("\"" + meant + "\"");
  return near.empty() ? where_it_was_sought(catalogue) : "did you mean " + listed(near) + "?";
}

}  // namespace

bool names_a_part(const formats::Value& said) {
  const formats::Table* table = said.as<formats::Table>();
  return said.kind() == formats::Kind::text || (table && table->find(kPart));
}

const formats::NamingKeys& keys_that_name_parts() {
  static const formats::NamingKeys keys = {part_keys(), kPart};
  return keys;
}

const CataloguePart* choose_part(const formats::Value& said, const std::vector<std::string>& kinds,
                                 const std::string& path, const Catalogue& catalogue,
                                 formats::Diagnostics& diagnostics) {
  const formats::Value& naming = naming_value(said);
  const std::string* name = naming.as<std::string>();
  if (!name) {
    diagnostics.error(naming.place, path + ": the name of a part is a text, such as \"pe-braided-4mm\"");
    return nullptr;
  }
  const CataloguePart* part = catalogue.find(*name, kinds);
  if (!part)
    diagnostics.error(naming.place,
                      path + ": there is no " + listed(kinds) + " \"" + *name + "\" in the catalogue",
                      cure(*name, kinds, catalogue));
  return part;
}

formats::Value spell_out(const formats::Value& said, const CataloguePart& part,
                         const std::function<bool(const std::string&)>& wanted) {
  formats::Table own;
  if (const formats::Table* table = said.as<formats::Table>()) own = *table;
  std::erase_if(own.members, [](const formats::Member& m) { return m.key == kPart; });
  formats::Table spelled;
  for (const auto& [key, number] : part.numbers)
    if (wanted(key) && !own.find(key))
      spelled.members.push_back({key, said.place, formats::Value{said.place, number}});
  for (const char* key : part.kind->tables)
    if (const auto table = part.tables.find(key); table != part.tables.end() && wanted(key) && !own.find(key))
      spelled.members.push_back({key, said.place, table->second});
  spelled.members.insert(spelled.members.end(), own.members.begin(), own.members.end());
  return {said.place, std::move(spelled)};
}

void put_beside(const CataloguePart& part, formats::Table& owner) {
  for (const char* key : part.kind->beside) {
    const auto given = part.tables.find(key);
    if (given == part.tables.end()) continue;
    formats::Value whole = given->second;
    if (formats::Member* own = owner.find(key)) {
      formats::merge(whole, own->value);
      own->value = std::move(whole);
    } else {
      owner.members.push_back({key, whole.place, std::move(whole)});
    }
  }
}

}  // namespace netloft::gears
