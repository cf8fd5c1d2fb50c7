// SPDX-License-Identifier: BSD-3-Clause
//
// Tests that every factorisation must pass. Tests of a single factorisation are in separate files.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <numeric>
#include <ostream>

#include "solvers/factorisation/lower_triangle.hpp"
#include "solvers/factorisation/multifrontal.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

constexpr OrderingMethod kOrderings[] = {OrderingMethod::amd, OrderingMethod::metis, OrderingMethod::best};

using Rows = std::vector<std::vector<double>>;

struct Tested {
  const char* name;
  MatrixClass kind;  // that it is for
  std::function<std::unique_ptr<Factorisation>(OrderingMethod)> make;
  bool is_built = true;
};

void PrintTo(const Tested& tested, std::ostream* out) { *out << tested.name; }

std::unique_ptr<Factorisation> make_multifrontal(OrderingMethod method) {
  return make_multifrontal_factorisation(nullptr, method);
}
std::unique_ptr<Factorisation> make_multifrontal_of_lower_triangle(OrderingMethod method) {
  return make_factorisation_of_lower_triangle(make_multifrontal(method));
}
std::unique_ptr<Factorisation> make_definite(OrderingMethod method) {
  return make_definite_factorisation(method);
}
std::unique_ptr<Factorisation> make_symmetric_mumps(OrderingMethod method) {
  return make_mumps_factorisation(MatrixClass::symmetric, method);
}
std::unique_ptr<Factorisation> make_unsymmetric_mumps(OrderingMethod method) {
  return make_mumps_factorisation(MatrixClass::unsymmetric, method);
}

std::vector<Tested> all_factorisations() {
  return {{"Definite", MatrixClass::positive_definite, make_definite},
          {"MumpsSymmetric", MatrixClass::symmetric, make_symmetric_mumps, has_mumps()},
          {"MumpsUnsymmetric", MatrixClass::unsymmetric, make_unsymmetric_mumps, has_mumps()},
          {"Multifrontal", MatrixClass::unsymmetric, make_multifrontal},
          {"MultifrontalOfLowerTriangle", MatrixClass::symmetric, make_multifrontal_of_lower_triangle}};
}

class EveryFactorisation : public testing::TestWithParam<Tested> {
 protected:
  void SetUp() override {
    if (!GetParam().is_built) GTEST_SKIP() << "built without MUMPS";
  }
  /// Whether a factorisation takes matrices of a class: every class contains the classes before it.
  static bool takes(MatrixClass kind) { return kind <= GetParam().kind; }
  static FactorStatus singular() {
    return takes(MatrixClass::symmetric) ? FactorStatus::singular : FactorStatus::not_positive_definite;
  }
  static std::unique_ptr<Factorisation> make(OrderingMethod method = OrderingMethod::best) {
    return GetParam().make(method);
  }
  static TestMatrix make_dense(const Rows& rows) {
    return make_dense_matrix(rows, GetParam().kind != MatrixClass::unsymmetric);
  }
  /// Makes a net, without the skew part if the matrices are symmetric.
  static TestMatrix make_net(NetOptions options = {}) {
    options.symmetric = GetParam().kind != MatrixClass::unsymmetric;
    if (options.symmetric) options.skew = 0;
    return make_net_matrix(options);
  }
  static TestMatrix make_hardest_net(double skew = 0) {
    return make_net({.ground = takes(MatrixClass::symmetric) ? -50 : 0.1, .skew = skew});
  }
  static FactorStatus factorise_dense(const Rows& rows) {
    const TestMatrix matrix = make_dense(rows);
    const auto factorisation = make();
    factorisation->analyse(matrix.pattern);
    return factorisation->factorise(matrix.value).status;
  }
};

TEST_P(EveryFactorisation, SolvesThreeEquationsAsByHand) {
  struct System {
    MatrixClass kind;
    Rows rows;
    std::vector<double> b;
  };
  const System systems[] = {{MatrixClass::positive_definite, {{4, 2, 0}, {2, 5, 3}, {0, 3, 10}}, {8, 21, 36}},
                            {MatrixClass::symmetric, {{4, 2, 0}, {2, -5, 3}, {0, 3, 10}}, {8, 1, 36}},
                            {MatrixClass::unsymmetric, {{4, 2, 0}, {-2, 5, 3}, {0, 1, 10}}, {8, 17, 32}}};
  for (const auto& [kind, rows, b] : systems) {
    if (!takes(kind)) continue;
    const TestMatrix matrix = make_dense(rows);
    const auto factorisation = make();
    factorisation->analyse(matrix.pattern);
    ASSERT_EQ(factorisation->factorise(matrix.value).status, FactorStatus::ok);
    std::vector<double> x(3);
    factorisation->solve(b, x);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(x[i], i + 1, 1e-14);
  }
}

TEST_P(EveryFactorisation, SolvesNetsOfTrianglesAndOfSquares) {
  for (const bool diagonals : {true, false})
    EXPECT_LT(error_of_solving(*make(), make_net({.diagonals = diagonals})), kRoundOff);
}

TEST_P(EveryFactorisation, SolvesANetWithDragWithEachOrdering) {
  const TestMatrix net = make_net({.ground = 10, .skew = 3});
  for (const OrderingMethod method : kOrderings) EXPECT_LT(error_of_solving(*make(method), net), kRoundOff);
}

TEST_P(EveryFactorisation, SolvesTheHardestNetItTakesWithEachOrdering) {
  const TestMatrix net = make_hardest_net();
  for (const OrderingMethod method : kOrderings) EXPECT_LT(error_of_solving(*make(method), net), kRoundOff);
}

