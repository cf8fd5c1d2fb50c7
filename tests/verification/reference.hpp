// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/folders.hpp"

#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft::test {

/// Answers of an independent program at one refinement: the numbers of a `level` line and the `node` lines
/// below it. Their meaning is described at the top of the file.
struct Level {
  int n = 0;
  std::vector<double> values;
  std::vector<std::vector<double>> nodes;
};

// Tolerances for results on the same elements.
inline constexpr double kNodeTolerance = 1e-8;      // [m]
inline constexpr double kRelativeTolerance = 1e-9;  // energies and reactions

// The panel under its own weight in 40 x 40 lumped meshes, by the independent program.
inline constexpr double kPanelLowestZ = -42.67468699107;     // [m]
inline constexpr double kPanelEnergy = -58151.570400698;     // relative to z = 0 [J]
inline constexpr double kPanelTopReaction = 2884.660640009;  // [N]

inline std::vector<double> numbers_of(std::istringstream& line) {
  std::vector<double> numbers;
  for (double number; line >> number;) numbers.push_back(number);
  return numbers;
}

inline std::vector<Level> read_levels(const std::string& name) {
  std::ifstream file(test::source_folder() + "/tests/verification/data/" + name);
  if (!file) throw std::runtime_error("no " + name + " among the data");
  std::vector<Level> levels;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string word;
    line >> word;
    if (word == "level") {
      Level level;
      line >> level.n;
      level.values = numbers_of(line);
      levels.push_back(std::move(level));
    } else if (word == "node") {
      levels.at(levels.size() - 1).nodes.push_back(numbers_of(line));
    }
  }
  return levels;
}

inline Level read_level(const std::string& name, int n) {
  for (auto& level : read_levels(name))
    if (level.n == n) return level;
  throw std::runtime_error(name + " has no level " + std::to_string(n));
}

}  // namespace netloft::test
