// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/catalogue_parts.hpp"

#include "io/formats/toml/table_reader.hpp"
#include "io/gears/catalogue/folders.hpp"
#include "io/gears/catalogue/part_choice.hpp"

#include <limits>
#include <optional>
#include <set>

namespace netloft::scenes {

namespace {

/// A part of the scene whose table names a part of the catalogue.
struct NamedPart {
  std::string name;  // name of the part in the scene
  formats::Table* part;
  std::string key;  // key of the table that names the catalogue part: twine, rope, float or board
  std::string path;

  formats::Value& said() const { return part->find(key)->value; }
};

/// Calls visit(path, name, table) for the tables of all parts and bodies.
template <class Visit>
void for_pieces(formats::Value& scene, const Visit& visit) {
  formats::Table* root = scene.as<formats::Table>();
  for (const char* home : {"parts", "bodies"}) {
    formats::Member* pieces = root ? root->find(home) : nullptr;
    formats::Table* all = pieces ? pieces->value.as<formats::Table>() : nullptr;
    for (std::size_t i = 0; all && i < all->members.size(); ++i)
      if (formats::Table* piece = all->members[i].value.as<formats::Table>())
        visit(formats::join_path(home, all->members[i].key), all->members[i].key, *piece);
  }
}

std::vector<NamedPart> find_mentions(formats::Value& scene) {
  std::vector<NamedPart> mentions;
  for_pieces(scene, [&](const std::string& path, const std::string& name, formats::Table& part) {
    for (const auto& key : gears::part_keys())
      if (formats::Member* said = part.find(key); said && gears::names_a_part(said->value))
        mentions.push_back({name, &part, key, formats::join_path(path, key)});
  });
  return mentions;
}

void insert_numbers(std::set<std::string>& known, const std::vector<netloft_parameter>& table,
                    const std::string& prefix) {
  for (const auto& p : table)
    if (std::string_view(p.name).starts_with(prefix)) known.insert(p.name + prefix.size());
}

/// The parameters in the table `key` of all element types of the part's plugin. All types are included,
/// because companions (elements that the plugin adds to every part of a type) read the same table.
std::set<std::string> known_numbers(const NamedPart& mention, Registry& registry) {
  std::set<std::string> known;
  const formats::Member* type = mention.part->find("type");
  const std::string* name = type ? type->value.as<std::string>() : nullptr;
  if (!name) return known;
  try {
    for (const auto& element : registry.plugin(name->substr(0, name->find('/'))).elements)
      insert_numbers(known, element.parameters, mention.key + ".");
  } catch (const PluginRefused&) {  // this is reported when the part is read
  }
  return known;
}

/// Any catalogue part of these kinds, as a substitute for a part that was not found, so that the rest of the
/// scene can be read. nullptr if the catalogue has no such part.
const gears::CataloguePart* stand_in(const gears::Catalogue& catalogue, const std::string& key) {
  for (const auto& part : catalogue.parts())
    if (part.kind->key == key) return &part;
  return nullptr;
}

void put(const NamedPart& mention, const gears::Catalogue& catalogue, Registry& registry,
         formats::Diagnostics& diagnostics, std::map<std::string, Strength>& strengths) {
  const gears::CataloguePart* part = gears::choose_part(mention.said(), gears::kinds_under(mention.key),
                                                        mention.path, catalogue, diagnostics);
  if (!part) part = stand_in(catalogue, mention.key);
  if (!part) return;
  if (const auto load = part->numbers.find("breaking_load"); load != part->numbers.end())
    strengths[mention.name] = {load->second, part->name};
  else
    strengths.try_emplace(mention.name, Strength{std::numeric_limits<double>::quiet_NaN(), part->name});
  const auto known = known_numbers(mention, registry);
  mention.said() =
      gears::spell_out(mention.said(), *part, [&](const std::string& key) { return known.contains(key); });
  gears::put_beside(*part, *mention.part);
}

constexpr const char *kPolar = "polar", *kSlip = "sideslip";

/// A board whose table names a polar (coefficients as functions of the angle of attack) of the catalogue:
/// `board = { polar = "cambered-low-aspect" }`.
struct NamedPolar {
  formats::Table* board;
  std::string path;
};

std::vector<NamedPolar> find_polars(formats::Value& scene) {
  std::vector<NamedPolar> polars;
  for_pieces(scene, [&](const std::string& path, const std::string&, formats::Table& part) {
    for (auto& member : part.members)
      if (formats::Table* board = member.value.as<formats::Table>())
        if (const formats::Member* polar = board->find(kPolar);
            polar && polar->value.kind() == formats::Kind::text)
          polars.push_back({board, formats::join_path(formats::join_path(path, member.key), kPolar)});
  });
  return polars;
}

/// A table with those `columns` that the polar has. The first column is the angle. Returns nullopt if the
/// polar has no second column, that of the first coefficient.
std::optional<formats::Value> columns_of(const gears::CataloguePart& polar,
                                         const std::vector<const char*>& columns, formats::Place place) {
  formats::Table table;
  for (const char* column : columns)
    if (const auto given = polar.tables.find(column); given != polar.tables.end())
      table.members.push_back({column, given->second.place, given->second});
  const bool has_values = !table.members.empty() && table.find(columns[1]);
  return has_values ? std::optional<formats::Value>{{place, std::move(table)}} : std::nullopt;
}

/// Replaces the name of a polar by its columns.
void put_polar(const NamedPolar& named, const gears::Catalogue& catalogue,
               formats::Diagnostics& diagnostics) {
  formats::Member* said = named.board->find(kPolar);
  const formats::Place place = said->value.place;
  const gears::CataloguePart* polar =
      gears::choose_part(said->value, {kPolar}, named.path, catalogue, diagnostics);
  std::erase_if(named.board->members, [](const formats::Member& m) { return m.key == kPolar; });
  if (!polar) return;
  const bool over_slip = polar->tables.contains(kSlip);
  const auto put = [&](const char* key, std::optional<formats::Value> table) {
    if (table && !named.board->find(key)) named.board->members.push_back({key, place, std::move(*table)});
  };
  if (over_slip)
    put("polar_slip", columns_of(*polar, {"attack", "lift", kSlip, "drag", "side"}, place));
  else
    put(kPolar, columns_of(*polar, {"attack", "lift", "drag"}, place));
  put("pressure", columns_of(*polar, {"attack", "chord", "span"}, place));
}

}  // namespace

SceneCatalogue::SceneCatalogue(gears::KeptCatalogue& kept, const formats::Value& scene,
                               const std::filesystem::path& folder, formats::Diagnostics& diagnostics)
    : kept_(kept), diagnostics_(diagnostics), own_(gears::named_folders(scene, folder, diagnostics)) {}

std::shared_ptr<const gears::Catalogue> SceneCatalogue::load() {
  if (!catalogue_) catalogue_ = kept_.of(own_, diagnostics_);
  return catalogue_;
}

void put_catalogue_parts(formats::Value& scene, SceneCatalogue& catalogue, Registry& registry,
                         formats::Diagnostics& diagnostics, std::map<std::string, Strength>& strengths) {
  const auto mentions = find_mentions(scene);
  if (mentions.empty() && find_polars(scene).empty()) return;
  const auto parts = catalogue.load();
  for (const auto& mention : mentions) put(mention, *parts, registry, diagnostics, strengths);
  for (const auto& polar : find_polars(scene)) put_polar(polar, *parts, diagnostics);
}

}  // namespace netloft::scenes
