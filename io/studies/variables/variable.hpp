// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::studies {

/// One value of a variable.
struct VariableValue {
  std::string text;              // value as for `--set`: "2.5 kn", "pe-braided-4mm", "[64, 64]"
  std::optional<double> number;  // value in the unit of the variable; nullopt for names, switches and arrays
};

/// A key of a scene that a variable sets: key = offset + factor × variable, in the variable's unit.
struct FollowingKey {
  std::string path;  // path as for `--set`: "tow.speed", "points.towing-point.at[2]"
  double factor = 1, offset = 0;
  formats::Place place = {};  // place of the path in the file
  bool follows_as_it_is() const { return factor == 1 && offset == 0; }
};

/// A closed interval for a number, in the unit of its variable.
struct Interval {
  double low = 0, high = 0;
  bool contains(double number) const { return number >= low && number <= high; }
};

/// Whether a text can be the name of a variable: it must consist of letters, digits, - and _. The name
/// becomes a column of tables, a path in result files, and an option such as --at NAME=VALUE.
bool is_variable_name(const std::string& text);

/// The number of a value such as "2.5 kn" in a unit; nullopt if it is not a number of this dimension.
std::optional<double> number_in_unit(const std::string& text, const std::string& unit);

/// An input of a scene, or several inputs that change together, with its listed values or its interval.
struct Variable {
  std::string name;      // name in tables, plots and messages
  formats::Place place;  // place of the variable's table in the file
  std::vector<FollowingKey> keys;
  std::string unit;                   // unit of its numbers as written, such as "kn"; empty if they have none
  std::vector<VariableValue> values;  // listed values in the order of the file; empty if there is an interval
  std::optional<Interval> interval;

  /// Whether numbers between its values are valid: it has an interval, or all its listed values are numbers.
  bool is_number() const;
  VariableValue value_of(double number) const;
  /// The changes "path=value" for every key, in the syntax of `--set`.
  std::vector<std::string> overrides(const VariableValue& value) const;
  /// The texts of overrides(), parsed into changes of a scene.
  std::vector<formats::Change> changes(const VariableValue& value) const {
    return formats::read_changes(overrides(value));
  }
};

}  // namespace netloft::studies
