// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/cholmod.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>

#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/suitesparse_scope.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

/// Index of the diagonal entry of an unknown.
std::int32_t diagonal(const TestMatrix& matrix, std::int32_t unknown) {
  return matrix.pattern.column_start[unknown];  // the first of the lower triangle
}

TEST(Cholmod, NamesTheUnknownThatIsNotPositive) {
  // The bars have no stiffness: in any order, every pivot is the stiffness of the ground.
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

TEST(Cholmod, HasTheSameBitsWithIndicesOf64) {
  const TestMatrix net = make_net_matrix({});
  const auto narrow = make_cholmod_factorisation(OrderingMethod::metis),
             wide = make_cholmod_factorisation_of(IndexWidth::of_64_bits, OrderingMethod::metis);
  EXPECT_EQ(solve(*narrow, net), solve(*wide, net));
  EXPECT_EQ(narrow->description().find("64 bits"), std::string::npos);
  EXPECT_NE(wide->description().find("64 bits"), std::string::npos);
}

TEST(Cholmod, NamesTheUnknownThatIsNotPositiveWithIndicesOf64) {
  TestMatrix broken = make_net_matrix({.axial = 0, .geometric = 0});
  broken.value[diagonal(broken, 600)] = -1;
  const auto wide = make_cholmod_factorisation_of(IndexWidth::of_64_bits, OrderingMethod::amd);
  wide->analyse(broken.pattern);
  EXPECT_EQ(wide->factorise(broken.value).column, 600);
}

// The matrix is only analysed, because its factor would take 18 GB.
TEST(Cholmod, TakesIndicesOf64WhereTheFactorHasMoreEntriesThan32Count) {
  const SparsePattern lattice = make_lattice(56, 6, true);
  const auto factorisation = make_cholmod_factorisation(OrderingMethod::metis);
  factorisation->analyse(lattice);
  EXPECT_GT(factorisation->factor_entries(), kMostOf32Bits);
  EXPECT_GT(factor_bytes_of(*factorisation), 8 * kMostOf32Bits);
  EXPECT_NE(factorisation->description().find("64 bits"), std::string::npos);
}

// The memory pool makes blocks up to a quarter larger than requested; the additional memory is never used.
TEST(Cholmod, ForeseesTheMemoryOfItsFactor) {
  const TestMatrix net = make_net_matrix({.rings = 100, .nodes_per_ring = 100});
  const auto factorisation = make_cholmod_factorisation();
  factorisation->analyse(net.pattern);
  const double before = allocated_bytes();
  if (before == 0) GTEST_SKIP() << "this build has a malloc that does not tell what it has given out";
  solve_again(*factorisation, net);
  const double taken = allocated_bytes() - before;
  EXPECT_GT(taken, factor_bytes_of(*factorisation));
  EXPECT_LT(taken, 1.25 * factor_bytes_of(*factorisation));
}

TEST(Cholmod, LeavesTheThreadsOfTheProgramAsTheyWere) {
  using GetLevels = int (*)();
  const auto levels = reinterpret_cast<GetLevels>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  if (levels == nullptr) GTEST_SKIP() << "this CHOLMOD has no OpenMP";
  const int before = levels();
  error_of_solving(*make_cholmod_factorisation(), make_net_matrix({}));
  EXPECT_EQ(levels(), before);
}

/// How parallel regions begin, by GCC's convention.
using Begin = void (*)(void (*)(void*), void*, unsigned, unsigned);

TEST(SingleThreadScope, MakesAPlainCallOfAParallelRegionOfCholmod) {
  const auto begin = reinterpret_cast<Begin>(dlsym(RTLD_DEFAULT, "GOMP_parallel"));  // as CHOLMOD finds it
  ASSERT_NE(begin, nullptr);
  Dl_info found{}, own{};
  ASSERT_NE(dladdr(reinterpret_cast<void*>(begin), &found), 0);
  ASSERT_NE(dladdr(reinterpret_cast<void*>(&make_cholmod_factorisation), &own), 0);
  EXPECT_STREQ(found.dli_fname, own.dli_fname) << "the runtime's own is found first";
  std::atomic<int> calls = 0;
  const SingleThreadScope scope;
  begin([](void* data) { ++*static_cast<std::atomic<int>*>(data); }, &calls, 4, 0);
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace netloft
