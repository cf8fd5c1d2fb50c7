// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

/// Index of the diagonal entry of an unknown.
std::int32_t diagonal(const TestMatrix& matrix, std::int32_t unknown) {
  return matrix.pattern.column_start[unknown];  // the first entry of its column in the lower triangle
}

Eigen::MatrixXd dense(const TestMatrix& matrix) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(matrix.pattern.size, matrix.pattern.size);
  for (std::int32_t c = 0; c < matrix.pattern.size; ++c)
    for (std::int32_t e = matrix.pattern.column_start[c]; e < matrix.pattern.column_start[c + 1]; ++e)
      A(matrix.pattern.row[e], c) = A(c, matrix.pattern.row[e]) = matrix.value[e];
  return A;
}

TEST(DefiniteFactorisation, TakesRandomMatricesIfAndOnlyIfADenseCholeskyFactorisationDoes) {
  std::mt19937 random(1);
  int taken = 0;
  for (int i = 0; i < 300; ++i) {
    TestMatrix net =
        make_net_matrix({.rings = 3 + i % 5, .nodes_per_ring = 4 + i % 3, .diagonals = i % 2 == 0});
    for (double& value : net.value) value = static_cast<double>(random()) / 0x1p31 - 1;
    for (std::int32_t u = 0; u < net.pattern.size; ++u) net.value[diagonal(net, u)] += 2 + i % 7;
    const auto factorisation = make_definite_factorisation();
    factorisation->analyse(net.pattern);
    const bool is_definite = dense(net).llt().info() == Eigen::Success;
    const FactorResult result = factorisation->factorise(net.value);
    ASSERT_EQ(result.status, is_definite ? FactorStatus::ok : FactorStatus::not_positive_definite) << i;
    if (!is_definite) continue;
    ++taken;
    EXPECT_EQ(result.negative_pivots, 0);
    EXPECT_LT(error_of_solving_again(*factorisation, net), 1e-9) << i;
  }
  EXPECT_GT(taken, 50);
  EXPECT_LT(taken, 250);
}

/// Sets a matrix to a graph Laplacian of random weights, which is singular: its rows sum to zero.
void make_laplacian(TestMatrix& net, std::mt19937& random) {
  const SparsePattern& p = net.pattern;
  for (double& value : net.value) value = -std::exp(static_cast<double>(random() % 7));
  for (std::int32_t u = 0; u < p.size; ++u) net.value[diagonal(net, u)] = 0;
  for (std::int32_t u = 0; u < p.size; ++u)
    for (std::int32_t e = p.column_start[u]; e < p.column_start[u + 1]; ++e)
      if (p.row[e] != u) {
        net.value[diagonal(net, u)] -= net.value[e];
        net.value[diagonal(net, p.row[e])] -= net.value[e];
      }
}

TEST(DefiniteFactorisation, RefusesMatricesThatAreSingularButForRounding) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    TestMatrix net =
        make_net_matrix({.rings = 3 + i % 20, .nodes_per_ring = 4 + i % 7, .diagonals = i % 2 == 0});
    make_laplacian(net, random);
    const auto factorisation = make_definite_factorisation();
    factorisation->analyse(net.pattern);
    EXPECT_EQ(factorisation->factorise(net.value).status, FactorStatus::not_positive_definite) << i;
    for (std::int32_t u = 0; u < net.pattern.size; ++u) net.value[diagonal(net, u)] *= 1 + 1e-9;
    EXPECT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok) << i;
  }
}

TEST(DefiniteFactorisation, NamesTheUnknownThatIsNotPositive) {
  // The bars have no stiffness: in any order, every pivot is the stiffness of the ground.
  const TestMatrix net = make_net_matrix({.axial = 0, .geometric = 0});
  const auto factorisation = make_definite_factorisation();
  factorisation->analyse(net.pattern);
  for (const std::int32_t unknown : {0, 17, 600, net.pattern.size - 1}) {
    TestMatrix broken = net;
    broken.value[diagonal(broken, unknown)] = -1;
    const FactorResult result = factorisation->factorise(broken.value);
    EXPECT_EQ(result.status, FactorStatus::not_positive_definite);
    EXPECT_EQ(result.column, unknown);
  }
}

TEST(DefiniteFactorisation, GoesOnAfterAPivotThatIsNotPositive) {
  const TestMatrix net = make_net_matrix({});
  TestMatrix broken = net;
  broken.value[diagonal(broken, 300)] = -1e6;
  const auto factorisation = make_definite_factorisation();
  factorisation->analyse(net.pattern);
  ASSERT_EQ(factorisation->factorise(broken.value).status, FactorStatus::not_positive_definite);
  ASSERT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok);
  ASSERT_EQ(factorisation->factorise(broken.value).status, FactorStatus::not_positive_definite);
  EXPECT_LT(error_of_solving(*factorisation, net), kRoundOff);
}

TEST(DefiniteFactorisation, HasTheSameBitsForAnyNumberOfThreads) {
  const TestMatrix net = make_net_matrix({.rings = 90, .nodes_per_ring = 90});
  const auto x = solve(*make_definite_factorisation(), net);
  for (const int threads : {2, 3})
    EXPECT_EQ(solve(*make_definite_factorisation(OrderingMethod::best, threads), net), x);
}

TEST(DefiniteFactorisation, ForeseesTheMemoryOfItsFactor) {
  const TestMatrix net = make_net_matrix({.rings = 100, .nodes_per_ring = 100});
  const auto factorisation = make_definite_factorisation();
  factorisation->analyse(net.pattern);
  const double before = allocated_bytes();
  if (before == 0) GTEST_SKIP() << "this build has a malloc that does not tell what it has given out";
  solve_again(*factorisation, net);
  EXPECT_NEAR(factor_bytes_of(*factorisation), allocated_bytes() - before,
              0.05 * factor_bytes_of(*factorisation));
}

}  // namespace
}  // namespace netloft
