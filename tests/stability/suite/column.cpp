// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/column.hpp"

#include "io/formats/toml/document.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/scenes/reading/analysis.hpp"

namespace netloft::hard_cases {

namespace {

constexpr const char* kAuto = "auto";

}  // namespace

std::string Column::head() const {
  if (!title.empty()) return title;
  if (strategy.empty() || solver.empty()) return strategy + solver;
  return strategy + " with " + solver;
}

Column column_of(const std::string& solver) { return {solver, ""}; }

void leave_out(const std::vector<std::string>& parts, Column& column) {
  if (parts.empty() || component_of(column.strategy) != kAuto) return;
  std::string all;
  for (const auto& part : parts) all += (all.empty() ? "" : "+") + part;
  const std::string key = "without=";
  std::string& text = column.strategy;
  for (auto at = text.find_first_of(":,"); at != std::string::npos; at = text.find_first_of(":,", at + 1))
    if (text.compare(at + 1, key.size(), key) == 0) {
      text.insert(at + 1 + key.size(), all + "+");
      return;
    }
  text += (text == kAuto ? ":" : ",") + key + all;
}

std::string component_of(const std::string& specification) {
  return specification.substr(0, specification.find(':'));
}

/// The solver and strategy come last, so that no other setting of the column replaces them.
std::vector<std::string> overrides_of(const Column& column) {
  std::vector<std::string> all = column.overrides;
  const auto choose = [&](const char* key, const std::string& specification) {
    if (specification.empty()) return;
    for (const formats::Change& change : runs::choose_method(key, specification)) all.push_back(change.text);
  };
  choose("solver", column.solver);
  choose("strategy", column.strategy);
  return all;
}

bool check_settings(const Column& column, Registry& registry, formats::Diagnostics& diagnostics) {
  std::vector<std::string> settings = overrides_of(column);
  std::erase_if(settings, [](const std::string& text) { return !text.starts_with("analysis."); });
  const auto document = formats::Document::parse("", column.head(), settings, diagnostics);
  formats::TableReader root(document.root(), diagnostics);
  bool refused = false;
  scenes::read_analysis(root.table("analysis", formats::Presence::optional), registry, refused);
  root.finish();
  return refused;
}

}  // namespace netloft::hard_cases
