// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/reference_page.hpp"
#include "io/program/session/commands.hpp"
#include "io/program/session/components.hpp"
#include "io/scenes/reading/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace netloft::program {

namespace {

/// Column of a page's table and key of a component's description.
struct Column {
  const char *title, *key;
};
struct Section {
  const char *key, *heading;
  std::vector<Column> columns;
};

const std::vector<Section>& sections() {
  static const std::vector<Section> all = {
      {"geometry",
       "Geometry",
       {{"key", "name"}, {"allowed", "allowed"}, {"default", "default"}, {"what it is", "doc"}}},
      {"parameters",
       "Parameters",
       {{"name", "name"}, {"allowed", "allowed"}, {"default", "default"}, {"what it is", "doc"}}},
      {"data", "Data of each element", {{"name", "name"}, {"unit", "unit"}, {"what it is", "doc"}}},
      {"laws", "Places for laws", {{"key", "name"}, {"default", "default"}, {"what it is", "doc"}}},
      {"measured_for", "Measured for", {{"range and source", "text"}}},
      {"terms", "Terms", {{"name", "name"}, {"traits", "traits"}, {"what it is", "doc"}}},
      {"outputs", "Outputs", {{"name", "name"}, {"unit", "unit"}, {"what it is", "doc"}}},
  };
  return all;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "" : value.dump();
}

Page::Table table(const Section& section, const Json& rows) {
  Page::Table t{section.heading, {}, {}};
  for (const auto& column : section.columns) t.columns.push_back(column.title);
  for (const auto& row : rows) {
    auto& cells = t.rows.emplace_back();
    for (const auto& column : section.columns) cells.push_back(text_of(row.value(column.key, Json())));
  }
  return t;
}

void add_tables(Page& page, const Json& described) {
  for (const auto& section : sections())
    if (described.contains(section.key) && !described[section.key].empty())
      page.tables.push_back(table(section, described[section.key]));
}

std::string file_of(std::string type) {
  std::replace(type.begin(), type.end(), '/', '-');
  return type;
}

Page page_of(const Component& c, const PluginOrigin& origin) {
  const Json described = c.json();
  Page page{file_of(c.type), c.type, {std::string(c.doc) + "."}, {}, {}};
  std::string origins =
      "A component of the kind " + c.kind + "; plugin " + origin.name + " " + origin.version + ".";
  if (described.contains("stands_on")) origins += " It stands on " + text_of(described["stands_on"]) + ".";
  page.paragraphs.push_back(origins);
  add_tables(page, described);
  return page;
}

Page page_of_table(const std::string& name, std::span<const netloft_parameter> keys) {
  Page page{name, "[" + name + "]", {"A table of the scene."}, {}, {}};
  add_tables(page, {{"parameters", parameter_json(keys)}});
  return page;
}

std::vector<Page> all_pages(Registry& registry) {
  std::vector<Page> pages = {
      page_of_table("water", scenes::water_keys()),       page_of_table("waves", scenes::wave_keys()),
      page_of_table("tow", scenes::tow_keys()),           page_of_table("bed", scenes::bed_keys()),
      page_of_table("analysis", scenes::analysis_keys()), page_of_table("gear", scenes::gear_keys())};
  for (const auto& name : registry.available()) {
    const PluginContent& plugin = registry.plugin(name);
    for (const auto& c : components_of(plugin)) pages.push_back(page_of(c, plugin.origin));
  }
  return pages;
}

Page index_of(const std::vector<Page>& pages) {
  Page index{"index", "Reference", {}, {}, {}};
  index.paragraphs.push_back(
      "All components of this installation and the tables of a scene that belong to none. Units are SI; a "
      "text "
      "with another unit is converted. Made from the tables of the plugins by `netloft reference`.");
  for (const auto& page : pages) index.links.push_back({page.title, page.file, page.paragraphs.front()});
  return index;
}

}  // namespace

int reference_command(const Options& options) {
  Registry registry;
  Options search;  // the folder to be written is none to search
  search.plugins = options.plugins;
  find_plugins(search, registry);
  const std::filesystem::path folder = options.target;
  if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
    throw UsageError{folder.string() + ": is no folder"};
  std::vector<Page> pages = all_pages(registry);
  pages.push_back(index_of(pages));
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw formats::WriteError(folder.string() + " cannot be made: " + error.message());
  for (const auto& page : pages) {
    formats::write_whole(folder / (page.file + ".md"), markdown(page));
    formats::write_whole(folder / (page.file + ".html"), html(page));
  }
  formats::write_whole(folder / "scene.schema.json",
                       scene_schema(registry).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  fmt::print("{} pages and scene.schema.json in {}\n", pages.size(), folder.string());
  return kDone;
}

}  // namespace netloft::program
