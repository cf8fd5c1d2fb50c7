// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::results {

/// A line that only one of two texts has.
struct LineChange {
  bool is_new = false;  // true: a line of the second text only; false: of the first only
  int line = 0;         // number of the line in its text, from 1
  std::string text;
};

/// Returns the removed and the new lines, in the order of the texts. A longest common sequence of lines
/// counts as unchanged (Wagner and Fischer, J. ACM 21, 1974). If very many lines differ, all lines from the
/// first difference to the last count as changed.
std::vector<LineChange> find_line_changes(const std::string& before, const std::string& after);

}  // namespace netloft::results
