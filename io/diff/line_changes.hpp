// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::io {

/// A line that only one of two texts has.
struct LineChange {
  bool is_new = false;  // in the second text; else it is gone from the first
  int line = 0;         // of the text that has it, from 1
  std::string text;
};

/// Lines that are gone and lines that are new, in the order of the texts: what is left when a longest common
/// sequence of lines (Wagner and Fischer, J. ACM 21, 1974) is taken out of both. Texts that differ in very
/// many lines are told apart as a whole from the first to the last that differs.
std::vector<LineChange> find_line_changes(const std::string& before, const std::string& after);

}  // namespace netloft::io
