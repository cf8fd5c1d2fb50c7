// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/table_reader.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <unordered_map>

#include "framework/parameters/nearest.hpp"
#include "io/formats/toml/number_words.hpp"
#include "io/formats/units/degrees.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/units/units.hpp"

namespace netloft::formats {
namespace {

constexpr int kMostErrorsInAnArray = 5;
constexpr std::size_t kMostUnknownKeys = 50;  // limit of unknown keys that are reported in one table

std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t kMostListed = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(words.size(), kMostListed); ++i)
    text += (i > 0 ? ", " : "") + in_quotes(words[i]);
  return words.size() > kMostListed ? text + ", ..." : text;
}

std::string in_parentheses(const std::string& doc) { return doc.empty() ? "" : " (" + doc + ')'; }

std::string spell(const Range& range) {
  return (range.lo_open || std::isinf(range.lo) ? "(" : "[") + format(range.lo) + ", " + format(range.hi) +
         (range.hi_open || std::isinf(range.hi) ? ")" : "]");
}

std::string spell_integers(std::int64_t lo, std::int64_t hi) {
  const bool from = lo > std::numeric_limits<std::int64_t>::min(),
             to = hi < std::numeric_limits<std::int64_t>::max();
  return (from ? '[' + std::to_string(lo) : "(-inf") + ", " + (to ? std::to_string(hi) + ']' : "inf)");
}

std::string spell(const Count& count) {
  const auto are_wanted = [](std::size_t n) {
    return std::to_string(n) + (n == 1 ? " is expected" : " are expected");
  };
  if (count.least == count.most) return are_wanted(count.least);
  if (count.most == Count{}.most) return "at least " + are_wanted(count.least);
  if (count.least == 0) return "at most " + are_wanted(count.most);
  return std::to_string(count.least) + " to " + are_wanted(count.most);
}

/// Describes a value for messages: "the integer 3".
std::string describe(const Value& value) {
  switch (value.kind()) {
    case Kind::table:
      return "a table";
    case Kind::array:
      return "an array of " + std::to_string(value.as<Array>()->items.size());
    case Kind::text:
      return "the text " + in_quotes(*value.as<std::string>());
    case Kind::integer:
      return "the integer " + std::to_string(*value.as<std::int64_t>());
    case Kind::real:
      return "the number " + format(*value.as<double>());
    case Kind::boolean:
      return *value.as<bool>() ? "the boolean true" : "the boolean false";
    case Kind::date:
      return "the date " + value.as<Date>()->text;
  }
  return {};
}

std::string wanted_real(const std::string& unit) {
  return unit == "1" ? std::string("a number") : dimension_name(unit) + " in " + unit;
}

/// Some value within the range, with which the caller continues after an error.
double within(const Range& range) {
  if (range.contains(0)) return 0;
  if (std::isfinite(range.lo) && std::isfinite(range.hi)) return range.lo + (range.hi - range.lo) / 2;
  return std::isfinite(range.lo) ? range.lo + std::max(1.0, std::abs(range.lo))
                                 : range.hi - std::max(1.0, std::abs(range.hi));
}

std::string with_index(const std::string& path, std::size_t i) {
  return path + '[' + std::to_string(i) + ']';
}

/// The place of a value, its name, and the receiver of messages.
struct Spot {
  const Value& value;
  std::string path;
  Diagnostics& diagnostics;

  void refuse(const std::string& message, const std::string& hint = {}) const {
    diagnostics.error(value.place, message, hint);
  }
  void refuse_type(const std::string& wanted, const std::string& doc, const std::string& hint = {}) const {
    refuse(path + " is " + describe(value) + "; " + wanted + " is expected" + in_parentheses(doc), hint);
  }
};

/// A number that is written without a unit.
std::optional<double> plain_number(const Value& value) {
  if (const auto* integer = value.as<std::int64_t>()) return static_cast<double>(*integer);
  if (const auto* real = value.as<double>()) return *real;
  return std::nullopt;
}

