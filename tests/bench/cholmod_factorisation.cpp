// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench/cholmod_factorisation.hpp"

#ifdef NETLOFT_BENCH_CHOLMOD
#include <cholmod.h>

#include <algorithm>
#include <string>
#include <vector>

#include "framework/assembler/sparse_pattern.hpp"

namespace netloft {
namespace {

class CholmodFactorisation : public Factorisation {
 public:
  CholmodFactorisation() { cholmod_start(&common_); }
  ~CholmodFactorisation() override {
    drop();
    cholmod_free_sparse(&matrix_, &common_);
    cholmod_finish(&common_);
  }
  CholmodFactorisation(const CholmodFactorisation&) = delete;
  CholmodFactorisation& operator=(const CholmodFactorisation&) = delete;

  std::string description() const override { return "CHOLMOD"; }

  void analyse(const SparsePattern& pattern) override {
    drop();
    cholmod_free_sparse(&matrix_, &common_);
    pattern_ = &pattern;
    const auto n = static_cast<std::size_t>(pattern.size);
    matrix_ = cholmod_allocate_sparse(n, n, pattern.entries(), 1, 1, -1, CHOLMOD_REAL, &common_);
    std::ranges::copy(pattern.column_start, static_cast<std::int32_t*>(matrix_->p));
    std::ranges::copy(pattern.row, static_cast<std::int32_t*>(matrix_->i));
    factor_ = cholmod_analyze(matrix_, &common_);
  }

  FactorResult factorise(std::span<const double> values) override {
    auto* const x = static_cast<double*>(matrix_->x);
    for (std::size_t k = 0; k < pattern_->entries(); ++k) x[k] = values[pattern_->slot_of(k)];
    FactorResult result;
    result.status = cholmod_factorize(matrix_, factor_, &common_) && common_.status == CHOLMOD_OK
                        ? FactorStatus::ok
                        : FactorStatus::singular;
    return result;
  }

  void solve(std::span<const double> rhs, std::span<double> x) override {
    cholmod_dense b{};
    b.nrow = b.nzmax = b.d = rhs.size();
    b.ncol = 1;
    b.x = const_cast<double*>(rhs.data());
    b.xtype = CHOLMOD_REAL;
    cholmod_dense* found = cholmod_solve(CHOLMOD_A, factor_, &b, &common_);
    std::copy_n(static_cast<const double*>(found->x), x.size(), x.begin());
    cholmod_free_dense(&found, &common_);
  }

  void solve_transposed(std::span<const double> rhs, std::span<double> x) override { solve(rhs, x); }

  double factor_entries() const override { return common_.lnz; }
  double factor_flops() const override { return common_.fl; }

 private:
  void drop() { cholmod_free_factor(&factor_, &common_); }

  const SparsePattern* pattern_ = nullptr;
  cholmod_common common_{};
  cholmod_sparse* matrix_ = nullptr;
  cholmod_factor* factor_ = nullptr;
};

}  // namespace

std::unique_ptr<Factorisation> make_cholmod_factorisation() {
  return std::make_unique<CholmodFactorisation>();
}

}  // namespace netloft
#else

namespace netloft {

std::unique_ptr<Factorisation> make_cholmod_factorisation() { return nullptr; }

}  // namespace netloft
#endif
