// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/umfpack.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

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
