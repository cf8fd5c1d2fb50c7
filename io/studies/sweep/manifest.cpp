// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/manifest.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/formats/hdf5/checksum.hpp"
#include "io/formats/text/name_fault.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <utility>

namespace netloft::studies {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 3;
const std::string kSum = "crc32";  // checksum of the first line without this entry, and of all items

std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json column_json(const StudyColumn& column) {
  Json keys = Json::array();
  for (const FollowingKey& key : column.variable.keys)
    keys.push_back({{"key", key.path}, {"factor", key.factor}, {"offset", key.offset}});
  return {{"name", column.variable.name}, {"unit", column.variable.unit},    {"is_number", column.is_number},
          {"in_path", column.is_in_path}, {"is_sampled", column.is_sampled}, {"keys", std::move(keys)}};
}

Json columns_json(const Study& study) {
  Json columns = Json::array();
  for (const StudyColumn& column : study.columns) columns.push_back(column_json(column));
  return columns;
}

Json head_json(const Study& study) {
  Json files = Json::array();
  for (const auto& [path, hash] : study.files) files.push_back({{"path", path}, {"hash", hash}});
  return {{"netloft_study", kFormat},     {"name", study.name},
          {"scene", study.scene},         {"set", study.set},
          {"figures", study.figures},     {"variables", columns_json(study)},
          {"sampling", study.sampling},   {"seed", study.seed},
          {"files", std::move(files)},    {"items", study.items.size()},
          {"points", study.point_count()}};
}

std::string sum_of(const Json& head_without_sum, std::string_view items) {
  return fmt::format("{:08x}", formats::checksum(items, formats::checksum(line(head_without_sum))));
}

/// Returns the text of a value and its number, if it has one. The text of a sampled value follows from its
/// number; the number of a listed value follows from its text.
Json value_json(const VariableValue& value) {
  return value.number ? Json::array({value.text, *value.number}) : Json::array({value.text});
}

Json values_json(const std::vector<VariableValue>& values) {
  Json all = Json::array();
  for (const VariableValue& value : values) all.push_back(value_json(value));
  return all;
}

Json item_json(const Study& study, const StudyItem& item) {
  Json points = Json::array();
  for (const StudyPoint& point : item.points)
    points.push_back({{"set", point.set}, {"values", values_json(point.values)}});
  Json json = {{"id", item.id}};
  if (item.sample > 0) {
    json["sample"] = item.sample;
    json["seed"] = study.seed;
  }
  json["set"] = item.set;
  json["values"] = values_json(item.values);
  json["points"] = std::move(points);
  json["hash"] = item.hash;
  return json;
}

std::vector<VariableValue> read_values(const Json& json) {
  std::vector<VariableValue> values;
  for (const Json& value : json) {
    VariableValue& read = values.emplace_back();
    value.at(0).get_to(read.text);
    if (value.size() > 1) read.number = value.at(1).get<double>();
  }
  return values;
}

StudyColumn read_column(const Json& json) {
  StudyColumn column;
  json.at("name").get_to(column.variable.name);
  if (!is_variable_name(column.variable.name))
    throw StudyError("the name of a variable, " + formats::in_quotes(column.variable.name) +
                     ", must consist of letters, digits, - and _");
  json.at("unit").get_to(column.variable.unit);
  json.at("is_number").get_to(column.is_number);
  json.at("in_path").get_to(column.is_in_path);
  json.at("is_sampled").get_to(column.is_sampled);
  for (const Json& key : json.at("keys"))
    column.variable.keys.push_back(
        {key.at("key").get<std::string>(), key.at("factor").get<double>(), key.at("offset").get<double>()});
  return column;
}

void read_head(const Json& json, Study& study) {
  if (const int format = json.at("netloft_study").get<int>(); format != kFormat)
    throw StudyError("it has format " + std::to_string(format) +
                     ", but this version of Netloft reads format " + std::to_string(kFormat));
  json.at("name").get_to(study.name);
  if (const std::string fault = formats::name_fault(study.name); !fault.empty())
    throw StudyError("the name of the study, " + formats::in_quotes(study.name) + ", " + fault);
  json.at("scene").get_to(study.scene);
  json.at("set").get_to(study.set);
  json.at("figures").get_to(study.figures);
  json.at("sampling").get_to(study.sampling);
  json.at("seed").get_to(study.seed);
  for (const Json& column : json.at("variables")) study.columns.push_back(read_column(column));
  for (const Json& file : json.at("files"))
    study.files.emplace_back(file.at("path").get<std::string>(), file.at("hash").get<std::string>());
}

/// Checks that the changes `set` give the scenes the same values as the tables show. The values belong to the
/// columns from `first` on.
void require_set(const Study& study, std::size_t first, const std::vector<VariableValue>& values,
                 const std::vector<std::string>& set) {
  std::vector<std::string> expected;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const StudyColumn& column = study.columns[first + v];
    const VariableValue& value = values[v];
    const auto wrong = [&](const char* why) {
      return StudyError("the value " + formats::in_quotes(value.text) + " of " + column.variable.name + " " +
                        why);
    };
    if (column.is_number && !value.number) throw wrong("has no number");
    if (value.number && number_in_unit(value.text, column.variable.unit) != value.number)
      throw wrong("is another number");
    for (const FollowingKey& key : column.variable.keys)
      if (!key.follows_as_it_is() && !value.number) throw wrong("has no number that a key can follow");
    for (std::string& word : column.variable.overrides(value)) expected.push_back(std::move(word));
  }
  if (set != expected) throw StudyError("the values of an item are not those that it sets");
}

