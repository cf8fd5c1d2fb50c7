// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/change.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "io/formats/toml/key_depth.hpp"
#include "io/formats/toml/parse.hpp"
#include "io/formats/toml/spelled_value.hpp"

namespace netloft::formats {
namespace {

std::string shape(const std::string& option) {
  return "write it as " + option + (option == "--set" ? " parts.net.cells=[64,64]" : " NAME=VALUE");
}

/// The position of the '=' that ends the path; quoted keys may contain another '='.
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

/// Parses dotted keys as a TOML key with a dummy value.
std::optional<std::vector<std::string>> parse_keys(const std::string& path) {
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

/// Removes "[2]" from the front of `rest` and returns 2; nullopt if `rest` does not begin with an index.
std::optional<std::size_t> take_item(std::string_view& rest) {
  std::size_t item = 0;
  const char* end = rest.data() + rest.size();
  const auto [digits_end, code] = std::from_chars(rest.data() + 1, end, item);
  if (code != std::errc() || digits_end == end || *digits_end != ']') return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(digits_end + 1 - rest.data()));
  return item;
}

/// Removes the part before the first '[' outside quotes from the front of `rest`, and returns it.
std::string_view take_keys(std::string_view& rest) {
  char quote = 0;
  std::size_t i = 0;
  for (; i < rest.size() && (quote || rest[i] != '['); ++i)
    if (quote ? rest[i] == quote : rest[i] == '"' || rest[i] == '\'') quote = quote ? '\0' : rest[i];
  const std::string_view keys = rest.substr(0, i);
  rest.remove_prefix(i);
  return keys;
}

/// Splits a path such as "hold[0].at[2]" into steps; nullopt if the path cannot be read.
std::optional<std::vector<PathStep>> parse_path(std::string_view rest) {
  std::vector<PathStep> steps;
  while (!rest.empty()) {
    if (!steps.empty() && rest.front() == '.') rest.remove_prefix(1);
    const auto keys = parse_keys(std::string(take_keys(rest)));
    if (!keys) return std::nullopt;
    for (const std::string& key : *keys) steps.push_back({key});
    while (!rest.empty() && rest.front() == '[') {
      const auto item = take_item(rest);
      if (!item) return std::nullopt;
      steps.push_back({"", item});
    }
    if (!rest.empty() && (rest.front() != '.' || rest.size() == 1)) return std::nullopt;
  }
  return steps.empty() ? std::nullopt : std::optional(steps);
}

int length_of(const std::string& text) {
  int length = 0;
  for (const char c : text) length += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return length;
}

/// Calls visit(place) for the places of a value and of all values in it.
template <class Visit>
void for_places(Value& value, const Visit& visit) {
  visit(value.place);
  if (Table* table = value.as<Table>())
    for (Member& member : table->members) {
      visit(member.place);
      for_places(member.value, visit);
    }
  if (Array* array = value.as<Array>())
    for (Value& item : array->items) for_places(item, visit);
}

/// Reads a value as TOML or, if it is not valid TOML, as a text. `place` is the place of the text after the
/// '='.
Value parse_value(const std::string& text, const Place& place) {
  const std::string kKey = "v=";
  Diagnostics unheard;
  std::optional<Value> parsed = parse_toml(kKey + text, -1, unheard);
  Table* table = parsed ? parsed->as<Table>() : nullptr;
  if (!table || table->members.size() != 1 || table->members.front().key != "v")
    return {place, trimmed(text)};
  Value value = std::move(table->members.front().value);
  for_places(value, [columns = place.column - 1 - length_of(kKey)](Place& at) {
    if (at.line == 1) at.column += columns;
  });
  return value;
}

/// Walks from the root of a document along the steps of a path.
class Walk {
 public:
  Walk(Value& root, std::string path, const Place& place, const NamingKeys& naming, Diagnostics& diagnostics)
      : at_(&root), path_(std::move(path)), place_(place), naming_(naming), diagnostics_(diagnostics) {}

  /// The value at the end of the steps. nullptr if a step is impossible, which is reported.
  Value* end() const { return at_; }

  void go(const PathStep& step) {
    if (!at_) return;
    step.item ? go_to_item(*step.item) : go_to_key(step.key);
  }

 private:
  void stop(const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place_, message, hint);
    at_ = nullptr;
  }

