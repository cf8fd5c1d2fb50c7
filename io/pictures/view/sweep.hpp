// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::pictures {

/// The setting that differs between the results of a sweep.
struct Varied {
  std::string name;                 // such as "tow.speed"; empty: no setting differs
  std::vector<std::string> values;  // value of each result, as written
  std::vector<double> numbers;      // number at the beginning of each value; NaN if there is none
  std::string unit = {};            // text after the number, if it is the same in all values
};

/// The properties of a result that the picture of a sweep needs: its command and its scene.
struct SweepInput {
  std::vector<std::string> command;  // words of the command line
  std::string scene;                 // text of the scene
};

/// Searches for the varied setting in the --set options of the command lines, then in the lines of the
/// scenes. Returns the first setting whose values are numbers and all different.
Varied varied_setting(const std::vector<SweepInput>& results);

}  // namespace netloft::pictures
