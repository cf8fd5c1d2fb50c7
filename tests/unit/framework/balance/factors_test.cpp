// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/factors.hpp"

#include <gtest/gtest.h>

#include "framework/balance/matrices.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// The metric (linear stiffness) of a rope below a fixed top, with its factorisation.
struct Rope {
  Rope()
      : assembled(rope_of_three()),
        matrices(assembled.assembler, statistics),
        factors(make_factorisation, statistics) {}

  static Scene rope_of_three() {
    Sketch s;
    s.rope("rope", {s.node(0, 0, 0, kAllAxes), s.node(1, 0.2, 0), s.node(2, 0, 0.3), s.node(3, 0.1, 0)}, 0.9);
    return s.scene;
  }
  std::size_t size() const { return static_cast<std::size_t>(assembled.assembler.pattern().size); }
  netloft_factor factorise(double sign) {
    return factors.factorise(assembled.assembler.pattern(), false, matrices.shifted(NETLOFT_NONE, sign));
  }

  Assembled assembled;
  Statistics statistics;
  Matrices matrices;
  Factors factors;
};

TEST(Factors, SolveWithTheLastOfThem) {
  Rope rope;
  ASSERT_EQ(rope.factorise(1), NETLOFT_FACTOR_OK);
  const std::vector<double> rhs = random_numbers(rope.size(), 1);
  std::vector<double> x(rope.size()), again(rope.size());
  ASSERT_TRUE(rope.factors.solve(rhs, x));
  ASSERT_TRUE(rope.matrices.multiply(NETLOFT_NONE, 1, x.data(), again.data()));
  EXPECT_LT(largest_difference(again, rhs), 1e-12);
  EXPECT_EQ(rope.statistics.factorisations, 1);
  EXPECT_EQ(rope.statistics.solves, 1);
}

TEST(Factors, DoNotSolveWithoutAGoodOne) {
  Rope rope;
  const std::vector<double> rhs(rope.size(), 1.0);
  std::vector<double> x(rope.size(), 7.0);
  EXPECT_FALSE(rope.factors.solve(rhs, x));
  EXPECT_EQ(rope.factors.description(), "none");
  EXPECT_EQ(rope.factorise(-1), NETLOFT_NOT_POSITIVE);
  EXPECT_FALSE(rope.factors.solve(rhs, x));
  EXPECT_EQ(x, std::vector<double>(rope.size(), 7.0));
  EXPECT_EQ(rope.statistics.refused_factorisations, 1);
  EXPECT_EQ(rope.statistics.solves, 0);
}

TEST(Factors, CanBeForgotten) {
  Rope rope;
  ASSERT_EQ(rope.factorise(1), NETLOFT_FACTOR_OK);
  rope.factors.forget();
  std::vector<double> x(rope.size(), 1.0);
  EXPECT_FALSE(rope.factors.solve(x, x));
}

TEST(Matrices, HaveNoSumOfAMatrixThatNoEvaluationKept) {
  Rope rope;
  EXPECT_TRUE(rope.matrices.shifted(NETLOFT_EXACT, 1).empty());
  EXPECT_TRUE(rope.matrices.between(0.5, 1).empty());
  std::vector<double> x(rope.size());
  EXPECT_FALSE(rope.matrices.multiply(NETLOFT_CONVEX, 1, x.data(), x.data()));
}

}  // namespace
}  // namespace netloft::test
