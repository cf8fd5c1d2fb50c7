// SPDX-License-Identifier: BSD-3-Clause
#include "io/toml/override.hpp"

#include <optional>
#include <vector>

#include "io/toml/key_depth.hpp"
#include "io/toml/parse.hpp"

namespace netloft::io {
namespace {

constexpr const char* kShape = "write it as --set parts.net.cells=[64,64]";

/// The position of the '=' that ends the path; quoted keys may contain another one.
std::size_t find_equals(const std::string& text) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote ? text[i] == quote : text[i] == '"' || text[i] == '\'') quote = quote ? '\0' : text[i];
    if (!quote && text[i] == '=') return i;
  }
  return std::string::npos;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Parses the path as a TOML key with a dummy value.
std::optional<std::vector<std::string>> parse_path(const std::string& path) {
  if (path.find_first_of("\n\r#[]{}=") != std::string::npos && path.find_first_of("\"'") == std::string::npos)
    return std::nullopt;
  Diagnostics unheard;
  std::optional<Value> parsed = parse_toml(path + " = 0", -1, unheard);
  std::vector<std::string> keys;
  for (const Value* at = parsed ? &*parsed : nullptr; at && at->as<Table>();) {
    const std::vector<Member>& members = at->as<Table>()->members;
    if (members.size() != 1) return std::nullopt;
    keys.push_back(members.front().key);
    at = &members.front().value;
  }
  return keys.empty() ? std::nullopt : std::optional(keys);
}

int length_of(const std::string& text) {
  int length = 0;
  for (const char c : text) length += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return length;
}

void move_places(Value& value, int file, int columns) {
  const auto moved = [&](Place& place) {
    place.file = file;
    if (place.line == 1) place.column += columns;
  };
  moved(value.place);
  if (Table* table = value.as<Table>())
    for (Member& member : table->members) {
      moved(member.place);
      move_places(member.value, file, columns);
    }
  if (Array* array = value.as<Array>())
    for (Value& item : array->items) move_places(item, file, columns);
}

/// `place` is that of the text after the '='.
Value parse_value(const std::string& text, const Place& place) {
  const std::string kKey = "v=";
  Diagnostics unheard;
  std::optional<Value> parsed = parse_toml(kKey + text, -1, unheard);
  Table* table = parsed ? parsed->as<Table>() : nullptr;
  if (!table || table->members.size() != 1 || table->members.front().key != "v")
    return {place, trimmed(text)};
  Value value = std::move(table->members.front().value);
  move_places(value, place.file, place.column - 1 - length_of(kKey));
  return value;
}

}  // namespace

void apply_override(Value& root, const std::string& text, Diagnostics& diagnostics) {
  const std::size_t equals = find_equals(text);
  const std::string path = trimmed(text.substr(0, equals));
  const int file = diagnostics.add_source(path.empty() ? "--set" : "--set " + path, text,
                                          Diagnostics::Source::command_line);
  const Place path_place{file, 1, 1, length_of(path)};
  if (equals == std::string::npos) return diagnostics.error(path_place, "there is no '=' in " + text, kShape);
  const auto keys = parse_path(path);
  if (!keys) return diagnostics.error(path_place, "\"" + path + "\" is not a path of dotted keys", kShape);
  if (keys->front() == "include")
    return diagnostics.error(path_place, "include cannot be set: files are read before values are set");

  const std::string rest = text.substr(equals + 1);
  const Place value_place{file, 1, length_of(text.substr(0, equals)) + 2, length_of(rest)};
  Value* at = &root;
  std::string walked;
  for (const std::string& key : *keys) {
    Table* table = at->as<Table>();
    if (!table)
      return diagnostics.error(path_place, walked + " is not a table, so " + path + " cannot be set",
                               at->as<Array>() ? "set the whole array: " + walked + "=[...]" : "");
    walked = join_path(walked, key);
    if (!table->find(key)) table->members.push_back({key, path_place, Value{path_place, Table{}}});
    at = &table->find(key)->value;
  }
  *at = parse_value(rest, value_place);
}

}  // namespace netloft::io
