// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/scheme_probe.hpp"

#include "tests/unit/framework/balance/oscillator.hpp"

#include <gtest/gtest.h>

namespace netloft {
namespace {

using test::Moving;
using test::Oscillator;

/// An explicit scheme that multiplies accelerations and velocities by two fractions; it is correct if both
/// fractions are 1.
struct Partly {
  double of_acceleration = 1, of_velocity = 1;

  static int step(const void* parameters, netloft_motion* m) {
    const Partly& part = *static_cast<const Partly*>(parameters);
    for (std::uint32_t i = 0; i < m->unknowns; ++i) {
      m->v_new[i] = m->v[i] + part.of_acceleration * m->h * m->a[i];
      m->u_new[i] = m->u[i] + part.of_velocity * m->h * m->v[i];
      m->a_new[i] = m->a[i];
    }
    return NETLOFT_OK;
  }
  static int refuse(const void*, netloft_motion*) { return NETLOFT_OUTSIDE_DOMAIN; }
  static double order(const void*) { return 1; }
  static double any_step(const void*, double) { return 0; }
};

/// The fault that the probe finds in a scheme, at displacement u and velocity v of the oscillator.
std::string fault_of(const Partly& part, double u, double v, auto step) {
  const Oscillator o;
  Moving m(o.scene());
  IntegratorType type;
  type.type = "test/partly";
  type.integrator.step = step;
  type.integrator.order = Partly::order;
  type.integrator.stable_step = Partly::any_step;
  MarchState at = state_at_rest(m.assembler);
  at.u[0] = u, at.v[0] = v, at.h = 0.1 / o.omega(), at.least_load = o.EA;
  SchemeProbe probe(m.assembler, 0, {&m.solver_type, m.solver_block.data()}, make_factorisation, m.limits);
  return probe.fault_of(StepScheme({&type, &part}), at);
}

std::string fault_of(const Partly& part, double u, double v) { return fault_of(part, u, v, Partly::step); }

TEST(SchemeProbe, AcceptsASchemeThatFollowsTheEquationOfMotion) {
  EXPECT_EQ(fault_of({}, 0.1, 0), "");
  EXPECT_EQ(fault_of({}, 0, 3), "");
  EXPECT_EQ(fault_of({}, 0.1, 3), "");
}

TEST(SchemeProbe, RefusesASchemeThatFollowsLessThanHalfOfTheForces) {
  EXPECT_EQ(fault_of({0.55, 1}, 0.1, 0), "");
  EXPECT_NE(fault_of({0.45, 1}, 0.1, 0).find("test/partly does not follow the equation of motion"),
            std::string::npos);
  EXPECT_NE(fault_of({0, 1}, 0.1, 0), "");
  EXPECT_NE(fault_of({-1, 1}, 0.1, 0), "");
  EXPECT_NE(fault_of({1.6, 1}, 0.1, 0), "");
}

TEST(SchemeProbe, RefusesASchemeThatMovesLessThanHalfOfTheWay) {
  EXPECT_EQ(fault_of({1, 0.55}, 0, 3), "");
  EXPECT_NE(fault_of({1, 0.45}, 0, 3), "");
  EXPECT_NE(fault_of({1, 0}, 0.1, 3), "");
  EXPECT_NE(fault_of({0, 0}, 0.1, 3), "");
}

TEST(SchemeProbe, SaysNothingAtRestInBalanceOrWithoutAStep) {
  EXPECT_EQ(fault_of({0, 0}, 0, 0), "");
  EXPECT_EQ(fault_of({0, 0}, 1e-7, 0),
            "");  // the search for a start may leave forces of 1e-7 of the load
  EXPECT_EQ(fault_of({0, 0}, 0.1, 3, Partly::refuse), "");
}

}  // namespace
}  // namespace netloft
