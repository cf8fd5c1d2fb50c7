// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/kept_analyses.hpp"

#include <gtest/gtest.h>

#include "solvers/factorisation/make_factorisation.hpp"

namespace netloft {
namespace {

/// A factorisation that counts the calls of `analyse`.
class Counting final : public Factorisation {
 public:
  Counting(int& analyses, double entries, const FactorStatus& status)
      : analyses_(analyses), entries_(entries), status_(status) {}
  std::string description() const override { return "counting"; }
  void analyse(const SparsePattern&) override { ++analyses_; }
  FactorResult factorise(std::span<const double>) override { return {status_}; }
  void solve(std::span<const double>, std::span<double>) override {}
  void solve_transposed(std::span<const double>, std::span<double>) override {}
  double factor_entries() const override { return entries_; }

 private:
  int& analyses_;
  double entries_;
  const FactorStatus& status_;
};

SparsePattern diagonal(std::int32_t size) {
  SparsePattern pattern;
  pattern.size = size, pattern.symmetric = false;
  for (std::int32_t i = 0; i < size; ++i)
    pattern.column_start.push_back(i), pattern.row.push_back(i), pattern.node.push_back(i / 3);
  pattern.column_start.push_back(size);
  return pattern;
}

struct Kept {
  explicit Kept(double entries = 1)
      : make(keep_analyses([this, entries](MatrixClass) {
          return std::make_unique<Counting>(analyses, entries, status);
        })) {}
  void analyse(std::int32_t size, MatrixClass kind = MatrixClass::unsymmetric) {
    make(kind)->analyse(diagonal(size));
  }
  int analyses = 0;
  FactorStatus status = FactorStatus::ok;
  MakeFactorisation make;
};

TEST(KeptAnalyses, ServeTheNextOneWithAnEqualPattern) {
  Kept kept;
  kept.analyse(6);
  kept.analyse(6);
  EXPECT_EQ(kept.analyses, 1);
}

TEST(KeptAnalyses, DoNotServeAnotherPatternOrClass) {
  Kept kept;
  kept.analyse(6);
  kept.analyse(9);
  kept.analyse(9, MatrixClass::symmetric);
  EXPECT_EQ(kept.analyses, 3);
}

TEST(KeptAnalyses, AreNotTakenFromWhoStillUsesThem) {
  Kept kept;
  const auto first = kept.make(MatrixClass::unsymmetric), second = kept.make(MatrixClass::unsymmetric);
  first->analyse(diagonal(6));
  second->analyse(diagonal(6));
  EXPECT_EQ(kept.analyses, 2);
}

TEST(KeptAnalyses, AreGivenUpWhereTheFactorIsLarge) {
  Kept kept(1e9);
  for (int time = 0; time < 2; ++time) {
    const auto factorisation = kept.make(MatrixClass::unsymmetric);
    factorisation->analyse(diagonal(6));
    factorisation->factorise({});
  }
  EXPECT_EQ(kept.analyses, 2);
}

TEST(KeptAnalyses, AreKeptWhereTheFactorWouldBeLargeAndThereIsNone) {
  Kept kept(1e9);
  kept.analyse(6);
  kept.analyse(6);
  EXPECT_EQ(kept.analyses, 1);
}

// MUMPS may have allocated much memory before it failed.
TEST(KeptAnalyses, AreGivenUpAfterAFactorisationThatFailed) {
  for (const auto& [status, analyses] : {std::pair{FactorStatus::out_of_memory, 2},
                                         {FactorStatus::failed, 2},
                                         {FactorStatus::singular, 2},
                                         {FactorStatus::not_positive_definite, 1},
                                         {FactorStatus::ok, 1}}) {
    Kept kept;
    kept.status = status;
    for (int time = 0; time < 2; ++time) {
      const auto factorisation = kept.make(MatrixClass::unsymmetric);
      factorisation->analyse(diagonal(3));
      EXPECT_EQ(factorisation->factorise({}).status, status);
    }
    EXPECT_EQ(kept.analyses, analyses);
  }
}

TEST(KeptAnalyses, SolveAsFreshOnesDo) {
  const MakeFactorisation make = keep_analyses(make_factorisation);
  std::vector<double> values{2, 4, 8}, x{1, 1, 1};
  for (int time = 0; time < 2; ++time) {
    const auto factorisation = make(MatrixClass::unsymmetric);
    SparsePattern pattern = diagonal(3);  // gone before the next one
    factorisation->analyse(pattern);
    ASSERT_EQ(factorisation->factorise(values).status, FactorStatus::ok);
    factorisation->solve(std::vector<double>{2, 4, 8}, x);
    for (const double one : x) EXPECT_DOUBLE_EQ(one, 1 + time);
    for (double& v : values) v /= 2;
  }
}

}  // namespace
}  // namespace netloft
