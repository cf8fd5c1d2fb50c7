// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/factorisation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/factorisation/lower_triangle.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "solvers/factorisation/umfpack.hpp"
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

std::vector<double> solve(Factorisation& factorisation, const TestMatrix& matrix) {
  factorisation.analyse(matrix.pattern);
  EXPECT_EQ(factorisation.factorise(matrix.value).status, FactorStatus::ok);
  std::vector<double> x(matrix.pattern.size);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(1.0 + 0.7 * static_cast<double>(i));
  factorisation.solve(x, x);
  return x;
}

void expect_equal(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 1e-9 * std::abs(a[i]) + 1e-9);  // condition number about 1e5
}

TEST(MakeFactorisation, TakesCholmodForPositiveDefiniteMatricesMumpsForSymmetricOnesAndItsOwnForTheRest) {
  const std::string symmetric = has_mumps() ? "MUMPS" : "UMFPACK";
  EXPECT_EQ(make_factorisation(MatrixClass::positive_definite)->description().find("CHOLMOD"), 0u);
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
  const auto of_lower = make_factorisation_of_lower_triangle(make_umfpack_factorisation());
  EXPECT_EQ(solve(*of_lower, make_net_matrix(indefinite)),
            solve(*make_umfpack_factorisation(), make_net_matrix(also_whole)));
}

TEST(LowerTriangle, IsReadWhereThePatternSaysThatItsValuesStand) {
  TestMatrix net = make_net_matrix({});
  const auto x = solve(*make_factorisation_of_lower_triangle(make_umfpack_factorisation()), net);
  const std::size_t entries = net.pattern.entries();
  net.pattern.slots = entries + 1;  // back to front, behind a value that nobody uses
  std::vector<double> moved(entries + 1);
  for (std::size_t e = 0; e < entries; ++e) {
    net.pattern.slot.push_back(static_cast<std::int32_t>(entries - e));
    moved[entries - e] = net.value[e];
  }
  net.value = moved;
  EXPECT_EQ(solve(*make_factorisation_of_lower_triangle(make_umfpack_factorisation()), net), x);
  expect_equal(solve(*make_factorisation(MatrixClass::symmetric), net), x);
}

}  // namespace
}  // namespace netloft
