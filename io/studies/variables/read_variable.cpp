// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/read_variable.hpp"

#include "io/formats/toml/spelled_value.hpp"
#include "io/formats/units/units.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

constexpr const char* kKeyDoc = "key of the scene that is varied, as --set takes it";
constexpr const char* kValuesDoc = "values of the variable";
constexpr const char* kRangeDoc = "least and largest value of the variable";

/// Reads a number with its unit as written; nullopt if the value is not a number.
std::optional<formats::WrittenQuantity> number_in(const formats::Value& value) {
  if (const auto* integer = value.as<std::int64_t>()) return {{static_cast<double>(*integer), "", "", ""}};
  if (const auto* real = value.as<double>()) return {{*real, "", "", ""}};
  const auto* text = value.as<std::string>();
  if (!text) return std::nullopt;
  formats::WrittenQuantity quantity = formats::read_as_written(*text);
  return quantity.ok() ? std::optional(std::move(quantity)) : std::nullopt;
}

/// Reads one variable. The member functions are the steps, in the order of execution.
class VariableReader {
 public:
  VariableReader(const std::string& name, formats::TableReader& table) : table_(table) {
    variable_.name = name;
    variable_.place = table.place();
  }

  Variable read(VariedBy by) {
    const bool has_values = by == VariedBy::values_or_interval && table_.has("values");
    const bool has_range = table_.has("range");
    if (has_values == has_range) refuse_choice(by, has_values);
    if (has_values) read_values();
    if (has_range) read_interval();
    read_keys();
    return std::move(variable_);
  }

 private:
  void refuse_choice(VariedBy by, bool both) {
    const bool may_list = by == VariedBy::values_or_interval;
    if (both) return table_.error("range", "a variable has either values or a range, not both");
    table_.diagnostics().error(
        table_.place(), table_.path() + " has no " + (may_list ? "values and no range" : "range"),
        may_list ? "values = [\"2.5 kn\", \"3 kn\"] lists them, range = [\"2 kn\", \"4 kn\"] gives both ends"
                 : "range = [\"2 kn\", \"4 kn\"] gives both ends");
  }

  void refuse(const formats::Value& at, const std::string& message, const std::string& hint = {}) {
    table_.diagnostics().error(at.place, message, hint);
  }

  void read_values() {
    const formats::Value& raw = *table_.raw("values");
    const formats::Array* array = raw.as<formats::Array>();
    if (!array || array->items.empty())
      return refuse(
          raw, table_.path("values") + (array ? " is empty" : " is not an array") + " (" + kValuesDoc + ")",
          "such as [\"2.5 kn\", \"3 kn\"] or [\"pe-braided-4mm\", \"pe-braided-5mm\"]");
    for (const formats::Value& item : array->items)
      if (const auto number = number_in(item)) take_unit(number->unit);
    for (const formats::Value& item : array->items) variable_.values.push_back(read_value(item));
    refuse_repeats(*array);
  }

  /// Sets the unit of the variable to that of its first number.
  void take_unit(const std::string& unit) {
    if (!has_unit_) variable_.unit = unit;
    has_unit_ = true;
  }

  VariableValue read_value(const formats::Value& item) {
    VariableValue value{formats::spell_value(item), std::nullopt};
    if (number_in(item)) value.number = in_own_unit(item);
    return value;
  }

  std::optional<double> in_own_unit(const formats::Value& item) {
    const auto number = number_in(item);
    if (!number) {
      refuse(item, table_.path() + ": a number is expected, such as " + formats::format(1, variable_.unit));
      return std::nullopt;
    }
    if (number->unit == variable_.unit) return number->number;
    if (number->unit.empty() || variable_.unit.empty()) {
      refuse(item, table_.path() + ": either all numbers have a unit, or none has",
             "a number without a unit means what it means to the key, as a rule SI");
      return std::nullopt;
    }
    const formats::Quantity converted = formats::to_si(*item.as<std::string>(), variable_.unit);
    if (!converted.ok()) refuse(item, table_.path() + ": " + converted.error, converted.hint);
    return converted.ok() ? std::optional(converted.value) : std::nullopt;
  }

