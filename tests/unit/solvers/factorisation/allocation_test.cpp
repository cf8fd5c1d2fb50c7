// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/support/counted_malloc.hpp"
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

using test::count_malloc;

/// Counts the allocations of one factorisation and solve, after `rounds` earlier ones.
long count_allocations(Factorisation& factorisation, const TestMatrix& matrix, int rounds) {
  std::vector<double> x(matrix.pattern.size, 1.0);
  long count = 0;
  for (int round = 0; round <= rounds; ++round) {
    const long before = count_malloc();
    const FactorResult result = factorisation.factorise(matrix.value);
    factorisation.solve(x, x);
    count = count_malloc() - before;
    EXPECT_EQ(result.status, FactorStatus::ok);
  }
  return count;
}

class Allocations : public testing::TestWithParam<MatrixClass> {
 protected:
  void SetUp() override {
    if (!test::malloc_is_counted()) GTEST_SKIP() << "malloc cannot be counted in this build";
  }
  /// Number of factorisations after which there are no more allocations. MUMPS keeps arrays from one
  /// factorisation to the next.
  int warm_up() const { return GetParam() == MatrixClass::positive_definite ? 1 : 3; }
  TestMatrix make_net(int side) const {
    return make_net_matrix(
        {.rings = side, .nodes_per_ring = side, .symmetric = GetParam() != MatrixClass::unsymmetric});
  }
};

TEST_P(Allocations, AreSeenInTheFirstFactorisation) {
  const TestMatrix net = make_net(20);
  const auto factorisation = make_factorisation(GetParam());
  factorisation->analyse(net.pattern);
  EXPECT_GT(count_allocations(*factorisation, net, 0), 0);
}

TEST_P(Allocations, AreNoneOnceItHasFactorised) {
  for (const int side : {5, 20, 60}) {
    const TestMatrix net = make_net(side);
    const auto factorisation = make_factorisation(GetParam());
    factorisation->analyse(net.pattern);
    EXPECT_EQ(count_allocations(*factorisation, net, warm_up()), 0) << side;
    EXPECT_EQ(count_allocations(*factorisation, net, 5), 0) << side;
  }
}

TEST_P(Allocations, AreNoneAfterAFailedFactorisation) {
  const TestMatrix net = make_net(20);
  const auto factorisation = make_factorisation(GetParam());
  factorisation->analyse(net.pattern);
  count_allocations(*factorisation, net, warm_up());
  const std::vector<double> zeros(net.value.size(), 0);
  const long before = count_malloc();
  EXPECT_NE(factorisation->factorise(zeros).status, FactorStatus::ok);
  EXPECT_EQ(count_malloc() - before, 0);
  EXPECT_EQ(count_allocations(*factorisation, net, 0), 0);
}

TEST_P(Allocations, AreNoneWithTwoFactorisationsSideBySide) {
  const TestMatrix small = make_net(10), large = make_net(30);
  const auto first = make_factorisation(GetParam()), second = make_factorisation(GetParam());
  first->analyse(small.pattern);
  second->analyse(large.pattern);
  count_allocations(*first, small, warm_up() - 1);
  count_allocations(*second, large, warm_up() - 1);
  EXPECT_EQ(count_allocations(*first, small, 0), 0);
  EXPECT_EQ(count_allocations(*second, large, 0), 0);
}

std::string name_of(MatrixClass kind) {
  const char* const names[] = {"PositiveDefinite", "Symmetric", "Unsymmetric"};
  return names[static_cast<int>(kind)];
}

INSTANTIATE_TEST_SUITE_P(Factorisation, Allocations,
                         testing::Values(MatrixClass::positive_definite, MatrixClass::symmetric,
                                         MatrixClass::unsymmetric),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace netloft
