// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/parameter_reader.hpp"

#include <set>

namespace netloft::io {

namespace {

std::vector<std::string> words_of(const netloft_parameter& p) {
  std::vector<std::string> words;
  for (std::size_t i = 0; p.choices[i]; ++i) words.push_back(p.choices[i]);
  return words;
}

netloft::Value read_value(const netloft_parameter& p, TableReader& from, const std::string& key) {
  switch (p.kind) {
    case NETLOFT_INTEGER:
      return from.integer(
          key, {.doc = p.doc, .lo = static_cast<std::int64_t>(p.lo), .hi = static_cast<std::int64_t>(p.hi)});
    case NETLOFT_BOOLEAN:
      return from.boolean(key, {.doc = p.doc});
    case NETLOFT_CHOICE:
      return from.choice(key, {.allowed = words_of(p), .doc = p.doc});
    case NETLOFT_TEXT:
      return from.text(key, {.doc = p.doc});
    default:
      return from.real(key, {.unit = p.unit, .doc = p.doc, .range = between(p.lo, p.hi)});
  }
}

/// Whether some parameter "group.…" must be given.
bool group_is_required(std::span<const netloft_parameter> table, const std::string& group) {
  for (const auto& p : table)
    if (std::string_view(p.name).starts_with(group + ".") && (p.flags & NETLOFT_REQUIRED)) return true;
  return false;
}

}  // namespace

Values read_parameters(std::span<const netloft_parameter> table, TableReader& from) {
  Values values;
  std::map<std::string, TableReader> groups;
  for (const auto& p : table) {
    const std::string name = p.name;
    const auto dot = name.find('.');
    TableReader* reader = &from;
    std::string key = name;
    if (dot != std::string::npos) {
      const std::string group = name.substr(0, dot);
      key = name.substr(dot + 1);
      if (!groups.contains(group))
        groups.emplace(group, from.table(group, group_is_required(table, group) ? Presence::required
                                                                                : Presence::optional));
      reader = &groups.at(group);
    }
    if (reader->has(key) || (p.flags & NETLOFT_REQUIRED)) values[name] = read_value(p, *reader, key);
  }
  return values;
}

}  // namespace netloft::io
