// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/catalogue.hpp"

#include "framework/scene/standard_gravity.hpp"
#include "io/formats/text/name_fault.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/gears/catalogue/folders.hpp"

#include <algorithm>
#include <numbers>

namespace netloft::gears {

namespace {

constexpr double kSeaWater = 1025;  // density ρ_w of sea water [kg/m³]

/// The entries at the beginning of a catalogue file, which apply to all parts in the file.
struct FileHead {
  std::string source, uncertainty;
};

FileHead read_head(formats::TableReader& root) {
  return {root.text("source", {.doc = "where the numbers come from", .fallback = ""}),
          root.text("uncertainty", {.doc = "uncertainty of the numbers", .fallback = ""})};
}

/// Reads `synonyms = [["pa", "nylon"], …]`.
std::vector<std::vector<std::string>> read_synonyms(formats::TableReader& root) {
  std::vector<std::vector<std::string>> groups;
  const formats::Value* said = root.raw("synonyms");
  const formats::Array* array = said ? said->as<formats::Array>() : nullptr;
  bool is_sound = !said || array;
  for (std::size_t i = 0; array && i < array->items.size(); ++i) {
    const formats::Array* words = array->items[i].as<formats::Array>();
    is_sound = is_sound && words;
    groups.emplace_back();
    for (std::size_t k = 0; words && k < words->items.size(); ++k) {
      const std::string* word = words->items[k].as<std::string>();
      is_sound = is_sound && word;
      if (word) groups.back().push_back(*word);
    }
  }
  if (!is_sound)
    root.error("synonyms", "is not an array of groups of words", "such as [[\"pa\", \"nylon\"]]");
  return groups;
}

std::string read_own_or_head(formats::TableReader& table, const char* key, const char* doc,
                             const std::string& head) {
  return head.empty() ? table.text(key, {.doc = doc}) : table.text(key, {.doc = doc, .fallback = head});
}

void read_texts(CataloguePart& part, const FileHead& head, formats::TableReader& table) {
  part.texts["source"] = read_own_or_head(table, "source", "where its numbers come from", head.source);
  part.texts["uncertainty"] =
      read_own_or_head(table, "uncertainty", "uncertainty of the numbers", head.uncertainty);
  for (const char* key : part.kind->texts) part.texts[key] = table.text(key, {});
  if (table.has("doc")) part.texts["doc"] = table.text("doc", {});
}

void read_numbers(CataloguePart& part, formats::TableReader& table) {
  for (const auto& key : part.kind->numbers)
    if (key.required || table.has(key.name))
      part.numbers[key.name] =
          table.real(key.name, {.unit = key.unit, .doc = key.doc, .range = formats::between(key.lo, key.hi)});
}

void read_tables(CataloguePart& part, formats::TableReader& table) {
  for (const auto* keys : {&part.kind->tables, &part.kind->beside})
    for (const char* key : *keys)
      if (const formats::Value* value = table.raw(key)) part.tables.emplace(key, *value);
}

bool has_all(const CataloguePart& part, std::initializer_list<const char*> keys) {
  return std::all_of(keys.begin(), keys.end(), [&](const char* key) { return part.numbers.contains(key); });
}

bool is_line(const CataloguePart& part) { return has_all(part, {"EA", "diameter"}); }

double density_in_water(double m, double material, double d) {
  const double area = std::numbers::pi / 4 * d * d;
  return kSeaWater + m / area * (1 - kSeaWater / material);  // (1)
}

void derive_line(CataloguePart& part, formats::TableReader& table) {
  auto& n = part.numbers;
  if (n.contains("density")) return;
  if (n.contains("weight_in_water") && !n.contains("mass")) {
    n["density"] = kSeaWater + n["weight_in_water"] /
                                   (kStandardGravity * std::numbers::pi / 4 * n["diameter"] * n["diameter"]);
    if (n["density"] <= 0) table.error("weight_in_water", "means that the rope has a mass of 0 or less");
    return;
  }
  if (!has_all(part, {"mass", "material_density"}))
    return table.error(
        "density", "must be given, or mass and material_density, or weight_in_water, from which it follows");
  n["density"] = density_in_water(n["mass"], n["material_density"], n["diameter"]);
  if (n["density"] <= 0)
    table.error("mass", "does not fit into the diameter: a line of this mass and material would be thicker");
}

void derive_piece(CataloguePart& part, formats::TableReader& table) {
  auto& n = part.numbers;
  if (!n.contains("volume") && has_all(part, {"mass", "material_density"}))
    n["volume"] = n["mass"] / n["material_density"];  // (2)
  if (!n.contains("buoyancy") && !has_all(part, {"mass", "volume"}))
    table.error("buoyancy", "must be given, or mass with volume or material_density, from which it follows");
}

void derive(CataloguePart& part, formats::TableReader& table) {
  if (is_line(part)) derive_line(part, table);
  if (part.kind->key == std::string_view("float")) derive_piece(part, table);
}

CataloguePart read_part(const std::string& name, const PartKind& kind, const FileHead& head,
                        formats::TableReader& table) {
  CataloguePart part;
  part.name = name;
  part.kind = &kind;
  const int errors_before = table.diagnostics().errors();
  read_texts(part, head, table);
  read_numbers(part, table);
  read_tables(part, table);
  if (table.diagnostics().errors() == errors_before) derive(part, table);
  return part;
}

/// The .toml files of a folder, sorted so that the order of messages is the same on all systems.
std::vector<std::filesystem::path> toml_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.path().extension() == ".toml" && entry.is_regular_file(none)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Catalogue Catalogue::load(const std::vector<std::filesystem::path>& folders,
                          formats::Diagnostics& diagnostics) {
  Catalogue catalogue;
  for (const auto& folder : folders) catalogue.read_folder(folder, diagnostics);
  return catalogue;
}

Catalogue Catalogue::load_file(const std::filesystem::path& file, formats::Diagnostics& diagnostics) {
  Catalogue catalogue;
  catalogue.read(formats::Document::load(file, {}, diagnostics), file, 0, diagnostics);
  return catalogue;
}

Catalogue Catalogue::recall(const std::vector<formats::SourceFile>& files,
                            formats::Diagnostics& diagnostics) {
  Catalogue catalogue;
  std::size_t first_of_folder = 0;
  std::filesystem::path folder;
  for (const auto& file : files) {
    const std::filesystem::path path = file.path;
    if (path.extension() != ".toml") continue;
    if (path.parent_path() != folder) first_of_folder = catalogue.parts_.size();
    folder = path.parent_path();
    catalogue.read(formats::Document::recall({file}, diagnostics), path, first_of_folder, diagnostics);
  }
  return catalogue;
}

void Catalogue::read_folder(const std::filesystem::path& folder, formats::Diagnostics& diagnostics) {
  folders_.push_back(folder);
  const std::size_t first_of_folder = parts_.size();
  for (const auto& file : toml_files(folder))
    read(formats::Document::load(file, {}, diagnostics), file, first_of_folder, diagnostics);
}

void Catalogue::read(const formats::Document& document, const std::filesystem::path& file,
                     std::size_t first_of_folder, formats::Diagnostics& diagnostics) {
  files_.insert(files_.end(), document.files().begin(), document.files().end());
  formats::TableReader root(document.root(), diagnostics);
  const FileHead head = read_head(root);
  const auto synonyms = read_synonyms(root);
  synonyms_.insert(synonyms_.end(), synonyms.begin(), synonyms.end());
  for (const auto& kind : part_kinds()) {
    formats::TableReader tables = root.table(kind.name, formats::Presence::optional);
    for (const auto& name : tables.keys()) {
      if (const std::string fault = formats::name_fault(name); !fault.empty())
        tables.error(name, "the name of a part, " + formats::in_quotes(name) + ", " + fault);
      formats::TableReader table = tables.table(name, formats::Presence::required, "a part of the catalogue");
      CataloguePart part = read_part(name, kind, head, table);
      part.file = file.string();
      add(std::move(part), table.place(), first_of_folder, diagnostics);
    }
  }
  root.finish();
}

void Catalogue::add(CataloguePart part, const formats::Place& place, std::size_t first_of_folder,
                    formats::Diagnostics& diagnostics) {
  const auto same = [&](const CataloguePart& other) {
    return other.kind == part.kind && other.name == part.name;
  };
  const auto earlier = std::find_if(parts_.begin(), parts_.end(), same);
  if (earlier == parts_.end())
    parts_.push_back(std::move(part));
  else if (earlier - parts_.begin() >= static_cast<std::ptrdiff_t>(first_of_folder))
    diagnostics.error(place, std::string("the ") + part.kind->name + " \"" + part.name +
                                 "\" is in this folder twice, also in " + earlier->file);
}

void Catalogue::shift_files(int by) {
  for (CataloguePart& part : parts_)
    for (auto& [key, table] : part.tables) formats::shift_files(table, by);
}

std::shared_ptr<const Catalogue> KeptCatalogue::of(const std::vector<std::filesystem::path>& own,
                                                   formats::Diagnostics& diagnostics) {
  if (!catalogue_ || own != own_) {
    said_ = {};
    catalogue_ = std::make_shared<Catalogue>(Catalogue::load(catalogue_folders(said_, own), said_));
    own_ = own;
    first_file_ = 0;
  }
  if (const int first = diagnostics.append(said_); first != first_file_) {
    Catalogue moved = *catalogue_;
    moved.shift_files(first - first_file_);
    catalogue_ = std::make_shared<Catalogue>(std::move(moved));
    first_file_ = first;
  }
  return catalogue_;
}

const CataloguePart* Catalogue::find(const std::string& name, const std::vector<std::string>& kinds) const {
  for (const auto& part : parts_)
    if (part.name == name && std::find(kinds.begin(), kinds.end(), part.kind->name) != kinds.end())
      return &part;
  return nullptr;
}

}  // namespace netloft::gears
