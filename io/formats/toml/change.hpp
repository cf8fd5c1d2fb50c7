// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// From a table to the value of one of its keys, or from an array to one of its items.
struct PathStep {
  std::string key;
  std::optional<std::size_t> item = {};  // of an array, from 0; the key is empty
  bool operator==(const PathStep&) const = default;
};

/// A value that replaces the one under a path of a document. It replaces tables too, and creates missing
/// tables on the path.
struct Change {
  std::string option = "--set";  // the option that the text follows, in messages
  std::string path;              // "hold[0].at[2]"
  std::string text;              // "hold[0].at[2]=-19 m", for messages
  std::vector<PathStep> steps;
  Value value;              // its places are within `text`, in no file
  std::string fault, hint;  // why the text is no change, and the cure; both empty: it is one
  bool operator==(const Change&) const = default;
};

/// Reads "parts.net.cells=[64,64]" as from `--set`. The value is TOML; anything else is taken as a text, so
/// that solver=newton and bar=0.6 m need no quotes. Items of arrays count from 0: "hold[0].at[2]=-19 m".
/// A text that is no change has a fault, which `apply` reports.
Change read_change(const std::string& text, const std::string& option = "--set");

/// Reads several texts of `--set`.
std::vector<Change> read_changes(const std::vector<std::string>& texts);

/// Replaces the value of a key: make_change({"parts", "net", "cells"}, 8). Errors in the value are shown like
/// those of the corresponding `--set`.
Change make_change(std::initializer_list<std::string_view> keys, Value value);

/// Applies a change to a document. A fault of the change, or a path that does not fit the document, is
/// reported.
void apply(Value& root, const Change& change, Diagnostics& diagnostics);

/// Adds the changes of `more` behind those of `all`.
inline void append(std::vector<Change>& all, const std::vector<Change>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace netloft::formats
