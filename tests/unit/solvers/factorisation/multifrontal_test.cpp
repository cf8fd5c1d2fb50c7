// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/multifrontal.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseLU>
#include <random>

#include "solvers/factorisation/foreseen_memory.hpp"
#include "tests/unit/solvers/factorisation/solving.hpp"

namespace netloft {
namespace {

/// Eigen's L U as the spare factorisation, which counts how often it is used.
class Spare final : public Factorisation {
 public:
  explicit Spare(int& asked) : asked_(asked) {}
  std::string description() const override { return "SparseLU"; }
  void analyse(const SparsePattern& pattern) override { pattern_ = &pattern; }
  FactorResult factorise(std::span<const double> values) override {
    ++asked_;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int32_t c = 0; c < pattern_->size; ++c)
      for (std::int32_t e = pattern_->column_start[c]; e < pattern_->column_start[c + 1]; ++e)
        entries.emplace_back(pattern_->row[e], c, values[e]);
    Eigen::SparseMatrix<double> matrix(pattern_->size, pattern_->size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factors_.compute(matrix);
    return {factors_.info() == Eigen::Success ? FactorStatus::ok : FactorStatus::singular};
  }
  void solve(std::span<const double> rhs, std::span<double> x) override {
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(rhs.data(), pattern_->size);
    Eigen::Map<Eigen::VectorXd>(x.data(), pattern_->size) = factors_.solve(b);
  }
  void solve_transposed(std::span<const double> rhs, std::span<double> x) override {
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(rhs.data(), pattern_->size);
    Eigen::Map<Eigen::VectorXd>(x.data(), pattern_->size) = factors_.transpose().solve(b);
  }

 private:
  int& asked_;
  const SparsePattern* pattern_ = nullptr;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors_;
};

class Multifrontal : public testing::Test {
 protected:
  std::unique_ptr<Factorisation> make(OrderingMethod method = OrderingMethod::best, int threads = 1) {
    return make_multifrontal_factorisation([this] { return std::make_unique<Spare>(handed_over_); }, method,
                                           threads);
  }
  int handed_over_ = 0;
};

/// The pattern of a net with random values and the given diagonal.
TestMatrix make_random_matrix(NetOptions options, unsigned seed, double diagonal) {
  options.symmetric = false;
  TestMatrix matrix = make_net_matrix(options);
  std::mt19937 random(seed);
  for (std::int32_t c = 0; c < matrix.pattern.size; ++c)
    for (std::int32_t e = matrix.pattern.column_start[c]; e < matrix.pattern.column_start[c + 1]; ++e)
      matrix.value[e] =
          static_cast<double>(random()) / 0x1p31 - 1 + (matrix.pattern.row[e] == c ? diagonal : 0);
  return matrix;
}

TEST_F(Multifrontal, SolvesRandomMatricesAsADenseFactorisationDoes) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const int rings = 2 + static_cast<int>(seed % 7), around = 3 + static_cast<int>(seed % 5);
    const TestMatrix m =
        make_random_matrix({.rings = rings, .nodes_per_ring = around, .diagonals = seed % 2 == 0}, seed, 8);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(m.pattern.size, m.pattern.size);
    for (std::int32_t c = 0; c < m.pattern.size; ++c)
      for (std::int32_t e = m.pattern.column_start[c]; e < m.pattern.column_start[c + 1]; ++e)
        dense(m.pattern.row[e], c) = m.value[e];
    const auto b = made_up_vector(m.pattern.size);
    const Eigen::VectorXd expected =
        dense.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(b.data(), dense.rows()));
    const auto x = solve(*make(), m);
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(x.data(), dense.rows()) - expected).norm(),
              1e-11 * expected.norm())
        << seed;
  }
  EXPECT_EQ(handed_over_, 0);
}

