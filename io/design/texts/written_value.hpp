// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::design {

/// How far a path leads through the tables of a document.
struct Found {
  const formats::Value* value;  // the last value on the path
  std::size_t steps;            // number of steps that lead to it
};
Found follow(const formats::Value& root, std::span<const formats::PathStep> path);

/// The path as it is written: "hold[0].at[2]".
std::string spell_path(std::span<const formats::PathStep> path);

/// Whether two values are equal, wherever they are written: places and the order of keys do not count, and
/// 3 equals 3.0.
bool are_same(const formats::Value& a, const formats::Value& b);

/// Texts that state the value of a key in addition, the best first: in the table of the path or one above it
/// that the text has, in a table of its own at the end, above all tables. Not all of them need be valid TOML.
/// `own` are the tables of the text alone.
std::vector<std::string> with_new_key(const std::string& text, const formats::Value& own,
                                      std::span<const formats::PathStep> path, const formats::Value& value);

}  // namespace netloft::design
