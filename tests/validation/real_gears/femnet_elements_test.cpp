// SPDX-License-Identifier: BSD-3-Clause
//
// What the tests add to the shipped elements keeps the same promises as they do: above all, its tangents are
// the derivatives of its forces.
#include "framework/conformance/conformance.hpp"

#include <gtest/gtest.h>

#include "tests/validation/real_gears/solving.hpp"

namespace netloft::real_gears {
namespace {

class FemnetElement : public testing::TestWithParam<const char*> {};

TEST_P(FemnetElement, KeepsItsPromises) {
  const ConformanceReport report =
      check_element(plugins().element(std::string("femnet/") + GetParam()), {.timings = false});
  EXPECT_TRUE(report.passed()) << failures(report);
}

INSTANTIATE_TEST_SUITE_P(Each, FemnetElement, testing::Values("dry_netting", "dry_bar", "node", "bend"),
                         [](const testing::TestParamInfo<const char*>& element) { return element.param; });

}  // namespace
}  // namespace netloft::real_gears
