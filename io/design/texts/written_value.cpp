// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/written_value.hpp"

#include "io/design/texts/literal.hpp"
#include "io/formats/toml/spelled_value.hpp"

#include <algorithm>
#include <optional>

namespace netloft::design {

namespace {

using Path = std::span<const formats::PathStep>;

const formats::Value* next_value(const formats::Value& at, const formats::PathStep& step) {
  if (step.item) {
    const auto* array = at.as<formats::Array>();
    return array && *step.item < array->items.size() ? &array->items[*step.item] : nullptr;
  }
  const auto* table = at.as<formats::Table>();
  const formats::Member* member = table ? table->find(step.key) : nullptr;
  return member ? &member->value : nullptr;
}

std::optional<double> number_of(const formats::Value& value) {
  if (const auto* real = value.as<double>()) return *real;
  if (const auto* whole = value.as<std::int64_t>()) return static_cast<double>(*whole);
  return std::nullopt;
}

/// The name in a header such as "[panels.bag]" or "[[hold]]", without blanks; empty if there is no header.
std::string header_at(const std::string& text, std::size_t at) {
  if (at >= text.size() || text[at] != '[') return {};
  const std::size_t begin = text.find_first_not_of('[', at), end = text.find(']', at);
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::string name = text.substr(begin, end - begin);
  std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
  return name;
}

/// The name in the header of the table at a path. Items of an array have the name of the array.
std::string header_of(Path path) {
  std::string name;
  for (const formats::PathStep& step : path)
    if (!step.item) name = formats::join_path(name, step.key);
  return name;
}

std::size_t end_of_line(const std::string& text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

/// The first byte of the first table with a header; the end of the text if there is none.
std::size_t begin_of_tables(const std::string& text, const formats::Value& own) {
  std::size_t first = text.size();
  for (const formats::Member& member : own.as<formats::Table>()->members) {
    const formats::Value* value = &member.value;
    const auto* array = value->as<formats::Array>();
    if (array && array->from_headers) value = &array->items.front();
    if (!value->as<formats::Table>()) continue;
    const std::size_t at = byte_at(text, value->place.line, value->place.column);
    if (at < text.size() && text[at] == '[') first = std::min(first, at);
  }
  return first;
}

/// A value in the notation of a file. An array of tables has a line for each table.
std::string spell_in_lines(const formats::Value& value) {
  const auto* array = value.as<formats::Array>();
  if (!array || array->items.empty() || !array->items.front().as<formats::Table>())
    return formats::spell_in_file(value);
  std::string text = "[\n";
  for (const formats::Value& item : array->items) text += "  " + formats::spell_in_file(item) + ",\n";
  return text + "]";
}

std::string inserted(std::string text, std::size_t at, const std::string& what) {
  return text.insert(at, what);
}

}  // namespace

Found follow(const formats::Value& root, Path path) {
  Found found{&root, 0};
  while (found.steps < path.size()) {
    const formats::Value* next = next_value(*found.value, path[found.steps]);
    if (!next) break;
    found = {next, found.steps + 1};
  }
  return found;
}

std::string spell_path(Path path) {
  std::string text;
  for (const formats::PathStep& step : path)
    text = step.item ? text + "[" + std::to_string(*step.item) + "]" : formats::join_path(text, step.key);
  return text;
}

bool are_same(const formats::Value& a, const formats::Value& b) {
  if (const auto x = number_of(a), y = number_of(b); x && y) return *x == *y;
  if (a.kind() != b.kind()) return false;
  if (const auto* items = a.as<formats::Array>())
    return std::ranges::equal(items->items, b.as<formats::Array>()->items, are_same);
  if (const auto* table = a.as<formats::Table>()) {
    const auto& other = *b.as<formats::Table>();
    return table->members.size() == other.members.size() &&
           std::ranges::all_of(table->members, [&](const formats::Member& m) {
             const formats::Member* same = other.find(m.key);
             return same && are_same(m.value, same->value);
           });
  }
  return a.data == b.data;
}

std::vector<std::string> with_new_key(const std::string& text, const formats::Value& own, Path path,
                                      const formats::Value& value) {
  std::vector<std::string> texts;
  const std::string said = " = " + spell_in_lines(value);
  const Found owner = follow(own, path);
  for (std::size_t steps = owner.steps; steps > 0; --steps) {
    const formats::Value& table = *follow(own, path.first(steps)).value;
    const std::size_t at = byte_at(text, table.place.line, table.place.column);
    const std::string line = spell_path(path.subspan(steps)) + said;
    if (at < text.size() && text[at] == '{') {
      const bool is_empty = table.as<formats::Table>()->members.empty();
      texts.push_back(inserted(text, at + 1, " " + line + (is_empty ? " " : ",")));
    } else if (header_at(text, at) == header_of(path.first(steps))) {
      texts.push_back(inserted(text, end_of_line(text, at), "\n" + line));
    }
  }
  const std::string above = inserted(text, begin_of_tables(text, own), spell_path(path) + said + "\n");
  const std::string end = text.empty() || text.back() == '\n' ? "" : "\n";
  const std::size_t last = path.size() - 1;
  if (last > 0)
    texts.push_back(text + end + "\n[" + spell_path(path.first(last)) + "]\n" + spell_path(path.last(1)) +
                    said + "\n");
  texts.push_back(above);
  return texts;
}

}  // namespace netloft::design
