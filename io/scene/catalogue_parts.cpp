// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/catalogue_parts.hpp"

#include "io/catalogue/folders.hpp"
#include "io/catalogue/part_choice.hpp"
#include "io/toml/table_reader.hpp"

#include <set>

namespace netloft::io {

namespace {

/// Where a scene names a part of the catalogue.
struct Mention {
  std::string name;  // of the part of the scene
  Table* part;
  Value* said;      // under its twine, rope or float
  std::string key;  // which of them
  std::string path;
};

std::vector<Mention> find_mentions(Value& scene) {
  std::vector<Mention> mentions;
  Table* root = scene.as<Table>();
  Member* parts = root ? root->find("parts") : nullptr;
  Table* all = parts ? parts->value.as<Table>() : nullptr;
  if (!all) return mentions;
  for (auto& member : all->members)
    if (Table* part = member.value.as<Table>())
      for (const auto& key : part_keys())
        if (Member* said = part->find(key); said && names_a_part(said->value))
          mentions.push_back(
              {member.key, part, &said->value, key, join_path(join_path("parts", member.key), key)});
  return mentions;
}

void insert_numbers(std::set<std::string>& known, const std::vector<netloft_parameter>& table,
                    const std::string& prefix) {
  for (const auto& p : table)
    if (std::string_view(p.name).starts_with(prefix)) known.insert(p.name + prefix.size());
}

/// What elements of a part's plugin know under `key`: those that ride on it read the same table.
std::set<std::string> known_numbers(const Mention& mention, Registry& registry) {
  std::set<std::string> known;
  const Member* type = mention.part->find("type");
  const std::string* name = type ? type->value.as<std::string>() : nullptr;
  if (!name) return known;
  try {
    for (const auto& element : registry.plugin(name->substr(0, name->find('/'))).elements)
      insert_numbers(known, element.parameters, mention.key + ".");
  } catch (const PluginRefused&) {  // it is said where the part is read
  }
  return known;
}

std::vector<std::filesystem::path> own_folders(Value& scene, const std::filesystem::path& folder,
                                               Diagnostics& diagnostics) {
  std::vector<std::filesystem::path> own;
  TableReader root(scene, diagnostics);
  for (const auto& name :
       root.texts("catalogue", {.doc = "folders with catalogues", .fallback = std::vector<std::string>{}})) {
    own.push_back(folder / name);
    if (const auto fault = folder_fault(own.back()); !fault.empty()) root.error("catalogue", fault);
  }
  return own;
}

/// Of a part that was not found, some other of its kind stands in, so that the rest is read as usual.
const CataloguePart* stand_in(const Catalogue& catalogue, const std::string& key) {
  for (const auto& part : catalogue.parts())
    if (part.kind->key == key) return &part;
  return nullptr;
}

void put(const Mention& mention, const Catalogue& catalogue, Registry& registry, Diagnostics& diagnostics,
         std::map<std::string, Strength>& strengths) {
  const CataloguePart* part =
      choose_part(*mention.said, kinds_under(mention.key), mention.path, catalogue, diagnostics);
  if (!part) part = stand_in(catalogue, mention.key);
  if (!part) return;
  if (const auto load = part->numbers.find("breaking_load"); load != part->numbers.end())
    strengths[mention.name] = {load->second, part->name};
  const auto known = known_numbers(mention, registry);
  *mention.said =
      spell_out(*mention.said, *part, [&](const std::string& key) { return known.contains(key); });
}

}  // namespace

std::vector<SourceFile> put_catalogue_parts(Value& scene, const std::filesystem::path& folder,
                                            Registry& registry, Diagnostics& diagnostics,
                                            std::map<std::string, Strength>& strengths) {
  const auto mentions = find_mentions(scene);
  const auto own = own_folders(scene, folder, diagnostics);
  if (mentions.empty()) return {};
  const Catalogue catalogue = Catalogue::load(catalogue_folders(own), diagnostics);
  for (const auto& mention : mentions) put(mention, catalogue, registry, diagnostics, strengths);
  return catalogue.files();
}

}  // namespace netloft::io
