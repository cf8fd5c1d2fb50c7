// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// The key of the scene in which several results differ.
struct VariedKey {
  std::string path;                 // such as "tow.speed"; empty: there is no such key
  std::vector<std::string> values;  // value of each result, as written
  std::vector<double> numbers;      // number at the beginning of each value
  std::string unit = {};            // text after the number, if it is the same in all values
};

/// Returns the first key whose values are numbers, with or without units, and all different.
VariedKey find_varied_key(const std::vector<const Result*>& results);

/// One title for several results. If all have the same title, their values of the varied key are added:
/// "83-112: tow.speed 2 kn, 3 kn". If no key varies, their file names are added.
std::string title_of(const std::vector<const Result*>& results);

}  // namespace netloft::results
