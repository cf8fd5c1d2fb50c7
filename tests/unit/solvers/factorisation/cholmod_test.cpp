// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/cholmod.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

constexpr double kRoundOff = 1e-14;  // backward error of a stable factorisation: some tens of eps

std::vector<double> made_up_vector(std::int32_t size) {
  std::vector<double> b(size);
  for (std::int32_t i = 0; i < size; ++i) b[i] = std::sin(1.0 + 0.7 * i);
  return b;
}

/// Analyses, factorises, solves; -> backward error.
double error_of_solving(Factorisation& factorisation, const TestMatrix& matrix) {
  factorisation.analyse(matrix.pattern);
  const FactorResult result = factorisation.factorise(matrix.value);
  EXPECT_EQ(result.status, FactorStatus::ok);
  EXPECT_EQ(result.negative_pivots, 0);
  const std::vector<double> b = made_up_vector(matrix.pattern.size);
  std::vector<double> x(b.size());
  factorisation.solve(b, x);
  return matrix.backward_error(x, b);
}

/// Index of the entry on the diagonal.
std::int32_t diagonal(const TestMatrix& matrix, std::int32_t unknown) {
  return matrix.pattern.column_start[unknown];  // the first of the lower triangle
}

TEST(Cholmod, SolvesThreeEquationsAsByHand) {
  // [4 2 0; 2 5 3; 0 3 10] x = [8; 21; 36]  ->  x = [1; 2; 3]
  const TestMatrix matrix = make_dense_matrix({{4, 2, 0}, {2, 5, 3}, {0, 3, 10}}, true);
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(matrix.pattern);
  ASSERT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::ok);
  std::vector<double> x(3);
  factorisation->solve(std::vector<double>{8, 21, 36}, x);
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[1], 2, 1e-14);
  EXPECT_NEAR(x[2], 3, 1e-14);
}

TEST(Cholmod, SolvesNetsOfTrianglesAndOfSquares) {
  for (const bool diagonals : {true, false}) {
    const auto factorisation = make_cholmod_factorisation();
    EXPECT_LT(error_of_solving(*factorisation, make_net_matrix({.diagonals = diagonals})), kRoundOff);
  }
}

TEST(Cholmod, SolvesWithEachOrdering) {
  const TestMatrix net = make_net_matrix({});
  for (const OrderingMethod method : {OrderingMethod::amd, OrderingMethod::metis, OrderingMethod::best}) {
    EXPECT_LT(error_of_solving(*make_cholmod_factorisation(method), net), kRoundOff);
  }
}

TEST(Cholmod, SolvesWithFixedUnknowns) {
  const TestMatrix net = make_net_matrix({.is_fixed = [](int node, int axis) {
    return node < 20 || (node % 5 == 0 && axis == 1) || node % 17 == 0;
  }});
  EXPECT_LT(error_of_solving(*make_cholmod_factorisation(), net), kRoundOff);
}

TEST(Cholmod, SolvesInPlace) {
  const TestMatrix net = make_net_matrix({});
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(net.pattern);
  factorisation->factorise(net.value);
  const std::vector<double> b = made_up_vector(net.pattern.size);
  std::vector<double> apart(b.size()), in_place = b;
  factorisation->solve(b, apart);
  factorisation->solve(in_place, in_place);
  EXPECT_EQ(apart, in_place);
}

TEST(Cholmod, ManagesNoUnknownAndOne) {
  const auto factorisation = make_cholmod_factorisation();
  const TestMatrix nothing = make_dense_matrix({}, true);
  factorisation->analyse(nothing.pattern);
  EXPECT_EQ(factorisation->factorise(nothing.value).status, FactorStatus::ok);
  factorisation->solve({}, {});

  const TestMatrix one = make_dense_matrix({{4}}, true);
  factorisation->analyse(one.pattern);
  ASSERT_EQ(factorisation->factorise(one.value).status, FactorStatus::ok);
  std::vector<double> x{2};
  factorisation->solve(x, x);
  EXPECT_DOUBLE_EQ(x[0], 0.5);
}

