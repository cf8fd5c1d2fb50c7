// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/catalogue_parts.hpp"

#include "io/gears/catalogue/folders.hpp"
#include "io/gears/catalogue/part_choice.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <limits>
#include <optional>
#include <set>

namespace netloft::io {

namespace {

/// Where a scene names a part of the catalogue.
struct Mention {
  std::string name;  // of the part of the scene
  Table* part;
  std::string key;  // its twine, rope, float or board
  std::string path;

  Value& said() const { return part->find(key)->value; }
};

/// Calls visit(path, name, table) for all parts and bodies.
template <class Visit>
void for_pieces(Value& scene, const Visit& visit) {
  Table* root = scene.as<Table>();
  for (const char* home : {"parts", "bodies"}) {
    Member* pieces = root ? root->find(home) : nullptr;
    Table* all = pieces ? pieces->value.as<Table>() : nullptr;
    for (std::size_t i = 0; all && i < all->members.size(); ++i)
      if (Table* piece = all->members[i].value.as<Table>())
        visit(join_path(home, all->members[i].key), all->members[i].key, *piece);
  }
}

std::vector<Mention> find_mentions(Value& scene) {
  std::vector<Mention> mentions;
  for_pieces(scene, [&](const std::string& path, const std::string& name, Table& part) {
    for (const auto& key : part_keys())
      if (Member* said = part.find(key); said && names_a_part(said->value))
        mentions.push_back({name, &part, key, join_path(path, key)});
  });
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
      choose_part(mention.said(), kinds_under(mention.key), mention.path, catalogue, diagnostics);
  if (!part) part = stand_in(catalogue, mention.key);
  if (!part) return;
  if (const auto load = part->numbers.find("breaking_load"); load != part->numbers.end())
    strengths[mention.name] = {load->second, part->name};
  else
    strengths.try_emplace(mention.name, Strength{std::numeric_limits<double>::quiet_NaN(), part->name});
  const auto known = known_numbers(mention, registry);
  mention.said() =
      spell_out(mention.said(), *part, [&](const std::string& key) { return known.contains(key); });
  put_beside(*part, *mention.part);
}

constexpr const char *kPolar = "polar", *kSlip = "sideslip";

/// Where a board names its polar: `board = { polar = "cambered-low-aspect" }`.
struct NamedPolar {
  Table* board;
  std::string path;
};

std::vector<NamedPolar> find_polars(Value& scene) {
  std::vector<NamedPolar> polars;
  for_pieces(scene, [&](const std::string& path, const std::string&, Table& part) {
    for (auto& member : part.members)
      if (Table* board = member.value.as<Table>())
        if (const Member* polar = board->find(kPolar); polar && polar->value.kind() == Kind::text)
          polars.push_back({board, join_path(join_path(path, member.key), kPolar)});
  });
  return polars;
}

/// A table of some columns of a polar; nothing if it lacks the first of them.
std::optional<Value> columns_of(const CataloguePart& polar, const std::vector<const char*>& columns,
                                Place place) {
  Table table;
  for (const char* column : columns)
    if (const auto given = polar.tables.find(column); given != polar.tables.end())
      table.members.push_back({column, given->second.place, given->second});
  const bool has_values = !table.members.empty() && table.find(columns[1]);
  return has_values ? std::optional<Value>{{place, std::move(table)}} : std::nullopt;
}

/// What a polar knows takes the place of its name.
void put_polar(const NamedPolar& named, const Catalogue& catalogue, Diagnostics& diagnostics) {
  Member* said = named.board->find(kPolar);
  const Place place = said->value.place;
  const CataloguePart* polar = choose_part(said->value, {kPolar}, named.path, catalogue, diagnostics);
  std::erase_if(named.board->members, [](const Member& m) { return m.key == kPolar; });
  if (!polar) return;
  const bool over_slip = polar->tables.contains(kSlip);
  const auto put = [&](const char* key, std::optional<Value> table) {
    if (table && !named.board->find(key)) named.board->members.push_back({key, place, std::move(*table)});
  };
  if (over_slip)
    put("polar_slip", columns_of(*polar, {"attack", "lift", kSlip, "drag", "side"}, place));
  else
    put(kPolar, columns_of(*polar, {"attack", "lift", "drag"}, place));
  put("pressure", columns_of(*polar, {"attack", "chord", "span"}, place));
}

}  // namespace

std::vector<SourceFile> put_catalogue_parts(Value& scene, const std::filesystem::path& folder,
                                            Registry& registry, Diagnostics& diagnostics,
                                            std::map<std::string, Strength>& strengths) {
  const auto mentions = find_mentions(scene);
  const auto own = own_folders(scene, folder, diagnostics);
  if (mentions.empty() && find_polars(scene).empty()) return {};
  const Catalogue catalogue = Catalogue::load(catalogue_folders(diagnostics, own), diagnostics);
  for (const auto& mention : mentions) put(mention, catalogue, registry, diagnostics, strengths);
  for (const auto& polar : find_polars(scene)) put_polar(polar, catalogue, diagnostics);
  return catalogue.files();
}

}  // namespace netloft::io
