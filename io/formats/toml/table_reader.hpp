// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/toml/diagnostics.hpp"
#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// The allowed values of a quantity; the ends are included unless they are open.
struct Range {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  bool lo_open = false;
  bool hi_open = false;
  bool contains(double value) const {
    return (lo_open ? value > lo : value >= lo) && (hi_open ? value < hi : value <= hi);
  }
};

inline Range between(double lo, double hi) { return {lo, hi, false, false}; }
inline Range at_least(double lo) { return {.lo = lo}; }
inline Range above(double lo) { return {.lo = lo, .lo_open = true}; }

// The structs below specify a key. `doc` describes it in words; `unit` is the unit of the returned value and
// of the range. A key without a fallback is required.

struct RealSpec {
  std::string unit = "1";
  std::string doc = {};
  Range range = {};
  std::optional<double> fallback = {};
};

struct IntegerSpec {
  std::string doc = {};
  std::int64_t lo = std::numeric_limits<std::int64_t>::min();
  std::int64_t hi = std::numeric_limits<std::int64_t>::max();
  std::optional<std::int64_t> fallback = {};
};

struct BooleanSpec {
  std::string doc = {};
  std::optional<bool> fallback = {};
};

struct TextSpec {
  std::string doc = {};
  std::optional<std::string> fallback = {};
};

struct ChoiceSpec {
  std::vector<std::string> allowed = {};
  std::string doc = {};
  std::optional<std::string> fallback = {};
};

struct Count {
  std::size_t least = 0;
  std::size_t most = std::numeric_limits<std::size_t>::max();
};

inline Count exactly(std::size_t n) { return {n, n}; }

struct RealsSpec {
  std::string unit = "1";
  std::string doc = {};
  Range range = {};  // range of each value
  Count count = {};
  std::optional<std::vector<double>> fallback = {};
};

struct RowsSpec {
  std::string unit = "1";
  std::string doc = {};
  Range range = {};  // range of each number
  Count rows = {};
  Count columns = {};
  std::optional<std::vector<std::vector<double>>> fallback = {};
};

struct IntegersSpec {
  std::string doc = {};
  std::int64_t lo = std::numeric_limits<std::int64_t>::min();  // limits of each integer
  std::int64_t hi = std::numeric_limits<std::int64_t>::max();
  Count count = {};
  std::optional<std::vector<std::int64_t>> fallback = {};
};

struct TextsSpec {
  std::string doc = {};
  Count count = {};
  std::optional<std::vector<std::string>> fallback = {};
};

enum class Presence { required, optional };

/// Reads a table key by key. Nothing throws. After an error, a message with its place is added to the
/// Diagnostics, and a value within the range is returned, so that reading can continue and find all errors.
/// Check `errors()` before you use the values.
///
/// Copies are cheap and refer to the same table; the Value and the Diagnostics must outlive them.
class TableReader {
 public:
  /// `table` is a table, for example Document::root(); `path` is its name in messages.
  TableReader(const Value& table, Diagnostics& diagnostics, std::string path = {});

  double real(std::string_view key, const RealSpec& spec);
  std::int64_t integer(std::string_view key, const IntegerSpec& spec);
  bool boolean(std::string_view key, const BooleanSpec& spec);
  std::string text(std::string_view key, const TextSpec& spec);
  std::string choice(std::string_view key, const ChoiceSpec& spec);
  /// Reads [0, "5 m"], or { unit = "m", values = [0, 5] } with one unit for all values.
  std::vector<double> reals(std::string_view key, const RealsSpec& spec);
  /// Reads [[0, 1], ["2 m", 3]], or { unit = "m", values = [[0, 1], [2, 3]] }.
  std::vector<std::vector<double>> rows(std::string_view key, const RowsSpec& spec);
  std::vector<std::int64_t> integers(std::string_view key, const IntegersSpec& spec);
  std::vector<std::string> texts(std::string_view key, const TextsSpec& spec);

  /// Opens a table. A missing optional table reads as an empty one; a missing required table is reported
  /// once, and reading it causes no further messages.
  TableReader table(std::string_view key, Presence presence = Presence::required,
                    const std::string& doc = {});
  /// Opens an array of tables, such as `[[hold]]`, and returns a reader for each table.
  std::vector<TableReader> tables(std::string_view key, Presence presence = Presence::optional,
                                  const std::string& doc = {});

  /// Whether the table has the key. Like every getter, it marks the key as known.
  bool has(std::string_view key);
  /// The kind of a key's value, for keys that take a name or a table; nullopt if the key is missing.
  std::optional<Kind> kind(std::string_view key);
  /// The value as in the file, for callers that interpret it themselves; nullptr if the key is missing.
  const Value* raw(std::string_view key);
  /// All keys of the table in the file. Does not mark them as known.
  std::vector<std::string> keys() const;

  /// Reports an error that the caller has found in the value of a key, such as "parts.net.twine: no such
  /// entry in the catalogue".
  void error(std::string_view key, const std::string& message, const std::string& hint = {});
  Place place() const;                      // place of the table's header
  Place place(std::string_view key) const;  // place of the value, or of the header if the key is missing
  std::string path() const;
  std::string path(std::string_view key) const;
  Diagnostics& diagnostics() const;

  /// Reports every unknown key of this table and of the tables opened from it. Call it once, at the end.
  void finish() const;

 private:
  /// An array of numbers, and the unit of all of them. The unit is empty if each number states its own.
  struct Numbers {
    std::string unit;
    const Value* values;
    std::string path;
    bool is_known = true;  // false after an error in the unit: ranges must not be checked
  };
  std::optional<Numbers> numbers_in(const Value& value, std::string_view key, const std::string& si_unit,
                                    const std::string& doc);
  struct State;
  explicit TableReader(std::shared_ptr<State> state) : state_(std::move(state)) {}
  const Value* ask(std::string_view key);
  const Value* ask(std::string_view key, bool required, const std::string& wanted, const std::string& doc);
  template <std::invocable Describe>
  const Value* ask(std::string_view key, bool required, const Describe& wanted, const std::string& doc);
  TableReader open(const Value& table, const std::string& path);

  std::shared_ptr<State> state_;
};

}  // namespace netloft::formats
