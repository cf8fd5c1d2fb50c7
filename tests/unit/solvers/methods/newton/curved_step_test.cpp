// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// E = ½ (x − 3)² + ½ k (y − x²)²: a curved valley, k times as steep across as along (after H. H. Rosenbrock,
/// Comput. J. 3, 1960), with its minimum at (3, 9).
struct Valley {
  double k;
  double u[2] = {0.5, 0.25};  // at its bottom
  int iterations = 0;
  double matrix[3] = {}, kept[3] = {};  // xx, xy, yy
  netloft_problem interface {};

  explicit Valley(double steepness) : k(steepness) {
    interface.size = sizeof interface, interface.host = this, interface.unknowns = 2, interface.u = u;
    interface.traits = NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC;
    interface.evaluate = [](void* host, std::uint32_t want, const double* at, double* energy, double* r) {
      return static_cast<Valley*>(host)->evaluate(want, at, energy, r);
    };
    interface.factorise = [](void* host, int, double shift) {
      return static_cast<Valley*>(host)->factorise(shift);
    };
    interface.factorise_between = [](void*, double, double) -> int { return NETLOFT_FACTOR_FAILED; };
    interface.solve = [](void* host, const double* rhs, double* x) {
      const double* a = static_cast<Valley*>(host)->kept;
      const double determinant = a[0] * a[2] - a[1] * a[1], b[2] = {rhs[0], rhs[1]};
      x[0] = (a[2] * b[0] - a[1] * b[1]) / determinant, x[1] = (a[0] * b[1] - a[1] * b[0]) / determinant;
      return int{NETLOFT_OK};
    };
    interface.progress = [](void* host, const double*, double, const double* r, const char*) {
      if (std::hypot(r[0], r[1]) < 1e-9) return int{NETLOFT_ARRIVED};
      return static_cast<Valley*>(host)->iterations++ < 1000 ? int{NETLOFT_GO_ON} : int{NETLOFT_GIVE_UP};
    };
    interface.step_length = [](void*, const double* du) {
      return std::max(std::abs(du[0]), std::abs(du[1]));
    };
  }

  int evaluate(std::uint32_t want, const double* at, double* energy, double* r) {
    const double x = at[0], off = at[1] - x * x;
    if (energy) *energy = 0.5 * (x - 3) * (x - 3) + 0.5 * k * off * off;
    if (r) r[0] = x - 3 - 2 * k * x * off, r[1] = k * off;
    if (want & NETLOFT_WANT_TANGENT)
      matrix[0] = 1 + 4 * k * x * x - 2 * k * off, matrix[1] = -2 * k * x, matrix[2] = k;
    return NETLOFT_OK;
  }
  int factorise(double shift) {
    kept[0] = matrix[0] + shift * (1 + 36 * k), kept[1] = matrix[1], kept[2] = matrix[2] + shift * k;
    return kept[0] > 0 && kept[0] * kept[2] > kept[1] * kept[1] ? NETLOFT_FACTOR_OK : NETLOFT_NOT_POSITIVE;
  }
};

int iterations_of(double steepness) {
  Valley valley(steepness);
  EXPECT_EQ(solve_problem(valley.interface, "newton", {{"damping", 0.0}}), NETLOFT_STOPPED);
  EXPECT_NEAR(valley.u[0], 3, 1e-6);
  return valley.iterations;
}

// A straight step must end where the rise of E across the valley equals its fall along the valley: the
// steeper the valley, the shorter the steps.
TEST(BentStep, FollowsABentValleyHoweverSteep) {
  EXPECT_LT(iterations_of(1e2), 8);
  EXPECT_LT(iterations_of(1e4), 8);
  EXPECT_LT(iterations_of(1e6), 8);
}

}  // namespace
}  // namespace netloft::test
