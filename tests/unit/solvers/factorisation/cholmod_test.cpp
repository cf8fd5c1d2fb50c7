// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/cholmod.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

/// Index of the entry on the diagonal.
std::int32_t diagonal(const TestMatrix& matrix, std::int32_t unknown) {
  return matrix.pattern.column_start[unknown];  // the first of the lower triangle
}

TEST(Cholmod, NamesTheUnknownThatIsNotPositive) {
  // Bars without stiffness: every pivot is the ground's, whatever the order.
  const TestMatrix net = make_net_matrix({.axial = 0, .geometric = 0});
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

TEST(Cholmod, GoesOnAfterAPivotThatIsNotPositive) {
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

TEST(Cholmod, CountsNoNegativePivots) {
  for (const bool diagonals : {true, false}) {
    const TestMatrix net = make_net_matrix({.diagonals = diagonals});
    const auto factorisation = make_cholmod_factorisation();
    factorisation->analyse(net.pattern);
    EXPECT_EQ(factorisation->factorise(net.value).negative_pivots, 0);
  }
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
