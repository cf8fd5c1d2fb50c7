// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/parameter_reader.hpp"

#include "io/formats/units/units.hpp"

#include <algorithm>
#include <set>

namespace netloft::scenes {

namespace {

std::vector<std::string> words_of(const netloft_parameter& p) {
  std::vector<std::string> words;
  for (std::size_t i = 0; p.choices[i]; ++i) words.push_back(p.choices[i]);
  return words;
}

/// Reads a table of columns of equal length, and returns it row by row.
Samples read_rows(const netloft_parameter& p, formats::TableReader& table) {
  Samples rows;
  for (std::size_t k = 0; p.columns[k]; ++k) {
    const formats::Count count = k ? formats::exactly(rows.size()) : formats::Count{.least = 1};
    const auto column = table.reals(p.columns[k], {.unit = p.column_units[k], .doc = p.doc, .count = count});
    if (k == 0) rows.resize(column.size());
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(i < column.size() ? column[i] : 0.0);
  }
  return rows;
}

/// Reads a table whose first column must ascend; returns only its first row after an error.
Samples read_samples(const netloft_parameter& p, formats::TableReader table) {
  Samples rows = read_rows(p, table);
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (!(rows[i][0] > rows[i - 1][0])) {
      table.error(p.columns[0], "does not ascend: each number must be greater than the one before");
      return {rows[0]};
    }
  return rows;
}

std::string pair_text(const netloft_parameter& p, double first, double second) {
  return std::string(p.columns[0]) + " = " + formats::format(first, p.column_units[0]) + ", " + p.columns[1] +
         " = " + formats::format(second, p.column_units[1]);
}

/// Reads a table with one row for every pair of values of its two arguments. The rows may be in any order;
/// they are sorted.
Samples read_grid(const netloft_parameter& p, formats::TableReader table) {
  const int errors_before = table.diagnostics().errors();
  Samples rows = read_rows(p, table);
  if (table.diagnostics().errors() > errors_before) return rows;
  std::sort(rows.begin(), rows.end(),
            [](const auto& a, const auto& b) { return std::pair(a[0], a[1]) < std::pair(b[0], b[1]); });
  std::set<double> first, second;
  for (const auto& row : rows) {
    first.insert(row[0]);
    second.insert(row[1]);
  }
  auto at = rows.begin();
  for (const double x : first)
    for (const double y : second) {
      const bool is_there = at != rows.end() && (*at)[0] == x && (*at)[1] == y;
      const bool is_twice = is_there && at + 1 != rows.end() && (*(at + 1))[0] == x && (*(at + 1))[1] == y;
      if (!is_there || is_twice) {
        table.error(p.columns[0],
                    (is_twice ? "there are two rows for " : "there is no row for ") + pair_text(p, x, y),
                    "the rows must be a grid: one for every pair of the values of " +
                        std::string(p.columns[0]) + " and " + p.columns[1]);
        return {rows[0]};
      }
      ++at;
    }
  return rows;
}

/// Reads a text, and reports an error if the parameter does not allow it.
std::string read_text(const netloft_parameter& p, formats::TableReader& from, const std::string& key) {
  std::string text = from.text(key, {.doc = p.doc});
  const bool is_text = from.kind(key) == formats::Kind::text;
  if (const auto fault = fault_of(p, text); is_text && fault) from.error(key, *fault);
  return text;
}

netloft::Value read_value(const netloft_parameter& p, formats::TableReader& from, const std::string& key) {
  switch (p.kind) {
    case NETLOFT_INTEGER:
      return from.integer(
          key, {.doc = p.doc, .lo = static_cast<std::int64_t>(p.lo), .hi = static_cast<std::int64_t>(p.hi)});
    case NETLOFT_BOOLEAN:
      return from.boolean(key, {.doc = p.doc});
    case NETLOFT_CHOICE:
      return from.choice(key, {.allowed = words_of(p), .doc = p.doc});
    case NETLOFT_TEXT:
      return read_text(p, from, key);
    case NETLOFT_TABLE:
      return p.arguments == 2 ? read_grid(p, from.table(key)) : read_samples(p, from.table(key));
    default:
      return from.real(key, {.unit = p.unit, .doc = p.doc, .range = formats::between(p.lo, p.hi)});
  }
}

/// Whether a group of parameters (those named "group.…") has a required parameter.
bool group_is_required(std::span<const netloft_parameter> table, const std::string& group) {
  for (const auto& p : table)
    if (std::string_view(p.name).starts_with(group + ".") && (p.flags & NETLOFT_REQUIRED)) return true;
  return false;
}

/// Opens the table with the keys of a group. An empty table for an optional group is an error.
formats::TableReader open_group(std::span<const netloft_parameter> table, formats::TableReader& from,
                                const std::string& group) {
  const bool is_required = group_is_required(table, group);
  formats::TableReader own =
      from.table(group, is_required ? formats::Presence::required : formats::Presence::optional);
  if (!is_required && from.kind(group) == formats::Kind::table && own.keys().empty())
    from.error(group, "is an empty table, which says nothing", "leave it out, or see `netloft describe`");
  return own;
}

}  // namespace

Values read_parameters(std::span<const netloft_parameter> table, formats::TableReader& from) {
  Values values;
  std::map<std::string, formats::TableReader> groups;
  for (const auto& p : table) {
    const std::string_view name = p.name;
    const auto dot = name.find('.');
    formats::TableReader* reader = &from;
    const std::string key(name.substr(dot + 1));  // the whole name if it has no dot
    if (dot != std::string::npos) {
      const std::string group(name.substr(0, dot));
      auto own = groups.find(group);
      if (own == groups.end()) own = groups.emplace(group, open_group(table, from, group)).first;
      reader = &own->second;
    }
    if (reader->has(key) || (p.flags & NETLOFT_REQUIRED)) values[p.name] = read_value(p, *reader, key);
  }
  return values;
}

}  // namespace netloft::scenes
