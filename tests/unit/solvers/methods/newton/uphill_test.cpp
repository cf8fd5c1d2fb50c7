// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// E = −½ k u² with the linear stiffness 1, in a problem that does not declare its matrix symmetric. The step
/// s = k u/(μ − k) of newton.hpp (2) leads uphill until μ is more than k.
struct Summit {
  double k;
  bool has_factor = true;
  double u = 1, kept = 0;
  int iterations = 0;
  netloft_problem interface {};

  explicit Summit(double steepness) : k(steepness) {
    interface.size = sizeof interface, interface.host = this, interface.unknowns = 1, interface.u = &u;
    interface.traits = NETLOFT_CONSERVATIVE;
    interface.evaluate = [](void* host, std::uint32_t, const double* at, double* energy, double* r) {
      const double k = static_cast<Summit*>(host)->k;
      if (energy) *energy = -0.5 * k * *at * *at;
      if (r) *r = -k * *at;
      return int{NETLOFT_OK};
    };
    interface.factorise = [](void* host, int, double shift) {
      auto& self = *static_cast<Summit*>(host);
      self.kept = shift - self.k;
      return int{self.has_factor ? NETLOFT_FACTOR_OK : NETLOFT_FACTOR_FAILED};
    };
    interface.solve = [](void* host, const double* rhs, double* x) {
      *x = *rhs / static_cast<Summit*>(host)->kept;
      return int{NETLOFT_OK};
    };
    interface.progress = [](void* host, const double*, double, const double*, const char*) {
      return static_cast<Summit*>(host)->iterations++ < 10 ? int{NETLOFT_GO_ON} : int{NETLOFT_GIVE_UP};
    };
    interface.step_length = [](void*, const double* du) { return std::abs(*du); };
  }
};

netloft_outcome outcome_of(Summit summit) {
  summit.interface.host = &summit, summit.interface.u = &summit.u;
  return solve_problem(summit.interface, "newton");
}

TEST(UnsymmetricTangent, IsDampedUntilAStepLeadsDownhill) {
  EXPECT_EQ(outcome_of(Summit(10)), NETLOFT_STOPPED);
}

TEST(UnsymmetricTangent, OfWhichNoStepLeadsDownhillIsNotSaidToBeSingular) {
  EXPECT_EQ(outcome_of(Summit(100)), NETLOFT_STEP_TOO_SHORT);
}

TEST(UnsymmetricTangent, ThatHasNoFactorIsSaidToBe) {
  Summit summit(100);
  summit.has_factor = false;
  EXPECT_EQ(outcome_of(summit), NETLOFT_LINEAR_SOLVE);
}

}  // namespace
}  // namespace netloft::test