TEST(Cholmod, FactorisesNewValuesOfOnePattern) {
  NetOptions options;
  const TestMatrix first = make_net_matrix(options);
  options.axial = 1e6;
  const TestMatrix second = make_net_matrix(options);
  const auto factorisation = make_cholmod_factorisation();
  EXPECT_LT(error_of_solving(*factorisation, first), kRoundOff);
  ASSERT_EQ(factorisation->factorise(second.value).status, FactorStatus::ok);
  const std::vector<double> b = made_up_vector(second.pattern.size);
  std::vector<double> x(b.size());
  factorisation->solve(b, x);
  EXPECT_LT(second.backward_error(x, b), kRoundOff);
}

TEST(Cholmod, GivesTheSameBitsEveryTime) {
  const TestMatrix net = make_net_matrix({});
  const std::vector<double> b = made_up_vector(net.pattern.size);
  std::vector<double> first(b.size()), again(b.size()), afresh(b.size());
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(net.pattern);
  factorisation->factorise(net.value);
  factorisation->solve(b, first);
  factorisation->factorise(net.value);
  factorisation->solve(b, again);
  const auto other = make_cholmod_factorisation();
  other->analyse(net.pattern);
  other->factorise(net.value);
  other->solve(b, afresh);
  EXPECT_EQ(first, again);
  EXPECT_EQ(first, afresh);
}

TEST(Cholmod, NamesTheUnknownThatIsNotPositive) {
  // Bars without stiffness: every pivot is the ground's, whatever the order.
  TestMatrix net = make_net_matrix({.axial = 0, .geometric = 0});
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(net.pattern);
  for (const std::int32_t unknown : {0, 17, 600, net.pattern.size - 1}) {
    TestMatrix broken = net;
    broken.value[diagonal(broken, unknown)] = -1;
    const FactorResult result = factorisation->factorise(broken.value);
    EXPECT_EQ(result.status, FactorStatus::not_positive_definite);
    EXPECT_EQ(result.column, unknown);
  }
}

TEST(Cholmod, TakesAZeroPivotForNotPositive) {
  const TestMatrix matrix = make_dense_matrix({{1, 1}, {1, 1}}, true);
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(matrix.pattern);
  EXPECT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::not_positive_definite);
}

TEST(Cholmod, RefusesValuesThatAreNotFinite) {
  const TestMatrix net = make_net_matrix({});
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(net.pattern);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TestMatrix broken = net;
    broken.value[diagonal(broken, 42)] = bad;
    const FactorResult result = factorisation->factorise(broken.value);
    EXPECT_EQ(result.status, FactorStatus::failed);
    EXPECT_EQ(result.column, 42);
  }
}

TEST(Cholmod, GoesOnAfterAFailure) {
  const TestMatrix net = make_net_matrix({});
  TestMatrix broken = net;
  broken.value[diagonal(broken, 300)] = -1e6;
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(net.pattern);
  ASSERT_EQ(factorisation->factorise(broken.value).status, FactorStatus::not_positive_definite);
  ASSERT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok);
  ASSERT_EQ(factorisation->factorise(broken.value).status, FactorStatus::not_positive_definite);
  EXPECT_LT(error_of_solving(*factorisation, net), kRoundOff);
}

TEST(Cholmod, CountsTheFactorOfADenseMatrix) {
  // n(n + 1)/2 entries; flops Σ k² over the column lengths k
  const TestMatrix matrix = make_dense_matrix({{4, 1, 1}, {1, 4, 1}, {1, 1, 4}}, true);
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(matrix.pattern);
  EXPECT_EQ(factorisation->factor_entries(), 6);
  EXPECT_EQ(factorisation->factor_flops(), 14);
}

TEST(Cholmod, TellsItsNameAndOrdering) {
  const TestMatrix net = make_net_matrix({});
  const auto factorisation = make_cholmod_factorisation(OrderingMethod::metis);
  factorisation->analyse(net.pattern);
  EXPECT_EQ(factorisation->description().find("CHOLMOD supernodal LLT "), 0u);
  EXPECT_NE(factorisation->description().find(", METIS on the node graph"), std::string::npos);
}

TEST(Cholmod, LeavesTheThreadsOfTheProgramAsTheyWere) {
  using GetLevels = int (*)();
  const auto levels = reinterpret_cast<GetLevels>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  if (levels == nullptr) GTEST_SKIP() << "this CHOLMOD has no OpenMP";
  const int before = levels();
  error_of_solving(*make_cholmod_factorisation(), make_net_matrix({}));
  EXPECT_EQ(levels(), before);
}

}  // namespace
}  // namespace netloft
