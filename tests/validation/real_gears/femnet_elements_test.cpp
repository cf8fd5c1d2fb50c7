// SPDX-License-Identifier: BSD-3-Clause
//
// The elements of these tests pass the same checks as the shipped ones; above all, their tangents are the
// derivatives of their forces.
#include "framework/conformance/conformance.hpp"
#include "framework/conformance/specimen.hpp"

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

/// The force on the first corner of a triangle of netting at rest above the surface, in a flow of 1 m/s,
/// along the flow.
double dry_drag_along_the_flow() {
  using namespace conformance;
  const ElementType& type = plugins().element("femnet/dry_netting");
  const Sample sample{{{{"twine.diameter", 0.004}}}, {0}, {{0, 10, 0}, {0, 0, 10}, {0.05}}};
  const Specimen specimen(type, sample);
  const std::vector<double> zero(9 * kLanes, 0.0);
  States s{0, 1, zero, zero, zero, zero, zero};
  for (std::size_t node = 0; node < 3; ++node) s.x[at(3 * node + 2, 0)] = 1, s.current[at(3 * node, 0)] = 1;
  s.x[at(3, 0)] = 0.3, s.x[at(7, 0)] = 0.3;
  return specimen.evaluate(type.terms[0], s, NETLOFT_WANT_FORCE).force[0];
}

// The plugin shares the parameters of priour/triangle and declares only the diameter. Other parameters have
// the defaults of the struct: a bar has one twine.
TEST(FemnetElements, DryNettingLosesItsDrag) { EXPECT_GT(dry_drag_along_the_flow(), 0); }

INSTANTIATE_TEST_SUITE_P(Each, FemnetElement, testing::Values("dry_netting", "dry_bar", "node", "bend"),
                         [](const testing::TestParamInfo<const char*>& element) { return element.param; });

}  // namespace
}  // namespace netloft::real_gears
