// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/distributed.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "solvers/factorisation/factorisation.hpp"
#include "solvers/factorisation/foreseen_memory.hpp"
#include "tests/unit/solvers/factorisation/on_one_rank.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

class Distributed : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_ranks()) GTEST_SKIP() << "built without MUMPS, or without MPI";
  }
  static std::unique_ptr<Factorisation> make(MatrixClass kind, std::int32_t from) {
    return make_distributed_factorisation(kind, {&test::one_rank(), from}, make_factorisation,
                                          make_mumps_on(test::one_rank()));
  }
};

TEST_F(Distributed, TakesWhatIsLargeAndLeavesWhatIsSmall) {
  const TestMatrix small = make_net_matrix({.rings = 5}), large = make_net_matrix({.rings = 20});
  const auto factorisation = make(MatrixClass::positive_definite, large.pattern.size);
  const std::string cholmod = "CHOLMOD", mumps = "MUMPS LDLT";
  for (const TestMatrix* matrix : {&small, &large, &small}) {
    EXPECT_LT(error_of_solving(*factorisation, *matrix), kRoundOff);
    EXPECT_TRUE(factorisation->description().starts_with(matrix == &small ? cholmod : mumps));
    EXPECT_GT(factor_bytes_of(*factorisation), 0);
  }
}

TEST_F(Distributed, SaysThatAMatrixIsNotPositiveDefinite) {
  TestMatrix net = make_net_matrix({});
  const auto factorisation = make(MatrixClass::positive_definite, 1);
  factorisation->analyse(net.pattern);
  EXPECT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok);
  net.value[net.pattern.column_start[42]] = -1e5;
  EXPECT_EQ(factorisation->factorise(net.value).status, FactorStatus::not_positive_definite);
}

TEST_F(Distributed, CountsNegativePivotsOfASymmetricMatrix) {
  TestMatrix net = make_net_matrix({});
  net.value[net.pattern.column_start[42]] = -1e5;
  const auto factorisation = make(MatrixClass::symmetric, 1);
  factorisation->analyse(net.pattern);
  const FactorResult result = factorisation->factorise(net.value);
  EXPECT_EQ(result.status, FactorStatus::ok);
  EXPECT_EQ(result.negative_pivots, 1);
}

TEST(Ranks, SayWhatIsMissing) {
  try {
    Ranks("nowhere/mumps_mpi.so", Launch{0, 2, true});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("there is no nowhere/mumps_mpi.so"), std::string::npos);
  }
}

}  // namespace
}  // namespace netloft