std::optional<double> read_number(const Spot& at, const std::string& unit, const std::string& doc) {
  if (const auto plain = plain_number(at.value)) return plain;
  const auto* text = at.value.as<std::string>();
  if (!text) {
    at.refuse_type(wanted_real(unit), doc,
                   unit == "1" ? "" : "write an SI number or a text such as \"1 " + unit + '"');
    return std::nullopt;
  }
  const Quantity quantity = to_si(*text, unit);
  if (quantity.ok()) return quantity.value;
  at.refuse(at.path + ": " + quantity.error + in_parentheses(doc), quantity.hint);
  return std::nullopt;
}

constexpr const char* kDegrees = "an angle in degrees is written \"30 deg\"";

/// The properties of the wanted numbers, in SI units. `written` is the unit that is stated once for all
/// numbers; empty if each number states its unit.
struct Wanted {
  const std::string& unit;
  Range range;
  const std::string& doc;
  std::string written = {};
};

/// A number with six digits, because further digits may be rounding errors of the conversion of units.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return format(std::strtod(text, nullptr));
}

/// Checks that a number is finite and within its range. `written`: the number in another unit, for messages.
std::optional<double> check_range(const Spot& at, double value, const Wanted& wanted,
                                  const std::string& written = {}) {
  if (!std::isfinite(value)) {
    at.refuse(at.path + " = " + format(value) + " is not a finite number" + in_parentheses(wanted.doc));
    return std::nullopt;
  }
  if (wanted.range.contains(value)) return value;
  const std::string unit_behind = wanted.unit == "1" ? "" : ' ' + wanted.unit;
  const std::string number = written.empty() ? format(value) : written + " = " + rounded(value);
  const bool is_plain_angle = wanted.unit == "rad" && plain_number(at.value) && written.empty();
  at.refuse(at.path + " = " + number + unit_behind + " is outside " + spell(wanted.range) + unit_behind +
                in_parentheses(wanted.doc),
            is_plain_angle ? kDegrees : "");
  return std::nullopt;
}

/// Reads a number whose unit is stated separately.
std::optional<double> read_in_unit(const Spot& at, const Wanted& wanted) {
  const auto number = plain_number(at.value);
  if (!number) {
    at.refuse_type("a number in " + wanted.written, wanted.doc,
                   "the unit beside the values applies to all of them");
    return std::nullopt;
  }
  const std::string written = format(*number) + ' ' + wanted.written;
  const Quantity quantity = to_si(written, wanted.unit);
  if (quantity.ok())
    return check_range(at, quantity.value, wanted, wanted.written == wanted.unit ? "" : written);
  at.refuse(at.path + ": " + quantity.error + in_parentheses(wanted.doc), quantity.hint);
  return std::nullopt;
}

std::optional<double> read_real(const Spot& at, const Wanted& wanted) {
  if (are_words_collected()) collect_words(at.path, {wanted.unit, wanted.doc, wanted.range});
  if (!wanted.written.empty()) return read_in_unit(at, wanted);
  const std::optional<double> value = read_number(at, wanted.unit, wanted.doc);
  return value ? check_range(at, *value, wanted) : std::nullopt;
}

/// Warns of an angle that is a whole number without a unit, because it is read in radians and 30, for
/// example, probably means degrees. Returns whether the number is such an angle.
bool question_whole_radians(const Spot& at, const Wanted& wanted) {
  const bool is_plain = wanted.unit == "rad" && wanted.written.empty();
  const auto number = is_plain ? plain_number(at.value) : std::nullopt;
  if (!number || *number == 0 || *number != std::round(*number)) return false;
  at.diagnostics.warning(at.value.place,
                         at.path + " = " + format(*number) + " is in radians, which makes " +
                             format(std::round(10 * kDegreesPerRadian * *number) / 10) + " degrees",
                         kDegrees);
  return true;
}

std::optional<std::int64_t> read_integer(const Spot& at, std::int64_t lo, std::int64_t hi,
                                         const std::string& doc) {
  if (are_words_collected())
    collect_words(at.path, {"1", doc, between(static_cast<double>(lo), static_cast<double>(hi)), true});
  const auto* value = at.value.as<std::int64_t>();
  if (!value) {
    at.refuse_type("an integer", doc);
    return std::nullopt;
  }
  if (*value >= lo && *value <= hi) return *value;
  at.refuse(at.path + " = " + std::to_string(*value) + " is outside " + spell_integers(lo, hi) +
            in_parentheses(doc));
  return std::nullopt;
}

