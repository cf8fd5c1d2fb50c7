// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/parameter_values.hpp"

#include "framework/parameters/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>

namespace netloft {

namespace {

std::string number_text(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", v);
  return text;
}

std::string with_unit(const std::string& text, const netloft_parameter& p) {
  return std::string_view(p.unit) == "1" ? text : text + " " + p.unit;
}

std::optional<std::int64_t> place_of(const netloft_parameter& p, const std::string& word) {
  for (std::int64_t i = 0; p.choices[i]; ++i)
    if (word == p.choices[i]) return i;
  return {};
}

std::vector<std::string> words_of(const netloft_parameter& p) {
  std::vector<std::string> words;
  for (std::size_t i = 0; p.choices[i]; ++i) words.push_back(p.choices[i]);
  return words;
}

std::optional<std::string> range_fault(const netloft_parameter& p, double v) {
  if (std::isfinite(v) && v >= p.lo && v <= p.hi) return {};
  return std::string(p.name) + " = " + with_unit(number_text(v), p) + " is outside " + allowed(p) + " (" +
         p.doc + ")";
}

const char* kind_name(std::uint32_t kind) {
  switch (kind) {
    case NETLOFT_REAL:
      return "a number";
    case NETLOFT_INTEGER:
      return "a whole number";
    case NETLOFT_BOOLEAN:
      return "true or false";
    case NETLOFT_CHOICE:
      return "a word";
    case NETLOFT_TABLE:
      return "a table of numbers";
    default:
      return "a text";
  }
}

bool fits(std::uint32_t kind, const Value& value) {
  switch (kind) {
    case NETLOFT_REAL:
      return std::holds_alternative<double>(value);
    case NETLOFT_INTEGER:
      return std::holds_alternative<std::int64_t>(value);
    case NETLOFT_BOOLEAN:
      return std::holds_alternative<bool>(value);
    case NETLOFT_TABLE:
      return std::holds_alternative<Samples>(value);
    default:
      return std::holds_alternative<std::string>(value);
  }
}

std::string columns_text(const netloft_parameter& p) {
  std::string text;
  for (std::size_t i = 0; p.columns[i]; ++i)
    text += (i ? ", " : "") + std::string(p.columns[i]) + " [" + p.column_units[i] + "]";
  return text;
}

std::size_t column_count(const netloft_parameter& p) {
  std::size_t n = 0;
  while (p.columns[n]) ++n;
  return n;
}

/// Whether the row `next` of a table may follow `row`: the first column must increase; on a grid, the first
/// column may also stay the same if the second one increases.
bool may_follow(const netloft_parameter& p, const std::vector<double>& row, const std::vector<double>& next) {
  if (next[0] > row[0]) return true;
  return p.arguments == 2 && next[0] == row[0] && next[1] > row[1];
}

std::optional<std::string> samples_fault(const netloft_parameter& p, const Samples& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != column_count(p))
      return std::string(p.name) + ": row " + std::to_string(i + 1) + " has " +
             std::to_string(rows[i].size()) + " numbers; its columns are " + columns_text(p);
    for (const double v : rows[i])
      if (!std::isfinite(v))
        return std::string(p.name) + ": row " + std::to_string(i + 1) +
               " contains a value that is not a finite number";
    if (i && !may_follow(p, rows[i - 1], rows[i]))
      return std::string(p.name) + ": the first column must increase" +
             (p.arguments == 2 ? ", and within it the second" : "") + ", but row " + std::to_string(i + 1) +
             " does not";
  }
  return {};
}

std::string list_choices(const netloft_parameter& p) {
  std::string text;
  for (std::size_t i = 0; p.choices[i]; ++i) text += (i ? ", " : "") + std::string(p.choices[i]);
  return text;
}

/// Returns the error in a text of several words (joined by +): the first word that is not one of the choices.
std::optional<std::string> several_fault(const netloft_parameter& p, const std::string& text) {
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, '+');) {
    if (place_of(p, word)) continue;
    const auto near = nearest(word, words_of(p));
    return std::string(p.name) + " = \"" + text + "\": \"" + word + "\" is not one of " + list_choices(p) +
           (near ? "; did you mean \"" + *near + "\"?" : "");
  }
  return {};
}

