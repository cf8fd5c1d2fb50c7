// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/folders.hpp"

#include <fstream>
#include <string>
#include <vector>

namespace netloft::test {

/// Returns the rows of the table whose first row is `heading`. `page` is relative to the checkout.
inline std::vector<std::string> rows_below(const std::string& page, const std::string& heading) {
  std::ifstream in(source_folder() + "/" + page);
  std::string line;
  while (std::getline(in, line) && line != heading) {
  }
  std::getline(in, line);  // | --- |
  std::vector<std::string> rows;
  while (std::getline(in, line) && line.starts_with("|")) rows.push_back(line);
  return rows;
}

}  // namespace netloft::test
