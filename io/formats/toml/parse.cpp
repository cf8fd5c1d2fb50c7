// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/parse.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "io/formats/toml/key_depth.hpp"

namespace netloft::formats {
namespace {

class Converter {
 public:
  Converter(int file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

  bool complete() const { return complete_; }

  Value convert(const toml::node& node, int depth = 0) {
    if (depth > kDeepestValue) return refuse_depth(node);
    Value value{place_of(node.source()), {}};
    if (const toml::table* table = node.as_table())
      value.data = convert_table(*table, depth);
    else if (const toml::array* array = node.as_array())
      value.data = convert_array(*array, depth);
    else
      convert_scalar(node, value);
    return value;
  }

 private:
  Place place_of(const toml::source_region& source) const {
    const bool one_line = source.end.line == source.begin.line && source.end.column > source.begin.column;
    return {file_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column),
            one_line ? static_cast<int>(source.end.column - source.begin.column) : 1};
  }

  /// Converts a table. toml++ sorts keys by name; this function restores the order of the file.
  Table convert_table(const toml::table& table, int depth) {
    Table result;
    result.members.reserve(table.size());
    for (auto&& [key, node] : table)
      result.members.push_back({std::string(key.str()), place_of(key.source()), convert(node, depth + 1)});
    std::stable_sort(result.members.begin(), result.members.end(), [](const Member& a, const Member& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    return result;
  }

  Array convert_array(const toml::array& array, int depth) {
    Array result;
    result.items.reserve(array.size());
    for (const toml::node& item : array) result.items.push_back(convert(item, depth + 1));
    const toml::table* first = array.empty() ? nullptr : array.front().as_table();
    result.from_headers = first && !first->is_inline();
    return result;
  }

  static void convert_scalar(const toml::node& node, Value& value) {
    if (const auto* text = node.as_string())
      value.data = text->get();
    else if (const auto* integer = node.as_integer())
      value.data = integer->get();
    else if (const auto* real = node.as_floating_point())
      value.data = real->get();
    else if (const auto* boolean = node.as_boolean())
      value.data = boolean->get();
    else
      value.data = Date{spell_date(node)};
  }

  static std::string spell_date(const toml::node& node) {
    std::ostringstream out;
    if (const auto* date = node.as_date()) out << date->get();
    if (const auto* time = node.as_time()) out << time->get();
    if (const auto* date_time = node.as_date_time()) out << date_time->get();
    return out.str();
  }

  Value refuse_depth(const toml::node& node) {
    if (complete_)
      diagnostics_.error(place_of(node.source()),
                         "nested deeper than " + std::to_string(kDeepestValue) + " levels");
    complete_ = false;
    return {place_of(node.source()), {}};
  }

  int file_;
  Diagnostics& diagnostics_;
  bool complete_ = true;
};

std::string line_of(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(lines, line);
  return line;
}

/// A hint for the common mistake `bar = 0.6 m`. The parser fails at the unit or after it, so the quantity
/// begins with the last value before `column`.
std::string hint_for(const std::string& line, int column) {
  const std::size_t equals = line.rfind('=', static_cast<std::size_t>(std::max(column, 1)) - 1);
  if (equals == std::string::npos) return {};
  const std::size_t value = line.find_first_not_of(" \t", equals + 1);
  if (value == std::string::npos ||
      std::string_view("+-.0123456789").find(line[value]) == std::string_view::npos)
    return {};
  const bool has_unit = std::any_of(line.begin() + static_cast<std::ptrdiff_t>(value), line.end(),
                                    [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
  return has_unit ? "a number with a unit is written in quotes: \"10 mm\"" : "";
}

std::string reworded(std::string_view description) {
  constexpr std::string_view kPrefix = "Error while parsing ";
  if (!description.starts_with(kPrefix)) return std::string(description);
  return "cannot read the " + std::string(description.substr(kPrefix.size()));
}

}  // namespace

std::string spell_key(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? std::string(key) : '"' + std::string(key) + '"';
}

std::string join_path(std::string_view path, std::string_view key) {
  return path.empty() ? spell_key(key) : std::string(path) + '.' + spell_key(key);
}

std::optional<Value> parse_toml(const std::string& text, int file, Diagnostics& diagnostics) {
  if (const auto spot = find_deep_key(text)) {
    diagnostics.error({file, spot->line, spot->column, 1},
                      "a dotted key has more than " + std::to_string(kMostKeyParts) + " parts");
    return std::nullopt;
  }
  try {
    const toml::table parsed = toml::parse(std::string_view(text), std::string_view("input"));
    Converter converter(file, diagnostics);
    Value value = converter.convert(parsed);
    if (!converter.complete()) return std::nullopt;
    return value;
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    const Place place{file, static_cast<int>(at.line), static_cast<int>(at.column), 1};
    diagnostics.error(place, reworded(error.description()),
                      hint_for(line_of(text, place.line), place.column));
  }
  return std::nullopt;
}

}  // namespace netloft::formats
