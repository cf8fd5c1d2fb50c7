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

/// A path as text, such as "hold[0].at[2]".
std::string spell_path(std::span<const formats::PathStep> path);

/// Whether two values are equal, wherever they are written: places and the order of keys do not count, and
/// 3 equals 3.0.
bool are_same(const formats::Value& a, const formats::Value& b);

/// Variants of the text to which the value of a key has been added, the best first: in the table of the path
/// or a table above it, in a new table at the end, or before all tables. Some may not be valid TOML. `own`
/// are the tables of this text, without included files.
std::vector<std::string> with_new_key(const std::string& text, const formats::Value& own,
                                      std::span<const formats::PathStep> path, const formats::Value& value);

}  // namespace netloft::design