TEST_F(Multifrontal, SolvesNetsAloneWithEachOrderingAndAfterAFailure) {
  const TestMatrix net = make_net_matrix({.symmetric = false, .ground = 10, .skew = 3}),
                   other = make_net_matrix({.symmetric = false, .ground = 7, .skew = -2});
  const std::vector<double> zeros(net.value.size(), 0);
  for (const OrderingMethod method : {OrderingMethod::amd, OrderingMethod::metis, OrderingMethod::best}) {
    const auto factorisation = make(method);
    factorisation->analyse(net.pattern);
    for (const TestMatrix* values : {&net, &other}) {
      EXPECT_EQ(factorisation->factorise(zeros).status, FactorStatus::singular);
      EXPECT_LT(error_of_solving_again(*factorisation, *values), kRoundOff);
    }
  }
  EXPECT_EQ(handed_over_, 0);
}

TEST_F(Multifrontal, SolvesALargeNetAlone) {
  const TestMatrix net = make_net_matrix({.rings = 60, .nodes_per_ring = 60, .symmetric = false, .skew = 3});
  EXPECT_LT(error_of_solving(*make(), net), kRoundOff);
  EXPECT_EQ(handed_over_, 0);
}

// In branches, trunk and shared fronts, every number is computed by the same operations in any thread.
TEST_F(Multifrontal, HasTheSameBitsForAnyNumberOfThreads) {
  const TestMatrix net = make_random_matrix({.rings = 90, .nodes_per_ring = 90}, 1, 30);
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 2, 3, 8}) {
    const auto f = make(OrderingMethod::best, threads);
    f->analyse(net.pattern);
    ASSERT_GT(f->factor_flops(), 2e8) << "too small for several threads";
    for (int again = 0; again < 2; ++again) ASSERT_EQ(f->factorise(net.value).status, FactorStatus::ok);
    std::vector<double> x(static_cast<std::size_t>(net.pattern.size), 1.0);
    f->solve(x, x);
    solutions.push_back(x);
  }
  for (const auto& x : solutions) EXPECT_EQ(x, solutions[0]);
  EXPECT_EQ(handed_over_, 0);
}

// Several threads report the same front as one thread: the first that fails, in any branch.
TEST_F(Multifrontal, FindsTheSameColumnOfZerosForAnyNumberOfThreads) {
  const TestMatrix good = make_random_matrix({.rings = 90, .nodes_per_ring = 90}, 1, 30);
  for (const std::int32_t zero : {0, 5000, 12345, good.pattern.size - 1}) {
    TestMatrix net = good;
    for (std::int32_t c = 0; c < net.pattern.size; ++c)
      for (std::int32_t e = net.pattern.column_start[c]; e < net.pattern.column_start[c + 1]; ++e)
        if (c == zero || net.pattern.row[e] == zero)
          net.value[net.pattern.slot_of(static_cast<std::size_t>(e))] = 0;
    for (const int threads : {1, 3}) {
      const auto f = make(OrderingMethod::best, threads);
      f->analyse(net.pattern);
      const FactorResult result = f->factorise(net.value);
      EXPECT_EQ(result.status, FactorStatus::singular);
      EXPECT_EQ(result.column, zero) << threads;
    }
  }
}

TEST_F(Multifrontal, SolvesPartsThatDoNotHangTogether) {
  const TestMatrix matrix =
      make_dense_matrix({{2, 0, 0, 0}, {0, 1, 3, 0}, {0, 4, 5, 0}, {0, 0, 0, 7}}, false);
  TestMatrix apart = matrix;  // the same without its zeros
  apart.pattern.column_start = {0, 1, 3, 5, 6};
  apart.pattern.row = {0, 1, 2, 1, 2, 3};
  apart.value = {2, 1, 4, 3, 5, 7};
  EXPECT_LT(error_of_solving(*make(), matrix), kRoundOff);
  EXPECT_LT(error_of_solving(*make(), apart), kRoundOff);
}

TEST_F(Multifrontal, SolvesAPatternThatIsNotSymmetric) {
  TestMatrix matrix;  // [1 2 0; 0 3 0; 4 0 5]
  matrix.pattern.size = 3, matrix.pattern.symmetric = false, matrix.pattern.node = {0, 1, 2};
  matrix.pattern.column_start = {0, 2, 4, 5};
  matrix.pattern.row = {0, 2, 0, 1, 2};
  matrix.value = {1, 4, 2, 3, 5};
  EXPECT_LT(error_of_solving(*make(), matrix), kRoundOff);
}

