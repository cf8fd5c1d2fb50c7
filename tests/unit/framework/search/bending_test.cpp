// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/bending.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

constexpr double kEI = 100;  // [N m²]

/// A rope of two bars of 1 m, clamped along x; the free end is at (x, z).
Scene clamped_rope(double x, double z, double EI) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0, kAllAxes), c = s.node(x, 0, z);
  s.rope("rope", {a, b, c}, 1).parameters["rope.EA_compression"] = 1e4;
  s.part("bend", "rope/bending", {{"rope.EI", EI}}, {a, b, c}).data["rest_length"] = {1, 1};
  return s.scene;
}

double bending_of(const Scene& scene) {
  Assembled a(scene);
  Statistics cost;
  Factors factors(make_factorisation, cost);
  return bending_that_holds(a.assembler, std::vector<double>(3, 0.0), factors);
}

TEST(Bending, HoldsARopeThatIsCompressed) {
  const double x = 0.9, z = 0.3, l = std::hypot(x, z);
  const double turn = std::atan2(z, x), force = 2 * kEI * std::tan(turn / 2) / l;  // (2) of rope_bending.hpp
  EXPECT_NEAR(bending_of(clamped_rope(1 + x, z, kEI)), force * x / l, 1e-9 * force) << "along z";
}

TEST(Bending, DoesNotHoldARopeThatIsTaut) { EXPECT_EQ(bending_of(clamped_rope(2.1, 0.3, kEI)), 0); }

TEST(Bending, IsResistedWhereATermOfItActs) {
  EXPECT_TRUE(resists_bending(Assembled(clamped_rope(2.1, 0.3, kEI)).assembler));
  EXPECT_FALSE(resists_bending(Assembled(clamped_rope(2.1, 0.3, 0)).assembler));
}

}  // namespace
}  // namespace netloft::test