std::optional<std::string> read_text(const Spot& at, const std::string& doc) {
  if (const auto* text = at.value.as<std::string>()) return *text;
  at.refuse_type("a text", doc);
  return std::nullopt;
}

bool check_count(const Spot& at, std::size_t n, const Count& count, const char* what,
                 const std::string& doc) {
  if (n >= count.least && n <= count.most) return true;
  at.refuse(at.path + " has " + std::to_string(n) + ' ' + what + (n == 1 ? "" : "s") + "; " + spell(count) +
            in_parentheses(doc));
  return false;
}

/// Reads each item with `read_item`. Stops after a few errors, so that a wrong unit in a long column does not
/// cause a flood of messages. Returns nothing after an error.
template <class T, class ReadItem>
std::optional<std::vector<T>> read_array(const Spot& at, const Count& count, const char* what,
                                         const std::string& wanted, const std::string& doc,
                                         ReadItem read_item) {
  const Array* array = at.value.as<Array>();
  if (!array) {
    at.refuse_type("an array of " + wanted, doc);
    return std::nullopt;
  }
  int bad = check_count(at, array->items.size(), count, what, doc) ? 0 : 1;
  std::vector<T> result;
  for (std::size_t i = 0; i < array->items.size() && bad < kMostErrorsInAnArray; ++i) {
    std::optional<T> item = read_item(Spot{array->items[i], with_index(at.path, i), at.diagnostics});
    if (item)
      result.push_back(std::move(*item));
    else
      ++bad;
  }
  return bad == 0 ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<std::vector<double>> read_reals(const Spot& at, const Wanted& wanted, const Count& count) {
  const std::string& unit = wanted.written.empty() ? wanted.unit : wanted.written;
  bool is_questioned = false;
  return read_array<double>(at, count, "value", unit == "1" ? "numbers" : "values in " + unit, wanted.doc,
                            [&](const Spot& item) {
                              const auto value = read_real(item, wanted);
                              if (value && !is_questioned)
                                is_questioned = question_whole_radians(item, wanted);
                              return value;
                            });
}

std::size_t stand_in_size(const Count& count) { return std::min<std::size_t>(count.least, 64); }

}  // namespace

struct TableReader::State {
  const Value* value;
  Place place;
  std::string path;
  Diagnostics* diagnostics;
  bool silent = false;                     // true for a table whose absence has been reported
  std::vector<std::string> known = {};     // keys that have been requested, in this order, with repetitions
  std::vector<bool> asked = {};            // for each member of the table: whether its key was requested
  std::vector<const Member*> by_key = {};  // the members of a long table, sorted by their keys
  std::unordered_map<const Value*, std::shared_ptr<State>> opened = {};

