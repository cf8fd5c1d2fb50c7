// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::pictures {

/// The setting in which the results of a sweep differ.
struct Varied {
  std::string name;                 // "tow.speed"; empty: nothing was found
  std::vector<std::string> values;  // as they are written, by result
  std::vector<double> numbers;      // the numbers they begin with; NaN where there is none
  std::string unit = {};            // what follows the numbers, if that is the same in all
};

/// The command and the scene of a result.
struct SweepInput {
  std::vector<std::string> command;  // word by word
  std::string scene;                 // the text of its scene
};

/// Looks for the setting in the options --set of the command lines, then in the lines of the scenes. Takes
/// the first setting whose values are numbers, and all different.
Varied varied_setting(const std::vector<SweepInput>& results);

}  // namespace netloft::pictures
