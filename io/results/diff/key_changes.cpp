// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/key_changes.hpp"

#include "io/formats/toml/document.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/results/figures/merged_scene.hpp"

#include <algorithm>

namespace netloft::results {

namespace {

using formats::Array, formats::Table, formats::Value;

bool is_same(const Value& a, const Value& b) { return spell_value(a) == spell_value(b); }

/// Whether an array consists of tables, such as [[hold]].
bool has_tables(const Array& array) {
  return !array.items.empty() &&
         std::ranges::all_of(array.items, [](const Value& item) { return item.as<Table>() != nullptr; });
}

/// Collects the changes between two values.
class Comparison {
 public:
  std::vector<KeyChange> take() { return std::move(changes_); }

  void compare(const Value& a, const Value& b, const std::string& path) {
    const Table *table = a.as<Table>(), *other_table = b.as<Table>();
    const Array *array = a.as<Array>(), *other_array = b.as<Array>();
    if (table && other_table)
      compare_tables(*table, *other_table, path);
    else if (array && other_array && has_tables(*array) && has_tables(*other_array))
      compare_items(array->items, other_array->items, path);
    else if (!is_same(a, b))
      changes_.push_back({path, spell_value(a), spell_value(b)});
  }

 private:
  void compare_tables(const Table& a, const Table& b, const std::string& path) {
    for (const auto& member : a.members) {
      const std::string key = formats::join_path(path, member.key);
      if (const auto* other = b.find(member.key))
        compare(member.value, other->value, key);
      else
        changes_.push_back({key, spell_value(member.value), ""});
    }
    for (const auto& member : b.members)
      if (!a.find(member.key))
        changes_.push_back({formats::join_path(path, member.key), "", spell_value(member.value)});
  }

  /// Compares the items of two arrays in their order, after skipping equal items at both ends. A path
  /// contains the index in the first array; for items that only the second array has, the index in the second
  /// array.
  void compare_items(const std::vector<Value>& a, const std::vector<Value>& b, const std::string& path) {
    std::size_t head = 0, tail = 0;
    const std::size_t fewer = std::min(a.size(), b.size());
    while (head < fewer && is_same(a[head], b[head])) ++head;
    while (head + tail < fewer && is_same(a[a.size() - 1 - tail], b[b.size() - 1 - tail])) ++tail;
    for (std::size_t i = head; i + tail < std::max(a.size(), b.size()); ++i) {
      const std::string item = path + "[" + std::to_string(i) + "]";
      const bool is_in_a = i + tail < a.size(), is_in_b = i + tail < b.size();
      if (is_in_a && is_in_b)
        compare(a[i], b[i], item);
      else
        changes_.push_back({item, is_in_a ? spell_value(a[i]) : "", is_in_b ? spell_value(b[i]) : ""});
    }
  }

  std::vector<KeyChange> changes_;
};

std::vector<KeyChange> changes_between(const Value& before, const Value& after) {
  Comparison comparison;
  comparison.compare(before, after, "");
  return comparison.take();
}

}  // namespace

std::optional<std::vector<KeyChange>> find_key_changes(const Origins& before, const Origins& after,
                                                       std::set<std::string>& files) {
  const auto a = merged_scene(before, files), b = merged_scene(after, files);
  return a && b ? std::optional(changes_between(*a, *b)) : std::nullopt;
}

std::optional<std::vector<KeyChange>> find_key_changes(const std::string& before, const std::string& after) {
  formats::Diagnostics unheard;
  const auto tables_of = [&](const std::string& text) {
    return formats::Document::recall({{"text", text, ""}}, unheard).root();
  };
  const Value a = tables_of(before), b = tables_of(after);
  return unheard.errors() ? std::nullopt : std::optional(changes_between(a, b));
}

}  // namespace netloft::results
