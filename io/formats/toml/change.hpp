// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// A step from a table to the value of one of its keys, or from an array to one of its items.
struct PathStep {
  std::string key;
  std::optional<std::size_t> item = {};  // index of an item, from 0; the key is then empty
  bool operator==(const PathStep&) const = default;
};

/// A new value for a path of a document. It may replace a table; missing tables on the path are created.
struct Change {
  std::string option = "--set";  // option before the text, for messages
  std::string path;              // such as "hold[0].at[2]"
  std::string text;              // "hold[0].at[2]=-19 m", for messages
  std::vector<PathStep> steps;
  Value value;              // new value; its places are positions in `text`, without a file
  std::string fault, hint;  // why the text is not valid, and the cure; both are empty if it is valid
  bool operator==(const Change&) const = default;
};

/// Reads "parts.net.cells=[64,64]", the argument of `--set`. A value that is not valid TOML is a text, so
/// that solver=newton and bar=0.6 m need no quotes. Items of arrays count from 0: "hold[0].at[2]=-19 m". If
/// the text is not valid, the change has a `fault`, which `apply` reports.
Change read_change(const std::string& text, const std::string& option = "--set");

std::vector<Change> read_changes(const std::vector<std::string>& texts);

/// Makes a change that replaces the value of a key: make_change({"parts", "net", "cells"}, 8). Errors in the
/// value are reported as if they were in the corresponding `--set`.
Change make_change(std::initializer_list<std::string_view> keys, Value value);

/// Whether `change` makes the `earlier` change ineffective, because it replaces the same value or a table
/// that contains it.
bool undoes(const Change& change, const Change& earlier);

/// Keys whose value is a table, or a text as an abbreviation of a table with the single key `name`. For
/// example, if `twine` is such a key and `name` is "part", twine = "pe-4mm" means twine = { part = "pe-4mm"
/// }.
struct NamingKeys {
  std::vector<std::string> keys = {};
  std::string name = {};  // key in the table whose value is the text
};

/// Applies a change to a document. Reports a fault of the change, and a path that does not fit the document.
/// If the path leads into a text that abbreviates a table according to `naming`, the text is first replaced
/// by the table.
void apply(Value& root, const Change& change, Diagnostics& diagnostics, const NamingKeys& naming = {});

inline void append(std::vector<Change>& all, const std::vector<Change>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace netloft::formats