TEST_P(EveryFactorisation, SolvesWithFixedUnknowns) {
  const TestMatrix net = make_net({.skew = 1, .is_fixed = [](int node, int axis) {
                                     return node < 20 || (node % 5 == 0 && axis == 1) || node % 17 == 0;
                                   }});
  EXPECT_LT(error_of_solving(*make(), net), kRoundOff);
}

TEST_P(EveryFactorisation, SolvesInPlace) {
  const TestMatrix net = make_net({.skew = 1});
  const auto factorisation = make();
  const std::vector<double> apart = solve(*factorisation, net);
  std::vector<double> in_place = made_up_vector(net.pattern.size);
  factorisation->solve(in_place, in_place);
  EXPECT_EQ(apart, in_place);
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

TEST_P(EveryFactorisation, SolvesTheTransposedEquations) {
  for (const TestMatrix& net : {make_net({.ground = 10, .skew = 3}), make_hardest_net(1)}) {
    const auto factorisation = make();
    factorisation->analyse(net.pattern);
    ASSERT_EQ(factorisation->factorise(net.value).status, FactorStatus::ok);
    const std::vector<double> b = made_up_vector(net.pattern.size);
    std::vector<double> c(b.size(), 1.0), x(b.size()), y = c;
    factorisation->solve_transposed(y, y);  // the first solve after a factorisation, in place
    factorisation->solve(b, x);
    // y·b = y·(A x) = (Aᵀ y)·x = c·x
    EXPECT_NEAR(dot(y, b), dot(c, x), 1e-11 * std::sqrt(dot(c, c) * dot(x, x)));
    EXPECT_LT(net.transposed().backward_error(y, c), kRoundOff);
  }
}

TEST_P(EveryFactorisation, ReadsValuesWhereThePatternSaysThatTheyStand) {
  TestMatrix net = make_net({.skew = 1});
  const auto x = solve(*make(), net);
  const std::size_t entries = net.pattern.entries();
  net.pattern.slots = entries + 1;  // values in reverse order, after one that is not used
  std::vector<double> moved(entries + 1, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t e = 0; e < entries; ++e) {
    net.pattern.slot.push_back(static_cast<std::int32_t>(entries - e));
    moved[entries - e] = net.value[e];
  }
  net.value = moved;
  EXPECT_EQ(solve(*make(), net), x);
}

TEST_P(EveryFactorisation, ManagesNoUnknownAndOne) {
  const auto factorisation = make();
  const TestMatrix nothing = make_dense({});
  factorisation->analyse(nothing.pattern);
  EXPECT_EQ(factorisation->factorise(nothing.value).status, FactorStatus::ok);
  factorisation->solve({}, {});
  factorisation->solve_transposed({}, {});

  const double a = takes(MatrixClass::symmetric) ? -4 : 4;
  const TestMatrix one = make_dense({{a}});
  factorisation->analyse(one.pattern);
  ASSERT_EQ(factorisation->factorise(one.value).status, FactorStatus::ok);
  std::vector<double> x{2};
  factorisation->solve(x, x);
  EXPECT_DOUBLE_EQ(x[0], 2 / a);
}

TEST_P(EveryFactorisation, NamesTheUnknownWithoutStiffness) {
  // The bars have no stiffness: in any order, every pivot is the stiffness of the ground.
  const TestMatrix net = make_net({.axial = 0, .geometric = 0});
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  for (const std::int32_t unknown : {0, 17, 600, net.pattern.size - 1}) {
    TestMatrix broken = net;
    for (std::int32_t e = net.pattern.column_start[unknown]; e < net.pattern.column_start[unknown + 1]; ++e)
      broken.value[e] = 0;
    const FactorResult result = factorisation->factorise(broken.value);
    EXPECT_EQ(result.status, singular());
    EXPECT_EQ(result.column, unknown);
  }
}

TEST_P(EveryFactorisation, ReportsEqualRowsAsSingular) {
  EXPECT_EQ(factorise_dense({{1, 1}, {1, 1}}), singular());
  if (takes(MatrixClass::unsymmetric)) {
    EXPECT_EQ(factorise_dense({{1, 2}, {1, 2}}), singular());
  }
}

TEST_P(EveryFactorisation, RefusesValuesThatAreNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const TestMatrix net = make_net();
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    TestMatrix broken = net;
    broken.value[net.pattern.column_start[42]] = bad;
    const FactorResult result = factorisation->factorise(broken.value);
    EXPECT_EQ(result.status, FactorStatus::failed);
    EXPECT_EQ(result.column, 42);
  }
}

TEST_P(EveryFactorisation, GoesOnAfterAFailureAndWithNewValues) {
  const TestMatrix net = make_net({.skew = 1}), other = make_net({.axial = 1e6, .ground = 7, .skew = -2});
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  const std::vector<double> zeros(net.value.size(), 0);
  ASSERT_EQ(factorisation->factorise(zeros).status, singular());
  EXPECT_LT(error_of_solving_again(*factorisation, net), kRoundOff);
  ASSERT_EQ(factorisation->factorise(zeros).status, singular());
  EXPECT_LT(error_of_solving_again(*factorisation, other), kRoundOff);
  EXPECT_LT(error_of_solving(*factorisation, net), kRoundOff);
}

TEST_P(EveryFactorisation, GivesTheSameBitsEveryTime) {
  const TestMatrix net = make_hardest_net(1);
  const auto first = make();
  const auto x = solve(*first, net);
  EXPECT_EQ(solve_again(*first, net), x);
  EXPECT_EQ(solve(*make(), net), x);
}

INSTANTIATE_TEST_SUITE_P(Solvers, EveryFactorisation, testing::ValuesIn(all_factorisations()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace netloft
