// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/merged_scene.hpp"

#include "io/formats/toml/change.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/gears/catalogue/part_choice.hpp"

#include <string_view>

namespace netloft::results {

namespace {

/// The value at a path of keys; nullptr if there is none.
const formats::Value* find(const formats::Value& root, std::initializer_list<std::string_view> path) {
  const formats::Value* at = &root;
  for (const auto key : path) {
    const auto* table = at->as<formats::Table>();
    const auto* member = table ? table->find(key) : nullptr;
    if (!member) return nullptr;
    at = &member->value;
  }
  return at;
}

constexpr const char *kTitle = "gear", *kSource = "source";

}  // namespace

std::vector<std::string> values_of_option(const Origins& origins, const std::string& option) {
  const auto& words = origins.command;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) values.push_back(words[i + 1]);
    if (words[i].starts_with(option + "=")) values.push_back(words[i].substr(option.size() + 1));
  }
  return values;
}

std::optional<formats::Value> merged_scene(const Origins& origins, std::set<std::string>& paths) {
  if (origins.files.empty()) return std::nullopt;
  std::vector<formats::SourceFile> files;
  for (const auto& file : origins.files) files.push_back({file.path, file.text, file.hash});
  formats::Diagnostics unheard;
  const auto document = formats::Document::recall(std::move(files), unheard);
  formats::Value root = document.root();
  for (const auto& text : values_of_option(origins, "--set"))
    formats::apply(root, formats::read_change(text), unheard, gears::keys_that_name_parts());
  if (unheard.errors()) return std::nullopt;
  for (const auto& file : document.files()) paths.insert(file.path);
  return root;
}

std::vector<Condition> conditions_of(const Result& result) {
  std::set<std::string> unused;
  const auto scene = result.gear ? merged_scene(result.origins, unused) : std::nullopt;
  std::vector<Condition> all;
  if (!scene) return all;
  const auto add = [&](const char* name, std::initializer_list<std::string_view> path,
                       const std::string& unit = "") {
    const formats::Value* value = find(*scene, path);
    if (!value || value->as<formats::Table>()) return;
    const auto* text = value->as<std::string>();
    all.push_back({name, text ? *text : spell_value(*value) + unit});
  };
  add(kTitle, {"gear", "title"});
  add(kSource, {"gear", "source"});
  add("speed of the ship", {"ship", "speed"}, " m/s");
  add("speed of the tow", {"tow", "speed"}, " m/s");
  add("current", {"water", "current"}, " m/s");
  add("depth", {"bed", "depth"}, " m");
  add("warp", {"ship", "warp", "length"}, " m");
  return all;
}

std::string conditions_line(const std::vector<Condition>& conditions) {
  std::string line;
  for (const auto& one : conditions)
    if (one.name != kTitle && one.name != kSource)
      line += (line.empty() ? "" : ", ") + one.name + " " + one.value;
  return line;
}

}  // namespace netloft::results
