// SPDX-License-Identifier: BSD-3-Clause
// Runs when Netloft is built: prints the common words as entries of the table in known_words.cpp.
#include <cstdio>

#include "io/formats/units/common_words.hpp"
#include "io/formats/units/known_words.hpp"

namespace netloft::formats {

const std::map<std::string, Unit>& known_words() {
  static const std::map<std::string, Unit> none;
  return none;
}

namespace {

int write_known_words() {
  const UnitSystem units;
  for (const char* word : kCommonWords) {
    const auto unit = units.parse(word);
    if (!unit) {
      std::fprintf(stderr, "UDUNITS-2 has no unit \"%s\": %s\n", word, units.trouble().c_str());
      return 1;
    }
    std::printf("{\"%s\", {{", word);
    for (const auto& [base, power] : unit->dimension) std::printf("{\"%s\", %d}, ", base.c_str(), power);
    std::printf("}, %a, %a}},\n", unit->scale, unit->offset);
  }
  return 0;
}

}  // namespace
}  // namespace netloft::formats

int main() { return netloft::formats::write_known_words(); }
