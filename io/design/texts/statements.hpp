// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::design {

/// A header or a key with its value in a TOML text.
struct Statement {
  std::size_t begin = 0,
              end = 0;    // bytes of whole lines: from its first one up to the one after its last one
  std::size_t value = 0;  // first byte of the value; of a header, `end`
  std::vector<formats::PathStep>
      path;  // of the table or value; [[hold]] counts its items in this text from 0
};

/// The statements of a valid text, in their order.
std::vector<Statement> statements_of(const std::string& text);

/// Whether a path leads to a table or value, or to something in it.
bool is_within(std::span<const formats::PathStep> path, std::span<const formats::PathStep> outer);

/// The text without the statements of a path and of what is in it, and without the comments directly above
/// them.
std::string without_statements(const std::string& text, std::span<const formats::PathStep> path);

}  // namespace netloft::design
