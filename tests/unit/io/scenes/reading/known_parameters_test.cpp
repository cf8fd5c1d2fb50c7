// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/known_parameters.hpp"

#include "tests/support/rows_of_page.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

TEST(KnownParameters, AreTheTableOfTheGuide) {
  std::vector<std::string> rows;
  for (const KnownParameter& p : parameter::kKnown)
    rows.push_back(std::string("| `") + p.name + "` | " + p.use + " |");
  EXPECT_EQ(test::rows_below("framework/guides/element.md", "| parameter | |"), rows);
}

}  // namespace
}  // namespace netloft::scenes
