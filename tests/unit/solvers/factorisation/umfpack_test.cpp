// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/umfpack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

constexpr double kRoundOff = 1e-14;  // backward error of a stable factorisation: some tens of eps

double error_of_solving(Factorisation& factorisation, const TestMatrix& matrix) {
  factorisation.analyse(matrix.pattern);
  EXPECT_EQ(factorisation.factorise(matrix.value).status, FactorStatus::ok);
  std::vector<double> b(matrix.pattern.size), x(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::cos(0.3 * static_cast<double>(i));
  factorisation.solve(b, x);
  return matrix.backward_error(x, b);
}

TEST(Umfpack, SolvesThreeEquationsAsByHand) {
  // [4 2 0; -2 5 3; 0 1 10] x = [8; 17; 32]  ->  x = [1; 2; 3]
  const TestMatrix matrix = make_dense_matrix({{4, 2, 0}, {-2, 5, 3}, {0, 1, 10}}, false);
  const auto factorisation = make_umfpack_factorisation();
  factorisation->analyse(matrix.pattern);
  ASSERT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::ok);
  std::vector<double> x{8, 17, 32};
  factorisation->solve(x, x);
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[1], 2, 1e-14);
  EXPECT_NEAR(x[2], 3, 1e-14);
}

TEST(Umfpack, SolvesANetWithSkewDragWithEachOrdering) {
  const TestMatrix net = make_net_matrix({.symmetric = false, .ground = 10, .skew = 3});
  for (const OrderingMethod method : {OrderingMethod::amd, OrderingMethod::metis, OrderingMethod::best}) {
    EXPECT_LT(error_of_solving(*make_umfpack_factorisation(method), net), kRoundOff);
  }
}

TEST(Umfpack, SolvesWithFixedUnknowns) {
  const TestMatrix net = make_net_matrix({.symmetric = false, .skew = 1, .is_fixed = [](int node, int axis) {
                                            return node < 20 || (node % 5 == 0 && axis == 1);
                                          }});
  EXPECT_LT(error_of_solving(*make_umfpack_factorisation(), net), kRoundOff);
}

TEST(Umfpack, SolvesAnIndefiniteMatrix) {
  const TestMatrix net = make_net_matrix({.symmetric = false, .ground = -50});
  EXPECT_LT(error_of_solving(*make_umfpack_factorisation(), net), kRoundOff);
}

TEST(Umfpack, ManagesNoUnknownAndOne) {
  const auto factorisation = make_umfpack_factorisation();
  const TestMatrix nothing = make_dense_matrix({}, false);
  factorisation->analyse(nothing.pattern);
  EXPECT_EQ(factorisation->factorise(nothing.value).status, FactorStatus::ok);
  factorisation->solve({}, {});

  const TestMatrix one = make_dense_matrix({{-4}}, false);
  factorisation->analyse(one.pattern);
  ASSERT_EQ(factorisation->factorise(one.value).status, FactorStatus::ok);
  std::vector<double> x{2};
  factorisation->solve(x, x);
  EXPECT_DOUBLE_EQ(x[0], -0.5);
}

TEST(Umfpack, NamesTheUnknownWithoutStiffness) {
  const TestMatrix net = make_net_matrix({.symmetric = false, .axial = 0, .geometric = 0});
  const auto factorisation = make_umfpack_factorisation();
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

TEST(Umfpack, ReportsEqualRowsAsSingular) {
  const TestMatrix matrix = make_dense_matrix({{1, 2}, {1, 2}}, false);
  const auto factorisation = make_umfpack_factorisation();
  factorisation->analyse(matrix.pattern);
  EXPECT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::singular);
}

TEST(Umfpack, RefusesValuesThatAreNotFinite) {
  TestMatrix matrix = make_dense_matrix({{1, 2}, {3, 4}}, false);
  matrix.value[2] = std::numeric_limits<double>::quiet_NaN();
  const auto factorisation = make_umfpack_factorisation();
  factorisation->analyse(matrix.pattern);
  const FactorResult result = factorisation->factorise(matrix.value);
  EXPECT_EQ(result.status, FactorStatus::failed);
  EXPECT_EQ(result.column, 1);
}

TEST(Umfpack, GoesOnAfterAFailure) {
  const TestMatrix net = make_net_matrix({.symmetric = false, .skew = 1});
  const auto factorisation = make_umfpack_factorisation();
  factorisation->analyse(net.pattern);
  const std::vector<double> zeros(net.value.size(), 0);
  ASSERT_EQ(factorisation->factorise(zeros).status, FactorStatus::singular);
  ASSERT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok);
  ASSERT_EQ(factorisation->factorise(zeros).status, FactorStatus::singular);
  EXPECT_LT(error_of_solving(*factorisation, net), kRoundOff);
}

TEST(Umfpack, CountsTheFactorsOfADenseMatrix) {
  // L and U with both diagonals
  const TestMatrix matrix = make_dense_matrix({{4, 1, 1}, {2, 4, 1}, {1, 2, 4}}, false);
  const auto factorisation = make_umfpack_factorisation();
  factorisation->analyse(matrix.pattern);
  ASSERT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::ok);
  EXPECT_EQ(factorisation->factor_entries(), 12);
  EXPECT_GT(factorisation->factor_flops(), 0);
}

}  // namespace
}  // namespace netloft
