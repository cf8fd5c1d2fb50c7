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

/// What a result was made from.
struct SweepInput {
  std::vector<std::string> command;  // word by word
  std::string scene;                 // the text of its scene
};

/// Seeks it in the options --set of the command lines first, then in the scenes' own lines. Of several
/// settings the first is taken whose values are numbers, and all different.
Varied varied_setting(const std::vector<SweepInput>& results);

}  // namespace netloft::pictures
