// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// r = u |u|^(q−1), in a problem that declares no potential. Newton's own step leads from u to u − u/q. With
/// q = 1/2 it alternates between u and −u for ever, and by the trapezoidal rule the force does no work
/// between them; with a smaller q the steps lead ever farther away.
struct Root {
  double q, element, u = 1, tangent = 0, kept = 0;
  double last = 0;  // point of the last evaluation of the residual
  int iterations = 0, found_again = 0;
  netloft_problem interface {};

  Root(double exponent, double element_size) : q(exponent), element(element_size) {
    interface.size = sizeof interface, interface.host = this, interface.unknowns = 1, interface.u = &u;
    interface.evaluate = [](void* host, std::uint32_t want, const double* at, double* energy, double* r) {
      auto& self = *static_cast<Root*>(host);
      const bool asks_gradient = (want & NETLOFT_WANT_GRADIENT) != 0;
      const double slope = std::pow(std::abs(*at), self.q - 1);
      if (energy) *energy = 0;
      if (r) *r = *at == 0 || asks_gradient ? 0 : *at * slope;
      if (r && !asks_gradient) self.found_again += *at == self.last, self.last = *at;
      if (want & NETLOFT_WANT_TANGENT) self.tangent = self.q * slope;
      return int{NETLOFT_OK};
    };
    interface.evaluate_both = [](void* host, const double* at, double* energy, double* r, double* gradient) {
      *gradient = 0;
      return static_cast<Root*>(host)->interface.evaluate(host, NETLOFT_WANT_FORCE, at, energy, r);
    };
    interface.factorise = [](void* host, int, double shift) {
      auto& self = *static_cast<Root*>(host);
      self.kept = self.tangent + shift;
      return int{NETLOFT_FACTOR_OK};
    };
    interface.solve = [](void* host, const double* rhs, double* x) {
      *x = *rhs / static_cast<Root*>(host)->kept;
      return int{NETLOFT_OK};
    };
    interface.progress = [](void* host, const double*, double, const double* r, const char*) {
      if (std::abs(*r) < 1e-9) return int{NETLOFT_ARRIVED};
      return static_cast<Root*>(host)->iterations++ < 100 ? int{NETLOFT_GO_ON} : int{NETLOFT_GIVE_UP};
    };
    interface.step_length = [](void* host, const double* du) {
      return std::abs(*du) / static_cast<Root*>(host)->element;
    };
  }
};

TEST(WholeStep, IsLeftToTheSearchWhereItIsLongerThanAnElement) {
  Root root(0.5, 1);
  solve_problem(root.interface, "newton", {{"damping", 0.0}});
  EXPECT_NEAR(root.u, 0, 1e-12);
}

/// The search begins with the forces at the end of a refused whole step, and the next step with those at the
/// point that the search has accepted.
TEST(WholeStep, FindsForcesAtNoPointTwiceInSuccession) {
  Root root(0.4, 1e300);
  solve_problem(root.interface, "newton", {{"damping", 0.0}});
  EXPECT_GT(root.iterations, 5);
  EXPECT_EQ(root.found_again, 0);
}

TEST(WholeStep, GoesUphillFromTheLeastMeritAlone) {
  Root root(0.4, 1e300);
  solve_problem(root.interface, "newton", {{"damping", 0.0}});
  EXPECT_LT(std::abs(root.u), 1e-9);  // a hundred steps uphill end beyond 1e17
}

}  // namespace
}  // namespace netloft::test