/// Multiplies the diagonal blocks of a matrix, one block per node, by `factor`.
TestMatrix with_own_blocks(TestMatrix matrix, double factor) {
  for (std::int32_t c = 0; c < matrix.pattern.size; ++c)
    for (std::int32_t e = matrix.pattern.column_start[c]; e < matrix.pattern.column_start[c + 1]; ++e)
      if (matrix.pattern.node[matrix.pattern.row[e]] == matrix.pattern.node[c]) matrix.value[e] *= factor;
  return matrix;
}

// No diagonal block has a pivot: the pivots are in rows of neighbouring nodes, most of them in other fronts.
TEST_F(Multifrontal, HandsOverWhatNeedsPivotsOfOtherFrontsAndNothingElse) {
  const TestMatrix good = make_random_matrix({.rings = 20, .nodes_per_ring = 20}, 5, 8);
  const TestMatrix poor = with_own_blocks(make_random_matrix({.rings = 20, .nodes_per_ring = 20}, 5, 0), 0);
  const auto factorisation = make();
  factorisation->analyse(good.pattern);
  EXPECT_LT(error_of_solving_again(*factorisation, good), kRoundOff);
  EXPECT_EQ(handed_over_, 0);
  EXPECT_LT(error_of_solving_again(*factorisation, poor), 1e-12);
  EXPECT_EQ(handed_over_, 1);
  EXPECT_LT(error_of_solving_again(*factorisation, good), kRoundOff);
  EXPECT_EQ(handed_over_, 1);
}

// Pivots of 1e-7 in columns with entries of 1 are just accepted, and their errors grow from front to front.
TEST_F(Multifrontal, RefinesOrHandsOverWhatPoorPivotsHaveSpoilt) {
  const TestMatrix net = make_random_matrix({.rings = 40, .nodes_per_ring = 40}, 7, 0);
  for (const double own : {1e-3, 1e-5, 1e-7, 1e-9, 1e-14})
    EXPECT_LT(error_of_solving(*make(), with_own_blocks(net, own)), 1e-9) << own;
  EXPECT_GT(handed_over_, 0);
}

TEST_F(Multifrontal, KnowsTheSizeOfAFactorThatIsDense) {
  const TestMatrix matrix = make_dense_matrix({{4, 1, 1}, {2, 4, 1}, {1, 2, 4}}, false);
  const auto factorisation = make();
  factorisation->analyse(matrix.pattern);
  EXPECT_EQ(factorisation->factor_entries(), 9);  // L without its diagonal of ones, and U
  EXPECT_EQ(factorisation->factor_flops(), 18);   // 2/3 n³
}

// The matrix is only analysed, because its factors would take more than 20 GB.
TEST_F(Multifrontal, LaysOutFactorsOfMoreEntriesThan32BitsCount) {
  const SparsePattern lattice = make_lattice(49, 6, false);
  const auto factorisation = make(OrderingMethod::metis);
  factorisation->analyse(lattice);
  EXPECT_GT(factorisation->factor_entries(), kMostOf32Bits);
  EXPECT_GT(factor_bytes_of(*factorisation), 8 * kMostOf32Bits);
}

TEST_F(Multifrontal, ForeseesTheMemoryOfItsFactors) {
  const TestMatrix net = make_net_matrix({.rings = 100, .nodes_per_ring = 100, .symmetric = false});
  const auto factorisation = make();
  factorisation->analyse(net.pattern);
  const double before = allocated_bytes();
  if (before == 0) GTEST_SKIP() << "this build has a malloc that does not tell what it has given out";
  solve_again(*factorisation, net);
  EXPECT_NEAR(factor_bytes_of(*factorisation), allocated_bytes() - before,
              0.05 * factor_bytes_of(*factorisation));
}

}  // namespace
}  // namespace netloft
