// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/nearest.hpp"
#include "io/formats/units/units.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/catalogue/folders.hpp"
#include "io/program/commands/gears.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/terminal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace netloft::program {

namespace {

using Json = nlohmann::ordered_json;

/// Formats a value with five digits, which are more than catalogues state.
std::string rounded(double value, const char* unit) {
  return fmt::format("{:.5g}{}{}", value, unit == std::string_view("1") ? "" : " ",
                     unit == std::string_view("1") ? "" : unit);
}

std::string line_of(const gears::CataloguePart& part) {
  std::string text = fmt::format("{:<8} {:<26}", part.kind->name, part.name);
  int shown = 0;
  for (const auto& key : part.kind->numbers)
    if (part.numbers.contains(key.name) && shown++ < 3)
      text += fmt::format(" {} {}{}", key.name, rounded(part.numbers.at(key.name), key.unit),
                          shown < 3 ? "," : "");
  while (text.ends_with(',')) text.pop_back();
  return text;
}

std::string page_of(const gears::CataloguePart& part) {
  std::string text = fmt::format("{} {}\n", part.kind->name, part.name);
  for (const auto& key : part.kind->numbers)
    if (part.numbers.contains(key.name))
      text += fmt::format("  {:<18} {:<18} {}\n", key.name, rounded(part.numbers.at(key.name), key.unit),
                          key.doc);
  for (const auto& [key, words] : part.texts) text += fmt::format("  {:<18} {}\n", key, words);
  return text + fmt::format("  {:<18} {}", "file", part.file);
}

Json json_of(const gears::CataloguePart& part) {
  Json json = {{"kind", part.kind->name}, {"name", part.name}};
  for (const auto& key : part.kind->numbers)
    if (part.numbers.contains(key.name))
      json["numbers"][key.name] = {{"value", part.numbers.at(key.name)}, {"unit", key.unit}};
  for (const auto& [key, words] : part.texts) json[key] = words;
  json["file"] = part.file;
  return json;
}

/// The parts with this name or of this kind; all parts if the word is empty.
std::vector<const gears::CataloguePart*> asked_for(const gears::Catalogue& catalogue,
                                                   const std::string& word) {
  std::vector<const gears::CataloguePart*> parts;
  for (const auto& part : catalogue.parts())
    if (word.empty() || word == part.name || word == part.kind->name) parts.push_back(&part);
  return parts;
}

[[noreturn]] void refuse(const gears::Catalogue& catalogue, const std::string& word) {
  std::vector<std::string> names;
  std::string kinds;
  for (const auto& kind : gears::part_kinds()) {
    names.emplace_back(kind.name);
    kinds += (kinds.empty() ? "" : ", ") + names.back();
  }
  for (const auto& part : catalogue.parts()) names.push_back(part.name);
  const auto near = nearest(word, names);
  throw UsageError{"there is no part and no kind of parts \"" + word + "\" in the catalogue" +
                   (near ? "; did you mean \"" + *near + "\"?" : "") + " (kinds: " + kinds + ")"};
}

}  // namespace

int catalogue_command(const CatalogueOptions& options) {
  formats::Diagnostics diagnostics;
  const gears::Catalogue catalogue =
      gears::Catalogue::load(gears::catalogue_folders(diagnostics), diagnostics);
  if (diagnostics.errors()) {
    Terminal terminal(options);
    terminal.say(diagnostics);
    if (options.json) print_line(error_json("the catalogue has errors", kWrongInput));
    return kWrongInput;
  }
  const auto parts = asked_for(catalogue, options.name);
  if (parts.empty() && !options.name.empty()) refuse(catalogue, options.name);
  Json all = Json::array();
  for (const auto* part : parts) {
    all.push_back(json_of(*part));
    if (!options.json) print_line(part->name == options.name ? page_of(*part) : line_of(*part));
  }
  if (options.json) print_line(Json{{"parts", all}}.dump(2, ' ', false, Json::error_handler_t::replace));
  return kDone;
}

}  // namespace netloft::program
