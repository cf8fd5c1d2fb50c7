// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/mumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

/// T − s I, where T has 2 on the diagonal and −1 beside it. The eigenvalues of T are 2 − 2 cos(kπ/(n + 1)),
/// k = 1 … n (Strang, Introduction to Linear Algebra, section 6.4).
TestMatrix make_shifted_chain(int n, double s) {
  std::vector<std::vector<double>> rows(n, std::vector<double>(n, 0));
  for (int i = 0; i < n; ++i) {
    rows[i][i] = 2 - s;
    if (i > 0) rows[i][i - 1] = rows[i - 1][i] = -1;
  }
  return make_dense_matrix(rows, true);
}

int eigenvalues_of_chain_below(int n, double s) {
  int count = 0;
  for (int k = 1; k <= n; ++k) count += 2 - 2 * std::cos(k * std::numbers::pi / (n + 1)) < s;
  return count;
}

std::string name_of(MatrixClass kind) { return kind == MatrixClass::symmetric ? "Symmetric" : "Unsymmetric"; }

class Mumps : public testing::TestWithParam<MatrixClass> {
 protected:
  void SetUp() override {
    if (!has_mumps()) GTEST_SKIP() << "built without MUMPS";
  }
  std::unique_ptr<Factorisation> make() const { return make_mumps_factorisation(GetParam()); }
  TestMatrix make_net(NetOptions options) const {
    options.symmetric = GetParam() == MatrixClass::symmetric;
    return make_net_matrix(options);
  }
};

// With zeros on the diagonal, every pivot that the analysis planned must be delayed.
TEST_P(Mumps, FindsRoomForPivotsThatComeLate) {
  TestMatrix net = make_net({.rings = 40, .nodes_per_ring = 40});
  for (std::int32_t c = 0; c < net.pattern.size; ++c)
    for (std::int32_t e = net.pattern.column_start[c]; e < net.pattern.column_start[c + 1]; ++e)
      if (net.pattern.row[e] == c) net.value[e] = 0;
  EXPECT_LT(error_of_solving(*make(), net), 10 * kRoundOff);  // errors grow because pivots may be a hundredth
                                                              // of other entries
}

TEST_P(Mumps, ServesTwoThreadsWithFactorsOfTheirOwn) {
  const TestMatrix small = make_net({.rings = 8}), large = make_net({.rings = 30});
  const auto try_often = [this](const TestMatrix& net) {
    const auto factorisation = make();
    for (int i = 0; i < 5; ++i) EXPECT_LT(error_of_solving(*factorisation, net), kRoundOff);
  };
  std::thread other(try_often, std::cref(small));
  try_often(large);
  other.join();
}

INSTANTIATE_TEST_SUITE_P(Factorisation, Mumps,
                         testing::Values(MatrixClass::symmetric, MatrixClass::unsymmetric),
                         [](const auto& test) { return name_of(test.param); });

class MumpsInertia : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_mumps()) GTEST_SKIP() << "built without MUMPS";
  }
  static int count_negative_pivots(const TestMatrix& matrix) {
    const auto factorisation = make_mumps_factorisation(MatrixClass::symmetric);
    factorisation->analyse(matrix.pattern);
    const FactorResult result = factorisation->factorise(matrix.value);
    EXPECT_EQ(result.status, FactorStatus::ok);
    return result.negative_pivots;
  }
};

TEST_F(MumpsInertia, CountsTheEigenvaluesOfAChainBelowTheShift) {
  for (const double s : {-1.0, 0.3, 1.1, 2.1, 3.5, 5.0})
    EXPECT_EQ(count_negative_pivots(make_shifted_chain(50, s)), eigenvalues_of_chain_below(50, s)) << s;
}

TEST_F(MumpsInertia, CountsOneOfAPivotOfTwoUnknowns) {
  EXPECT_EQ(count_negative_pivots(make_dense_matrix({{0, 1}, {1, 0}}, true)), 1);  // eigenvalues ±1
}

TEST_F(MumpsInertia, IsNothingForAPositiveDefiniteNetAndAllForItsNegative) {
  TestMatrix net = make_net_matrix({});
  EXPECT_EQ(count_negative_pivots(net), 0);
  for (double& v : net.value) v = -v;
  EXPECT_EQ(count_negative_pivots(net), net.pattern.size);
}

TEST_F(MumpsInertia, IsNotKnownOfAnUnsymmetricMatrix) {
  const TestMatrix net = make_net_matrix({.symmetric = false});
  const auto factorisation = make_mumps_factorisation(MatrixClass::unsymmetric);
  factorisation->analyse(net.pattern);
  EXPECT_EQ(factorisation->factorise(net.value).negative_pivots, -1);
}

}  // namespace
}  // namespace netloft