  const Table& table() const {
    static const Table kEmpty;
    return value ? *value->as<Table>() : kEmpty;
  }
  /// Finds a member by its key. Most tables are short, but some, such as `[parts]`, have very many members.
  const Member* find(std::string_view key) {
    constexpr std::size_t kFew = 16;
    if (table().members.size() <= kFew) return table().find(key);
    if (by_key.empty()) {
      for (const Member& member : table().members) by_key.push_back(&member);
      std::stable_sort(by_key.begin(), by_key.end(), [](auto* a, auto* b) { return a->key < b->key; });
    }
    const auto at =
        std::lower_bound(by_key.begin(), by_key.end(), key,
                         [](const Member* member, std::string_view k) { return member->key < k; });
    return at != by_key.end() && (*at)->key == key ? *at : nullptr;
  }
  /// Finds a member, and marks its key as known.
  const Member* ask(std::string_view key) {
    if (known.empty()) {
      known.reserve(16);
      asked.resize(table().members.size());
    }
    if (known.empty() || known.back() != key) known.emplace_back(key);
    const Member* member = find(key);
    if (member) asked[static_cast<std::size_t>(member - table().members.data())] = true;
    return member;
  }
  /// The known keys, each once.
  std::vector<std::string> allowed() const {
    std::set<std::string_view> seen;
    std::vector<std::string> keys;
    for (const std::string& key : known)
      if (seen.insert(key).second) keys.push_back(key);
    return keys;
  }
  void report_unknown(const Member& member, const std::vector<std::string>& allowed) const {
    const std::string in = path.empty() ? "" : " in " + path;
    std::string hint;
    if (const auto near = nearest(member.key, allowed))
      hint = "did you mean " + in_quotes(*near) + '?';
    else if (!allowed.empty())
      hint = "allowed here: " + listed(allowed);
    diagnostics->error(member.place, "unknown key " + in_quotes(member.key) + in, hint);
  }
  void finish() const {
    std::vector<const Member*> unknown;
    for (std::size_t i = 0; i < table().members.size() && unknown.size() < kMostUnknownKeys; ++i)
      if (i >= asked.size() || !asked[i]) unknown.push_back(&table().members[i]);
    const auto keys = unknown.empty() ? std::vector<std::string>{} : allowed();
    for (const Member* member : unknown) report_unknown(*member, keys);
    for (const auto& [value_opened, child] : opened) child->finish();
  }
};

TableReader::TableReader(const Value& table, Diagnostics& diagnostics, std::string path)
    : state_(std::make_shared<State>(State{&table, table.place, std::move(path), &diagnostics})) {
  assert(table.as<Table>());
}

const Value* TableReader::ask(std::string_view key) {
  const Member* member = state_->ask(key);
  return member ? &member->value : nullptr;
}

const Value* TableReader::ask(std::string_view key, bool required, const std::string& wanted,
                              const std::string& doc) {
  return ask(
      key, required, [&] { return wanted; }, doc);
}

template <std::invocable Describe>
const Value* TableReader::ask(std::string_view key, bool required, const Describe& wanted,
                              const std::string& doc) {
  const Value* value = ask(key);
  if (!value && required && !state_->silent) {
    const std::string in = state_->path.empty() ? "" : " in " + state_->path;
    state_->diagnostics->error(state_->place,
                               "missing key " + in_quotes(key) + in + ": " + wanted() + in_parentheses(doc));
  }
  return value;
}

double TableReader::real(std::string_view key, const RealSpec& spec) {
  const Value* value = ask(
      key, !spec.fallback, [&] { return wanted_real(spec.unit); }, spec.doc);
  if (!value) return spec.fallback.value_or(within(spec.range));
  const Spot at{*value, path(key), diagnostics()};
  const Wanted wanted{spec.unit, spec.range, spec.doc};
  const std::optional<double> result = read_real(at, wanted);
  if (result) question_whole_radians(at, wanted);
  return result.value_or(spec.fallback.value_or(within(spec.range)));
}

std::int64_t TableReader::integer(std::string_view key, const IntegerSpec& spec) {
  const Value* value = ask(key, !spec.fallback, "an integer", spec.doc);
  std::optional<std::int64_t> result;
  if (value) result = read_integer({*value, path(key), diagnostics()}, spec.lo, spec.hi, spec.doc);
  return result.value_or(spec.fallback.value_or(std::clamp<std::int64_t>(0, spec.lo, spec.hi)));
}

bool TableReader::boolean(std::string_view key, const BooleanSpec& spec) {
  const Value* value = ask(key, !spec.fallback, "true or false", spec.doc);
  if (!value) return spec.fallback.value_or(false);
  if (const bool* result = value->as<bool>()) return *result;
  Spot{*value, path(key), diagnostics()}.refuse_type("true or false", spec.doc);
  return spec.fallback.value_or(false);
}

std::string TableReader::text(std::string_view key, const TextSpec& spec) {
  const Value* value = ask(key, !spec.fallback, "a text", spec.doc);
  std::optional<std::string> result;
  if (value) result = read_text({*value, path(key), diagnostics()}, spec.doc);
  return result.value_or(spec.fallback.value_or(""));
}