  void refuse_repeats(const formats::Array& array) {
    for (std::size_t i = 0; i < array.items.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const VariableValue &a = variable_.values[i], &b = variable_.values[j];
        if (a.text == b.text || (a.number && a.number == b.number))
          return refuse(array.items[i], table_.path("values") + ": " + a.text + " is given twice");
      }
  }

  void read_interval() {
    const formats::Value& raw = *table_.raw("range");
    const formats::Array* array = raw.as<formats::Array>();
    if (!array || array->items.size() != 2)
      return refuse(raw, table_.path("range") + " is not an array of two (" + kRangeDoc + ")",
                    "such as [\"2 kn\", \"4 kn\"]");
    for (const formats::Value& item : array->items)
      if (const auto number = number_in(item)) take_unit(number->unit);
    const auto low = in_own_unit(array->items[0]), high = in_own_unit(array->items[1]);
    if (!low || !high) return;
    if (!(std::isfinite(*low) && std::isfinite(*high) && *low < *high))
      return refuse(raw, table_.path("range") + ": " + formats::format(*low, variable_.unit) +
                             " is not less than " + formats::format(*high, variable_.unit) + " (" +
                             kRangeDoc + ")");
    variable_.interval = Interval{*low, *high};
  }

  void read_keys() {
    const formats::Value* raw = table_.raw("key");
    if (!raw) {
      table_.diagnostics().error(table_.place(), table_.path("key") + " is missing (" + kKeyDoc + ")",
                                 "such as key = \"tow.speed\"");
      return;
    }
    const formats::Array* array = raw->as<formats::Array>();
    if (array && array->items.empty()) refuse(*raw, table_.path("key") + " is empty (" + kKeyDoc + ")");
    if (!array) return read_key(*raw);
    for (const formats::Value& item : array->items) read_key(item);
  }

  void read_key(const formats::Value& item) {
    if (const auto* path = item.as<std::string>()) return add_key({*path, 1, 0}, item);
    if (!item.as<formats::Table>())
      return refuse(item, table_.path("key") + ": a text or a table is expected (" + kKeyDoc + ")",
                    "such as { key = \"points.end.at[2]\", factor = -1, offset = \"2 m\" }");
    formats::TableReader reader(item, table_.diagnostics(), table_.path("key"));
    FollowingKey key;
    key.path = reader.text("key", {.doc = kKeyDoc});
    key.factor = reader.real("factor", {.doc = "what the variable is multiplied by", .fallback = 1.0});
    if (reader.has("offset")) key.offset = in_own_unit(*reader.raw("offset")).value_or(0);
    reader.finish();
    add_key(std::move(key), item);
  }

  void add_key(FollowingKey key, const formats::Value& at) {
    if (key.path.empty()) return refuse(at, table_.path("key") + " is empty (" + kKeyDoc + ")");
    if (!key.follows_as_it_is() && !variable_.is_number())
      refuse(at, table_.path() + ": only numbers have a factor and an offset");
    key.place = at.place;
    variable_.keys.push_back(std::move(key));
  }

  formats::TableReader& table_;
  Variable variable_;
  bool has_unit_ = false;
};

}  // namespace

Variable read_variable(const std::string& name, formats::TableReader table, VariedBy by) {
  return VariableReader(name, table).read(by);
}

std::optional<double> read_number_of(const Variable& variable, formats::TableReader& table,
                                     const std::string& key, const std::string& doc) {
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    table.error(key, message + " (" + doc + ")", hint);
    return std::nullopt;
  };
  const formats::Value* raw = table.raw(key);
  if (!raw)
    return refuse("is missing", "such as " + key + " = \"" + formats::format(1, variable.unit) + "\"");
  const auto number = number_in(*raw);
  if (!number || number->unit.empty() != variable.unit.empty())
    return refuse(
        "a number is expected like those of the range, such as " + formats::format(1, variable.unit), {});
  if (number->unit == variable.unit) return number->number;
  const formats::Quantity converted = formats::to_si(*raw->as<std::string>(), variable.unit);
  if (!converted.ok()) return refuse(converted.error, converted.hint);
  return converted.value;
}

}  // namespace netloft::studies
