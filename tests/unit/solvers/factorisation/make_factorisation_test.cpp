// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/make_factorisation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/factorisation/lower_triangle.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

void expect_equal(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 1e-9 * std::abs(a[i]) + 1e-9);  // condition number about 1e5
}

TEST(MakeFactorisation, TakesMumpsForSymmetricMatricesAndItsOwnForTheRest) {
  const std::string symmetric = has_mumps() ? "MUMPS" : "multifrontal";
  EXPECT_EQ(make_factorisation(MatrixClass::positive_definite)->description().find("multifrontal"), 0u);
  EXPECT_EQ(make_factorisation(MatrixClass::symmetric)->description().find(symmetric), 0u);
  EXPECT_EQ(make_factorisation(MatrixClass::unsymmetric)->description().find("multifrontal"), 0u);
}

TEST(MakeFactorisation, GivesOneSolutionByAllMeans) {
  const TestMatrix lower = make_net_matrix({}), whole = make_net_matrix({.symmetric = false});
  const auto x = solve(*make_factorisation(MatrixClass::positive_definite), lower);
  expect_equal(solve(*make_factorisation(MatrixClass::symmetric), lower), x);
  expect_equal(solve(*make_factorisation(MatrixClass::unsymmetric), whole), x);
}

TEST(LowerTriangle, IsFactorisedAsTheWholeMatrix) {
  const NetOptions indefinite{.ground = -50, .is_fixed = [](int node, int axis) { return node % 5 == axis; }};
  NetOptions also_whole = indefinite;
  also_whole.symmetric = false;
  const auto make = [] { return make_multifrontal_factorisation(nullptr); };
  EXPECT_EQ(solve(*make_factorisation_of_lower_triangle(make()), make_net_matrix(indefinite)),
            solve(*make(), make_net_matrix(also_whole)));
}

}  // namespace
}  // namespace netloft
