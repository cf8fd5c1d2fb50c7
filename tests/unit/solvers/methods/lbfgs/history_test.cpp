// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/lbfgs/history.hpp"

#include <gtest/gtest.h>

#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::lbfgs {
namespace {

using Vector = std::vector<double>;

/// The preconditioner of these tests: B = diag(1, 2, 3, …).
Vector precondition(Vector v) {
  for (std::size_t i = 0; i < v.size(); ++i) v[i] *= static_cast<double>(i + 1);
  return v;
}

Vector multiply(Memory& memory, const Vector& r) {
  Vector scratch(r.size()), p(r.size());
  memory.multiply(r, precondition(r), scratch, p);
  return p;
}

bool add(Memory& memory, const Vector& s, const Vector& y) { return memory.add(s, y, precondition(y)); }

Vector unit(std::size_t size, std::size_t i, double length) {
  Vector v(size, 0.0);
  v[i] = length;
  return v;
}

TEST(Memory, IsThePreconditionerWhenEmpty) {
  Memory memory(3, 4);
  EXPECT_EQ(multiply(memory, {1, 1, 1, 1}), (Vector{1, 2, 3, 4}));
}

// The secant equation is H y = s: Nocedal and Wright, eq. 6.6.
TEST(Memory, MeetsTheSecantEquationOfTheNewestPair) {
  Memory memory(3, 10);
  for (unsigned k = 0; k < 5; ++k) {
    const Vector s = test::random_numbers(10, 2 * k + 1);
    Vector y = test::random_numbers(10, 2 * k + 2);
    for (std::size_t i = 0; i < 10; ++i) y[i] = 0.3 * y[i] + 2 * s[i];
    ASSERT_TRUE(add(memory, s, y));
    EXPECT_LT(test::largest_difference(multiply(memory, y), s), 1e-13);
  }
}

// Pairs along the axes of diag(5, 6, 7) make H its inverse.
TEST(Memory, LearnsADiagonalMatrixFromItsAxes) {
  Memory memory(3, 3);
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_TRUE(add(memory, unit(3, i, 0.1), unit(3, i, 0.1 * static_cast<double>(5 + i))));
  EXPECT_LT(test::largest_difference(multiply(memory, {5, 6, 7}), {1, 1, 1}), 1e-14);
}

// The memory has room for two pairs, so that it forgets the first of three axes: there, H is γ of (3) times
// the preconditioner.
TEST(Memory, ForgetsTheOldestPair) {
  Memory memory(2, 3);
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_TRUE(add(memory, unit(3, i, 0.1), unit(3, i, 0.1 * static_cast<double>(5 + i))));
  const double gamma = 1 / (7.0 * 3);  // of the last pair: s·y / y·B y
  EXPECT_LT(test::largest_difference(multiply(memory, {5, 6, 7}), {5 * gamma, 1, 1}), 1e-14);
}

TEST(Memory, LeavesOutAPairWithoutCurvature) {
  Memory memory(2, 3);
  EXPECT_FALSE(add(memory, {1, 0, 0}, {-1, 0, 0}));
  EXPECT_FALSE(add(memory, {1, 0, 0}, {0, 1, 0}));
  EXPECT_TRUE(memory.is_empty());
  EXPECT_EQ(multiply(memory, {1, 1, 1}), (Vector{1, 2, 3}));
}

TEST(Memory, IsThePreconditionerAgainWhenCleared) {
  Memory memory(2, 3);
  ASSERT_TRUE(add(memory, {1, 0, 0}, {4, 0, 0}));
  memory.clear();
  EXPECT_EQ(multiply(memory, {1, 1, 1}), (Vector{1, 2, 3}));
}

}  // namespace
}  // namespace netloft::lbfgs