StudyItem read_item(const Json& json, const Study& study) {
  StudyItem item;
  json.at("id").get_to(item.id);
  json.at("set").get_to(item.set);
  json.at("hash").get_to(item.hash);
  item.sample = json.value("sample", std::size_t{0});
  item.values = read_values(json.at("values"));
  for (const Json& point : json.at("points"))
    item.points.push_back({point.at("set").get<std::vector<std::string>>(), read_values(point.at("values"))});
  for (const StudyPoint& point : item.points)
    if (item.values.size() + point.values.size() != study.columns.size())
      throw StudyError("a point has another number of values than there are variables");
  if (item.values.size() > study.columns.size())
    throw StudyError("an item has more values than there are variables");
  require_set(study, 0, item.values, item.set);
  for (const StudyPoint& point : item.points) require_set(study, item.values.size(), point.values, point.set);
  if (item.id != study.items.size() + 1) throw StudyError("items are not numbered one by one");
  if (item.hash != hash_of(study, item)) throw StudyError("an item does not match its hash");
  return item;
}

std::string text_of_manifest(const fs::path& path) {
  try {
    if (auto text = formats::read_whole(path)) return std::move(*text);
  } catch (const formats::ReadError& e) {
    throw StudyError(e.what());
  }
  throw StudyError("there is no " + path.string() + "; `netloft study plan STUDY.toml` makes it");
}

}  // namespace

std::string manifest_text(const Study& study) {
  std::string items;
  for (const StudyItem& item : study.items) items += line(item_json(study, item));
  Json head = head_json(study);
  head[kSum] = sum_of(head, items);
  return line(head) + items;
}

Study read_manifest(const fs::path& path) {
  const std::string whole = text_of_manifest(path);
  std::istringstream in(whole);
  Study study;
  Json head;
  std::size_t number = 0, items = 0, begin_of_items = 0;
  for (std::string text; std::getline(in, text);) try {
      ++number;
      Json json = Json::parse(text);
      if (number == 1) {
        read_head(json, study);
        json.at("items").get_to(items);
        head = std::move(json);
        begin_of_items = std::min(text.size() + 1, whole.size());
      } else
        study.items.push_back(read_item(json, study));
    } catch (const std::exception& e) {
      throw StudyError(path.string() + ":" + std::to_string(number) + ": the manifest is damaged (" +
                       e.what() + "); plan the study again");
    }
  if (number == 0 || study.items.size() != items)
    throw StudyError(path.string() + ": the manifest is not complete; plan the study again");
  const Json sum = std::exchange(head[kSum], nullptr);
  head.erase(kSum);
  if (sum != sum_of(head, std::string_view(whole).substr(begin_of_items)))
    throw StudyError(path.string() +
                     ": the manifest is damaged (it does not match its checksum); plan the study again");
  return study;
}

fs::path manifest_path(const fs::path& folder) { return folder / "manifest.jsonl"; }

namespace {

fs::path path_of(const fs::path& folder, const StudyItem& item, const char* ending) {
  return folder / "items" / (item.hash.substr(item.hash.find(':') + 1) + ending);
}

}  // namespace

fs::path record_path(const fs::path& folder, const StudyItem& item) { return path_of(folder, item, ".json"); }
fs::path failure_path(const fs::path& folder, const StudyItem& item) {
  return path_of(folder, item, ".failed");
}

}  // namespace netloft::studies
