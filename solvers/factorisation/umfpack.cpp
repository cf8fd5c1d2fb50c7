// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/umfpack.hpp"

#include <umfpack.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/factorisation/finite_values.hpp"
#include "solvers/factorisation/memory_pool.hpp"
#include "solvers/factorisation/suitesparse_scope.hpp"

namespace netloft {
namespace {

class UmfpackFactorisation final : public Factorisation {
 public:
  explicit UmfpackFactorisation(OrderingMethod method);
  ~UmfpackFactorisation() override;

  std::string description() const override;
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  double factor_entries() const override { return entries_; }
  double factor_flops() const override { return flops_; }

 private:
  void analyse_unknowns(const SparsePattern& pattern);
  void free_numeric() { umfpack_dl_free_numeric(&numeric_); }
  FactorResult failure(SuiteSparse_long status);
  std::int32_t find_zero_pivot();

  OrderingMethod method_;
  MemoryPool pool_;
  double control_[UMFPACK_CONTROL];
  const SparsePattern* pattern_ = nullptr;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  std::vector<double> rhs_;        // a copy, because UMFPACK needs separate rhs and x
  std::vector<double> workspace_;  // workspace of umfpack_dl_wsolve
  std::vector<double> gathered_;   // values in the order of the entries
  std::vector<SuiteSparse_long> column_start_, row_, index_workspace_;
  std::string ordering_;
  double entries_ = 0, flops_ = 0;
};

UmfpackFactorisation::UmfpackFactorisation(OrderingMethod method) : method_(method) {
  umfpack_dl_defaults(control_);
  control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  control_[UMFPACK_IRSTEP] = 0;
  control_[UMFPACK_PRL] = 0;
}

UmfpackFactorisation::~UmfpackFactorisation() {
  free_numeric();
  umfpack_dl_free_symbolic(&symbolic_);
}

std::string UmfpackFactorisation::description() const {
  const std::string text = "UMFPACK LU " + std::to_string(UMFPACK_MAIN_VERSION) + "." +
                           std::to_string(UMFPACK_SUB_VERSION) + "." + std::to_string(UMFPACK_SUBSUB_VERSION);
  return ordering_.empty() ? text : text + ", " + ordering_ + " on the node graph";
}

void UmfpackFactorisation::analyse(const SparsePattern& pattern) {
  assert(!pattern.symmetric);
  const SingleThreadScope single_thread;
  free_numeric();
  umfpack_dl_free_symbolic(&symbolic_);
  pool_.clear();
  pattern_ = nullptr;
  ordering_.clear();
  entries_ = flops_ = 0;
  if (pattern.size > 0) analyse_unknowns(pattern);
  pattern_ = &pattern;
}

void UmfpackFactorisation::analyse_unknowns(const SparsePattern& pattern) {
  const NodeOrdering ordering = order_nodes(pattern, method_);
  ordering_ = ordering.method;
  const std::vector<SuiteSparse_long> order(ordering.unknown.begin(), ordering.unknown.end());
  column_start_.assign(pattern.column_start.begin(), pattern.column_start.end());
  row_.assign(pattern.row.begin(), pattern.row.end());
  const auto status = umfpack_dl_qsymbolic(pattern.size, pattern.size, column_start_.data(), row_.data(),
                                           nullptr, order.data(), &symbolic_, control_, nullptr);
  if (status != UMFPACK_OK) {
    throw std::runtime_error("cannot analyse a matrix of " + std::to_string(pattern.size) +
                             " unknowns: UMFPACK status " + std::to_string(status));
  }
  rhs_.resize(pattern.size);
  workspace_.resize(pattern.size);
  index_workspace_.resize(pattern.size);
}

FactorResult UmfpackFactorisation::factorise(std::span<const double> values) {
  assert(pattern_ != nullptr && values.size() == pattern_->value_slots());
  const SingleThreadScope single_thread;
  const MemoryPoolScope pool(pool_);
  free_numeric();
  if (pattern_->size == 0) return {};
  if (const std::int32_t column = find_column_not_finite(*pattern_, values); column >= 0) {
    return {FactorStatus::failed, column};
  }

  if (!pattern_->slot.empty()) {
    gathered_.resize(pattern_->entries());
    for (std::size_t e = 0; e < gathered_.size(); ++e) gathered_[e] = values[pattern_->slot_of(e)];
    values = gathered_;
  }
  double info[UMFPACK_INFO];
  const auto status = umfpack_dl_numeric(column_start_.data(), row_.data(), values.data(), symbolic_,
                                         &numeric_, control_, info);  // (1)
  if (status != UMFPACK_OK) return failure(status);
  entries_ = info[UMFPACK_LNZ] + info[UMFPACK_UNZ];
  flops_ = info[UMFPACK_FLOPS];
  return {};
}

FactorResult UmfpackFactorisation::failure(SuiteSparse_long status) {
  FactorResult result{FactorStatus::failed};
  if (status == UMFPACK_ERROR_out_of_memory) result.status = FactorStatus::out_of_memory;
  if (status == UMFPACK_WARNING_singular_matrix) result = {FactorStatus::singular, find_zero_pivot()};
  free_numeric();
  return result;
}

std::int32_t UmfpackFactorisation::find_zero_pivot() {
  std::vector<SuiteSparse_long>& column_at = index_workspace_;
  std::vector<double>& pivot = workspace_;
  SuiteSparse_long keeps_reciprocals = 0;
  umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, column_at.data(),
                         pivot.data(), &keeps_reciprocals, nullptr, numeric_);
  const auto zero =
      std::find_if(pivot.begin(), pivot.end(), [](double d) { return d == 0 || std::isnan(d); });
  return zero == pivot.end() ? -1 : static_cast<std::int32_t>(column_at[zero - pivot.begin()]);
}

void UmfpackFactorisation::solve(std::span<const double> rhs, std::span<double> x) {
  assert(pattern_ != nullptr);
  if (pattern_->size == 0) return;
  assert(numeric_ != nullptr);
  assert(rhs.size() == rhs_.size() && x.size() == rhs_.size());
  const SingleThreadScope single_thread;
  std::copy(rhs.begin(), rhs.end(), rhs_.begin());
  [[maybe_unused]] const auto status =
      umfpack_dl_wsolve(UMFPACK_A, column_start_.data(), row_.data(), nullptr, x.data(), rhs_.data(),
                        numeric_, control_, nullptr, index_workspace_.data(), workspace_.data());
  assert(status == UMFPACK_OK);
}

}  // namespace

std::unique_ptr<Factorisation> make_umfpack_factorisation(OrderingMethod method) {
  return std::make_unique<UmfpackFactorisation>(method);
}

}  // namespace netloft