std::string unknown(const std::string& name, std::span<const netloft_parameter> table) {
  std::vector<std::string> names;
  for (const auto& p : table) names.push_back(p.name);
  const auto near = nearest(name, names);
  return "unknown parameter \"" + name + "\"" + (near ? "; did you mean \"" + *near + "\"?" : "");
}

}  // namespace

std::string allowed(const netloft_parameter& p) {
  switch (p.kind) {
    case NETLOFT_BOOLEAN:
      return "true or false";
    case NETLOFT_TEXT:
      if (p.choices) return "one or more of " + list_choices(p) + ", with + between two";
      return std::string_view(p.unit) == "1"
                 ? "a text"
                 : "a " + std::string(p.unit) + ", NAME or NAME:key=value;key=value";
    case NETLOFT_TABLE:
      return "rows of " + columns_text(p);
    case NETLOFT_CHOICE:
      return "one of " + list_choices(p);
    default:
      return with_unit("[" + number_text(p.lo) + ", " + number_text(p.hi) + "]", p);
  }
}

std::string default_of(const netloft_parameter& p) {
  if (p.flags & NETLOFT_REQUIRED) return "required";
  if (p.fallback_of) return number_text(p.fallback) + " x " + p.fallback_of;
  switch (p.kind) {
    case NETLOFT_CHOICE:
      return p.choices[static_cast<std::size_t>(p.fallback)];
    case NETLOFT_BOOLEAN:
      return p.fallback != 0 ? "true" : "false";
    case NETLOFT_TEXT:
      return p.fallback_text ? p.fallback_text : "";
    case NETLOFT_TABLE:
      return "empty";
    default:
      return number_text(p.fallback);
  }
}

std::optional<std::string> fault_of(const netloft_parameter& p, const Value& value) {
  if (!fits(p.kind, value)) return std::string(p.name) + " must be " + kind_name(p.kind) + " (" + p.doc + ")";
  if (const double* v = std::get_if<double>(&value)) return range_fault(p, *v);
  if (const auto* v = std::get_if<Samples>(&value)) return samples_fault(p, *v);
  if (const auto* v = std::get_if<std::int64_t>(&value)) return range_fault(p, static_cast<double>(*v));
  if (p.kind == NETLOFT_TEXT && p.choices) return several_fault(p, std::get<std::string>(value));
  if (p.kind == NETLOFT_CHOICE && !place_of(p, std::get<std::string>(value))) {
    const auto near = nearest(std::get<std::string>(value), words_of(p));
    return std::string(p.name) + " = \"" + std::get<std::string>(value) + "\" is not " + allowed(p) +
           (near ? "; did you mean \"" + *near + "\"?" : "");
  }
  return {};
}

std::size_t bytes_of(std::uint32_t kind) {
  switch (kind) {
    case NETLOFT_REAL:
      return sizeof(double);
    case NETLOFT_INTEGER:
    case NETLOFT_CHOICE:
      return sizeof(std::int64_t);
    case NETLOFT_BOOLEAN:
      return 1;
    case NETLOFT_TEXT:
      return sizeof(const char*);
    case NETLOFT_TABLE:
      return sizeof(netloft_table);
    default:
      return 0;
  }
}

std::vector<ByteRange> undeclared(std::span<const netloft_parameter> table, std::size_t bytes) {
  std::vector<bool> declared(bytes, false);
  for (const auto& p : table)
    for (std::size_t i = p.offset; i < std::min(bytes, p.offset + bytes_of(p.kind)); ++i) declared[i] = true;
  std::vector<ByteRange> ranges;
  for (std::size_t i = 0; i < bytes; ++i) {
    if (declared[i]) continue;
    if (ranges.empty() || ranges.back().end != i) ranges.push_back({i, i});
    ranges.back().end = i + 1;
  }
  return ranges;
}

