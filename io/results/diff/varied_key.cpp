// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/varied_key.hpp"

#include "io/results/diff/key_changes.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>

namespace netloft::results {

namespace {

std::string unquoted(const std::string& text) {
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2)
                                                                      : text;
}

/// The number at the beginning of a text such as "2.5 kn", and the unit after the number.
struct Quantity {
  double number = 0;
  std::string unit = {};
};

std::optional<Quantity> read_quantity(const std::string& text) {
  Quantity quantity;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), quantity.number);
  if (fault != std::errc()) return std::nullopt;
  const auto unit = text.find_first_not_of(' ', static_cast<std::size_t>(end - text.data()));
  if (unit != std::string::npos) quantity.unit = text.substr(unit);
  return quantity;
}

/// The changes of every result against the first one; empty if a scene is not known.
std::vector<std::vector<KeyChange>> changes_of(const std::vector<const Result*>& results) {
  std::vector<std::vector<KeyChange>> all;
  std::set<std::string> files;
  for (std::size_t i = 1; i < results.size(); ++i) {
    auto changes = find_key_changes(results[0]->origins, results[i]->origins, files);
    if (!changes) return {};
    all.push_back(std::move(*changes));
  }
  return all;
}

/// The key of `change` with its values in all results; nullopt unless these values are different numbers.
std::optional<VariedKey> varied_by(const KeyChange& change,
                                   const std::vector<std::vector<KeyChange>>& changes) {
  VariedKey varied{change.path, {unquoted(change.before)}, {}};
  for (const auto& of_one : changes) {
    const auto same = std::ranges::find(of_one, change.path, &KeyChange::path);
    varied.values.push_back(unquoted(same == of_one.end() ? change.before : same->after));
  }
  std::set<double> different;
  std::set<std::string> units;
  for (const auto& value : varied.values) {
    const auto quantity = read_quantity(value);
    if (!quantity) return std::nullopt;
    varied.numbers.push_back(quantity->number);
    different.insert(quantity->number);
    units.insert(quantity->unit);
  }
  if (different.size() < varied.values.size()) return std::nullopt;
  if (units.size() == 1) varied.unit = *units.begin();
  return varied;
}

}  // namespace

VariedKey find_varied_key(const std::vector<const Result*>& results) {
  const auto changes = changes_of(results);
  if (changes.empty()) return {};
  for (const auto& change : changes.front())
    if (const auto varied = varied_by(change, changes)) return *varied;
  return {};
}

std::string title_of(const std::vector<const Result*>& results) {
  const auto joined = [](const std::vector<std::string>& texts) {
    std::string line;
    for (const auto& text : texts) line += (line.empty() ? "" : ", ") + text;
    return line;
  };
  std::vector<std::string> titles, files;
  for (const Result* result : results) {
    titles.push_back(result->title);
    files.push_back(std::filesystem::path(result->path).filename().string());
  }
  const bool is_same = std::ranges::adjacent_find(titles, std::not_equal_to{}) == titles.end();
  if (results.size() < 2 || !is_same) return joined(titles);
  const VariedKey varied = find_varied_key(results);
  return titles.front() + ": " +
         (varied.path.empty() ? joined(files) : varied.path + " " + joined(varied.values));
}

}  // namespace netloft::results