  /// If the value is a text that abbreviates a table, replaces the text by the table.
  void write_out() {
    const bool names_a_table = at_->as<std::string>() && std::find(naming_.keys.begin(), naming_.keys.end(),
                                                                   key_) != naming_.keys.end();
    if (!names_a_table) return;
    Value name = *at_;
    at_->data = Table{{{naming_.name, name.place, name}}};
  }

  void go_to_key(const std::string& key) {
    write_out();
    Table* table = at_->as<Table>();
    if (!table)
      return stop(walked_ + " is not a table, so " + path_ + " cannot be set",
                  at_->as<Array>() ? "set the whole array: " + walked_ +
                                         "=[...], or one of its items: " + walked_ + "[0]=..."
                                   : "");
    walked_ = join_path(walked_, key);
    key_ = key;
    if (!table->find(key)) table->members.push_back({key, place_, Value{place_, Table{}}});
    at_ = &table->find(key)->value;
  }

  void go_to_item(std::size_t item) {
    Array* array = at_->as<Array>();
    const std::string itself = walked_ + "[" + std::to_string(item) + "]";
    if (!array)
      return stop(walked_ + " is not an array in the scene, so " + itself + " cannot be set",
                  "set it as a whole: " + walked_ + "=[...]");
    if (item >= array->items.size())
      return stop(
          walked_ + " has " + std::to_string(array->items.size()) + " items, so there is no " + itself,
          "items count from 0");
    walked_ = itself;
    key_.clear();
    at_ = &array->items[item];
  }

  Value* at_;
  std::string path_, walked_, key_;  // key_: the last key of the path so far
  Place place_;
  const NamingKeys& naming_;
  Diagnostics& diagnostics_;
};

}  // namespace

namespace {

Change without_value(Change change, std::string fault, std::string hint = {}) {
  change.fault = std::move(fault);
  change.hint = std::move(hint);
  return change;
}

}  // namespace

Change read_change(const std::string& text, const std::string& option) {
  const std::size_t equals = find_equals(text);
  Change change{option, trimmed(text.substr(0, equals)), text, {}, {}, {}, {}};
  if (equals == std::string::npos)
    return without_value(std::move(change), "there is no '=' in " + text, shape(option));
  auto steps = parse_path(change.path);
  if (!steps)
    return without_value(std::move(change), "\"" + change.path + "\" is not a path of dotted keys",
                         shape(option));
  for (const char* key : {"include", "without"})
    if (steps->front().key == key)
      return without_value(std::move(change),
                           std::string(key) + " cannot be set: files are read before values are set");
  change.steps = std::move(*steps);
  const std::string rest = text.substr(equals + 1);
  change.value = parse_value(rest, {-1, 1, length_of(text.substr(0, equals)) + 2, length_of(rest)});
  return change;
}

std::vector<Change> read_changes(const std::vector<std::string>& texts) {
  std::vector<Change> changes;
  for (const std::string& text : texts) changes.push_back(read_change(text));
  return changes;
}

Change make_change(std::initializer_list<std::string_view> keys, Value value) {
  Change change;
  for (const std::string_view key : keys) {
    change.path = join_path(change.path, key);
    change.steps.push_back({std::string(key)});
  }
  const std::string spelled = spell_value(value);
  change.text = change.path + "=" + spelled;
  for_places(value, [at = Place{-1, 1, length_of(change.path) + 2, length_of(spelled)}](Place& place) {
    place = at;
  });
  change.value = std::move(value);
  return change;
}

bool undoes(const Change& change, const Change& earlier) {
  if (change.steps.empty() || change.steps.size() > earlier.steps.size()) return false;
  if (!std::equal(change.steps.begin(), change.steps.end(), earlier.steps.begin())) return false;
  return change.steps.size() < earlier.steps.size() ||
         spell_value(change.value) != spell_value(earlier.value);
}

void apply(Value& root, const Change& change, Diagnostics& diagnostics, const NamingKeys& naming) {
  const int file =
      diagnostics.add_source(change.path.empty() ? change.option : change.option + " " + change.path,
                             change.text, Diagnostics::Source::command_line);
  const Place path_place{file, 1, 1, length_of(change.path)};
  if (!change.fault.empty()) return diagnostics.error(path_place, change.fault, change.hint);
  Walk walk(root, change.path, path_place, naming, diagnostics);
  for (const PathStep& step : change.steps) walk.go(step);
  if (!walk.end()) return;
  *walk.end() = change.value;
  for_places(*walk.end(), [file](Place& place) { place.file = file; });
}

}  // namespace netloft::formats