ParameterBlock::ParameterBlock(std::span<const netloft_parameter> table, std::size_t bytes,
                               const Values& values, std::vector<std::string>& faults)
    // std::make_unique sets all bytes to zero, and new[] of bytes is aligned for any fundamental type
    : bytes_(std::make_unique<std::byte[]>(bytes)) {
  for (const auto& p : table) {
    const auto given = values.find(p.name);
    if (given == values.end() && (p.flags & NETLOFT_REQUIRED)) {
      faults.push_back(std::string(p.name) + " is missing: " + p.doc + ", " + allowed(p));
      continue;
    }
    const Value value = given == values.end() ? fallback(table, p) : given->second;
    if (const auto fault = fault_of(p, value))
      faults.push_back(*fault);
    else
      store(p, value);
  }
  for (const auto& one : values)
    if (std::none_of(table.begin(), table.end(), [&](const auto& p) { return one.first == p.name; }))
      faults.push_back(unknown(one.first, table));
}

void ParameterBlock::spoil(const ByteRange& range) {
  constexpr std::byte kSpoilt{0x55};  // 1.2e103 as a double, 6e18 as an integer
  std::fill(bytes_.get() + range.begin, bytes_.get() + range.end, kSpoilt);
}

void ParameterBlock::clear(const ByteRange& range) {
  std::fill(bytes_.get() + range.begin, bytes_.get() + range.end, std::byte{0});
}

double ParameterBlock::number(const netloft_parameter& p) const {
  const char* at = reinterpret_cast<const char*>(bytes_.get()) + p.offset;
  if (p.kind == NETLOFT_REAL) {
    double v;
    std::memcpy(&v, at, sizeof v);
    return v;
  }
  if (p.kind == NETLOFT_BOOLEAN) return *at ? 1 : 0;
  std::int64_t v;
  std::memcpy(&v, at, sizeof v);
  return static_cast<double>(v);
}

std::span<double> ParameterBlock::table(const netloft_parameter& p) const {
  netloft_table stored;
  std::memcpy(&stored, reinterpret_cast<const char*>(bytes_.get()) + p.offset, sizeof stored);
  for (const auto& flat : tables_)
    if (flat->data() == stored.values) return *flat;
  return {};
}

Value ParameterBlock::fallback(std::span<const netloft_parameter> table, const netloft_parameter& p) const {
  switch (p.kind) {
    case NETLOFT_INTEGER:
      return static_cast<std::int64_t>(p.fallback);
    case NETLOFT_BOOLEAN:
      return p.fallback != 0;
    case NETLOFT_CHOICE:
      return std::string(p.choices[static_cast<std::size_t>(p.fallback)]);
    case NETLOFT_TEXT:
      return std::string(p.fallback_text ? p.fallback_text : "");
    case NETLOFT_TABLE:
      return Samples{};
    default:
      break;
  }
  if (!p.fallback_of) return p.fallback;
  for (const auto& other : table)
    if (std::string_view(other.name) == p.fallback_of) return p.fallback * number(other);
  return p.fallback;
}

void ParameterBlock::store(const netloft_parameter& p, const Value& value) {
  char* at = reinterpret_cast<char*>(bytes_.get()) + p.offset;
  const auto put = [at](auto v) { std::memcpy(at, &v, sizeof v); };
  switch (p.kind) {
    case NETLOFT_REAL:
      return put(std::get<double>(value));
    case NETLOFT_INTEGER:
      return put(std::get<std::int64_t>(value));
    case NETLOFT_BOOLEAN:
      return put(std::get<bool>(value));
    case NETLOFT_CHOICE:
      return put(*place_of(p, std::get<std::string>(value)));
    case NETLOFT_TABLE: {
      const Samples& rows = std::get<Samples>(value);
      auto& flat = *tables_.emplace_back(std::make_unique<std::vector<double>>());
      for (const auto& row : rows) flat.insert(flat.end(), row.begin(), row.end());
      return put(netloft_table{flat.data(), static_cast<std::uint32_t>(rows.size()),
                               static_cast<std::uint32_t>(column_count(p))});
    }
    default:
      texts_.push_back(std::make_unique<std::string>(std::get<std::string>(value)));
      put(texts_.back()->c_str());
  }
}

}  // namespace netloft
