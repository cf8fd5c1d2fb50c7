// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/known_words.hpp"

namespace netloft::formats {

const std::map<std::string, Unit>& known_words() {
  static const std::map<std::string, Unit> table = {
#include "known_words.inc"
  };
  return table;
}

}  // namespace netloft::formats