std::string TableReader::choice(std::string_view key, const ChoiceSpec& spec) {
  assert(!spec.allowed.empty());
  const Value* value = ask(
      key, !spec.fallback, [&] { return "one of " + listed(spec.allowed); }, spec.doc);
  const std::string stand_in = spec.fallback.value_or(spec.allowed.front());
  if (!value) return stand_in;
  const Spot at{*value, path(key), diagnostics()};
  const std::optional<std::string> word = read_text(at, spec.doc);
  if (!word) return stand_in;
  if (std::find(spec.allowed.begin(), spec.allowed.end(), *word) != spec.allowed.end()) return *word;
  const auto near = nearest(*word, spec.allowed);
  at.refuse(at.path + " = " + in_quotes(*word) + " is not one of " + listed(spec.allowed) +
                in_parentheses(spec.doc),
            near ? "did you mean " + in_quotes(*near) + '?' : "");
  return stand_in;
}

std::vector<double> TableReader::reals(std::string_view key, const RealsSpec& spec) {
  const Value* value = ask(key, !spec.fallback, "an array, each " + wanted_real(spec.unit), spec.doc);
  std::optional<std::vector<double>> result;
  if (const auto in = value ? numbers_in(*value, key, spec.unit, spec.doc) : std::nullopt)
    result = read_reals({*in->values, in->path, diagnostics()},
                        {spec.unit, in->is_known ? spec.range : Range{}, spec.doc, in->unit}, spec.count);
  if (!result) result = spec.fallback;
  return result ? *result : std::vector<double>(stand_in_size(spec.count), within(spec.range));
}

/// Opens { unit = "deg", values = [0, 5, 10] }, where one unit is stated for all numbers. Any other value is
/// returned unchanged, without a unit. After an error in the unit, the numbers are still returned, although
/// they have no meaning: their count prevents further errors about other keys that need as many numbers.
std::optional<TableReader::Numbers> TableReader::numbers_in(const Value& value, std::string_view key,
                                                            const std::string& si_unit,
                                                            const std::string& doc) {
  if (value.kind() != Kind::table) return Numbers{"", &value, path(key)};
  TableReader own = table(key);
  const std::string unit = own.text("unit", {.doc = "unit of the values, such as " + si_unit});
  const Value* values = own.ask("values", true, "an array of numbers in that unit", doc);
  bool is_known = false;
  if (own.kind("unit") == Kind::text && unit.empty()) {
    const std::string alone = " need no table: " + own.path() + " = [0, 1]";
    own.error("unit", "is empty",
              si_unit == "1" ? "numbers without a unit" + alone
                             : "such as unit = \"" + si_unit + "\"; SI numbers" + alone);
  } else if (own.kind("unit") == Kind::text) {
    const Quantity one = to_si("1 " + unit, si_unit);
    is_known = one.ok();
    if (!is_known) own.error("unit", one.error, one.hint);
  }
  return values ? std::optional(Numbers{is_known ? unit : si_unit, values, own.path("values"), is_known})
                : std::nullopt;
}

std::vector<std::vector<double>> TableReader::rows(std::string_view key, const RowsSpec& spec) {
  using Rows = std::vector<std::vector<double>>;
  const Value* value =
      ask(key, !spec.fallback, "an array of arrays, each " + wanted_real(spec.unit), spec.doc);
  std::optional<Rows> result;
  if (const auto in = value ? numbers_in(*value, key, spec.unit, spec.doc) : std::nullopt)
    result = read_array<std::vector<double>>(
        {*in->values, in->path, diagnostics()}, spec.rows, "row", "arrays", spec.doc, [&](const Spot& row) {
          return read_reals(row, {spec.unit, in->is_known ? spec.range : Range{}, spec.doc, in->unit},
                            spec.columns);
        });
  if (!result) result = spec.fallback;
  const std::vector<double> row(stand_in_size(spec.columns), within(spec.range));
  return result ? *result : Rows(stand_in_size(spec.rows), row);
}

