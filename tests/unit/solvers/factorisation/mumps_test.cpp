// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/mumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

constexpr double kRoundOff = 1e-14;  // backward error of a stable factorisation: some tens of eps

std::vector<double> made_up_vector(std::int32_t size) {
  std::vector<double> b(size);
  for (std::int32_t i = 0; i < size; ++i) b[i] = std::cos(0.3 * i);
  return b;
}

double error_of_solving(Factorisation& factorisation, const TestMatrix& matrix) {
  factorisation.analyse(matrix.pattern);
  EXPECT_EQ(factorisation.factorise(matrix.value).status, FactorStatus::ok);
  const auto b = made_up_vector(matrix.pattern.size);
  std::vector<double> x(b.size());
  factorisation.solve(b, x);
  return matrix.backward_error(x, b);
}

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
  bool symmetric() const { return GetParam() == MatrixClass::symmetric; }
  std::unique_ptr<Factorisation> make() const { return make_mumps_factorisation(GetParam()); }
  TestMatrix make_net(NetOptions options = {}) const {
    options.symmetric = symmetric();
    return make_net_matrix(options);
  }
};

TEST_P(Mumps, SolvesThreeEquationsAsByHand) {
  // [4 2 0; 2 -5 3; 0 3 10] x = [8; 1; 36]  ->  x = [1; 2; 3]
  const TestMatrix matrix = make_dense_matrix({{4, 2, 0}, {2, -5, 3}, {0, 3, 10}}, symmetric());
  const auto factorisation = make();
  factorisation->analyse(matrix.pattern);
  ASSERT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::ok);
  std::vector<double> x{8, 1, 36};
  factorisation->solve(x, x);
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[1], 2, 1e-14);
  EXPECT_NEAR(x[2], 3, 1e-14);
}

TEST_P(Mumps, SolvesAnIndefiniteNetWithEachOrdering) {
  const TestMatrix net = make_net({.ground = -50});
  for (const OrderingMethod method : {OrderingMethod::amd, OrderingMethod::metis, OrderingMethod::best}) {
    EXPECT_LT(error_of_solving(*make_mumps_factorisation(GetParam(), method), net), kRoundOff);
  }
}

TEST_P(Mumps, SolvesWithFixedUnknowns) {
  const TestMatrix net =
      make_net({.is_fixed = [](int node, int axis) { return node < 20 || (node % 5 == 0 && axis == 1); }});
  EXPECT_LT(error_of_solving(*make(), net), kRoundOff);
}

TEST_P(Mumps, ManagesNoUnknownAndOne) {
  const auto factorisation = make();
  const TestMatrix nothing = make_dense_matrix({}, symmetric());
  factorisation->analyse(nothing.pattern);
  EXPECT_EQ(factorisation->factorise(nothing.value).status, FactorStatus::ok);
  factorisation->solve({}, {});

  const TestMatrix one = make_dense_matrix({{-4}}, symmetric());
  factorisation->analyse(one.pattern);
  ASSERT_EQ(factorisation->factorise(one.value).status, FactorStatus::ok);
  std::vector<double> x{2};
  factorisation->solve(x, x);
  EXPECT_DOUBLE_EQ(x[0], -0.5);
}

TEST_P(Mumps, NamesTheUnknownWithoutStiffness) {
  const TestMatrix net = make_net({.axial = 0, .geometric = 0});
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  for (const std::int32_t unknown : {0, 17, net.pattern.size - 1}) {
    TestMatrix broken = net;
    for (std::int32_t e = net.pattern.column_start[unknown]; e < net.pattern.column_start[unknown + 1]; ++e) {
      broken.value[e] = 0;
    }
    const FactorResult result = factorisation->factorise(broken.value);
    EXPECT_EQ(result.status, FactorStatus::singular);
    EXPECT_EQ(result.column, unknown);
  }
}

TEST_P(Mumps, ReportsEqualRowsAsSingular) {
  const TestMatrix matrix = make_dense_matrix({{1, 1}, {1, 1}}, symmetric());
  const auto factorisation = make();
  factorisation->analyse(matrix.pattern);
  EXPECT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::singular);
}

TEST_P(Mumps, RefusesValuesThatAreNotFinite) {
  TestMatrix net = make_net();
  net.value[net.pattern.column_start[42]] = std::numeric_limits<double>::quiet_NaN();
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  const FactorResult result = factorisation->factorise(net.value);
  EXPECT_EQ(result.status, FactorStatus::failed);
  EXPECT_EQ(result.column, 42);
}

TEST_P(Mumps, GoesOnAfterAFailure) {
  const TestMatrix net = make_net();
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  const std::vector<double> zeros(net.value.size(), 0);
  ASSERT_EQ(factorisation->factorise(zeros).status, FactorStatus::singular);
  ASSERT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok);
  ASSERT_EQ(factorisation->factorise(zeros).status, FactorStatus::singular);
  EXPECT_LT(error_of_solving(*factorisation, net), kRoundOff);
}

// With nothing on the diagonal, every pivot that the analysis foresaw has to wait for another.
TEST_P(Mumps, FindsRoomForPivotsThatComeLate) {
  TestMatrix net = make_net({.rings = 40, .nodes_per_ring = 40});
  for (std::int32_t c = 0; c < net.pattern.size; ++c)
    for (std::int32_t e = net.pattern.column_start[c]; e < net.pattern.column_start[c + 1]; ++e)
      if (net.pattern.row[e] == c) net.value[e] = 0;
  EXPECT_LT(error_of_solving(*make(), net), 10 * kRoundOff);  // pivots of a hundredth let errors grow
}

TEST_P(Mumps, GivesTheSameBitsEveryTime) {
  const TestMatrix net = make_net({.ground = -50});
  const auto solve_with = [&](Factorisation& factorisation) {
    EXPECT_EQ(factorisation.factorise(net.value).status, FactorStatus::ok);
    auto x = made_up_vector(net.pattern.size);
    factorisation.solve(x, x);
    return x;
  };
  const auto first = make(), second = make();
  first->analyse(net.pattern), second->analyse(net.pattern);
  const auto x = solve_with(*first);
  EXPECT_EQ(solve_with(*first), x);
  EXPECT_EQ(solve_with(*second), x);
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