std::vector<std::int64_t> TableReader::integers(std::string_view key, const IntegersSpec& spec) {
  const Value* value = ask(key, !spec.fallback, "an array of integers", spec.doc);
  std::optional<std::vector<std::int64_t>> result;
  if (value)
    result = read_array<std::int64_t>(
        {*value, path(key), diagnostics()}, spec.count, "value", "integers", spec.doc,
        [&](const Spot& item) { return read_integer(item, spec.lo, spec.hi, spec.doc); });
  if (!result) result = spec.fallback;
  const std::int64_t stand_in = std::clamp<std::int64_t>(0, spec.lo, spec.hi);
  return result ? *result : std::vector<std::int64_t>(stand_in_size(spec.count), stand_in);
}

std::vector<std::string> TableReader::texts(std::string_view key, const TextsSpec& spec) {
  const Value* value = ask(key, !spec.fallback, "an array of texts", spec.doc);
  std::optional<std::vector<std::string>> result;
  if (value)
    result = read_array<std::string>({*value, path(key), diagnostics()}, spec.count, "value", "texts",
                                     spec.doc, [&](const Spot& item) { return read_text(item, spec.doc); });
  if (!result) result = spec.fallback;
  return result ? *result : std::vector<std::string>(stand_in_size(spec.count));
}

/// Opens a table. Opening a table twice gives the same state, so that keys requested through either reader
/// are known to both.
TableReader TableReader::open(const Value& table, const std::string& path) {
  std::shared_ptr<State>& state = state_->opened[&table];
  if (!state) state = TableReader(table, diagnostics(), path).state_;
  return TableReader(state);
}

TableReader TableReader::table(std::string_view key, Presence presence, const std::string& doc) {
  const Value* value = ask(key, presence == Presence::required, "a table", doc);
  if (value && value->as<Table>()) return open(*value, path(key));
  if (value) Spot{*value, path(key), diagnostics()}.refuse_type("a table", doc);
  const bool reported = value || presence == Presence::required || state_->silent;
  return TableReader(
      std::make_shared<State>(State{nullptr, state_->place, path(key), &diagnostics(), reported}));
}

std::vector<TableReader> TableReader::tables(std::string_view key, Presence presence,
                                             const std::string& doc) {
  const std::string headers = "write each under a header [[" + path(key) + "]]";
  const Value* value = ask(key, presence == Presence::required, "an array of tables", doc);
  if (!value) return {};
  const Spot at{*value, path(key), diagnostics()};
  const Array* array = value->as<Array>();
  if (!array) {
    at.refuse_type("an array of tables", doc, headers);
    return {};
  }
  std::vector<TableReader> readers;
  int bad = 0;
  for (std::size_t i = 0; i < array->items.size() && bad < kMostErrorsInAnArray; ++i) {
    const Spot item{array->items[i], with_index(at.path, i), at.diagnostics};
    if (item.value.as<Table>())
      readers.push_back(open(item.value, item.path));
    else {
      item.refuse_type("a table", doc, headers);
      ++bad;
    }
  }
  return readers;
}

bool TableReader::has(std::string_view key) { return ask(key) != nullptr; }

std::optional<Kind> TableReader::kind(std::string_view key) {
  const Value* value = ask(key);
  return value ? std::optional(value->kind()) : std::nullopt;
}

const Value* TableReader::raw(std::string_view key) { return ask(key); }

std::vector<std::string> TableReader::keys() const {
  std::vector<std::string> result;
  for (const Member& member : state_->table().members) result.push_back(member.key);
  return result;
}

void TableReader::error(std::string_view key, const std::string& message, const std::string& hint) {
  state_->diagnostics->error(place(key), path(key) + ": " + message, hint);
}

Place TableReader::place() const { return state_->place; }

Place TableReader::place(std::string_view key) const {
  const Member* member = state_->find(key);
  return member ? member->value.place : state_->place;
}

std::string TableReader::path() const { return state_->path; }
std::string TableReader::path(std::string_view key) const { return join_path(state_->path, key); }
Diagnostics& TableReader::diagnostics() const { return *state_->diagnostics; }
void TableReader::finish() const { state_->finish(); }

}  // namespace netloft::formats
