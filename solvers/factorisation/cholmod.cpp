// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/cholmod.hpp"

#include <algorithm>
#include <cassert>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/factorisation/finite_values.hpp"
#include "solvers/factorisation/memory_pool.hpp"
#include "solvers/factorisation/suitesparse_scope.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// The lower triangle of P A Pᵀ. CHOLMOD would permute A in every factorisation, through two transposes and
/// with allocations; here the target of each entry is computed once.
class PermutedMatrix {
 public:
  void set_up(const SparsePattern& pattern, std::span<const std::int32_t> unknown_at);

  void update(std::span<const double> values);

  cholmod_sparse view();

 private:
  Indices column_start_, row_;
  Indices source_;  // entry -> the caller's value
  std::vector<double> value_;
};

void PermutedMatrix::set_up(const SparsePattern& pattern, std::span<const std::int32_t> unknown_at) {
  Indices position(pattern.size);
  for (std::int32_t k = 0; k < pattern.size; ++k) position[unknown_at[k]] = k;

  column_start_.assign(pattern.size + 1, 0);
  const auto for_each_entry = [&](auto&& visit) {
    for (std::int32_t k = 0; k < pattern.size; ++k) {
      const std::int32_t column = unknown_at[k];
      for (std::int32_t e = pattern.column_start[column]; e < pattern.column_start[column + 1]; ++e) {
        visit(e, std::minmax(k, position[pattern.row[e]]));
      }
    }
  };
  for_each_entry([&](std::int32_t, auto at) { ++column_start_[at.first + 1]; });
  std::partial_sum(column_start_.begin(), column_start_.end(), column_start_.begin());

  row_.resize(pattern.entries());
  source_.resize(pattern.entries());
  value_.resize(pattern.entries());
  Indices next = column_start_;
  for_each_entry([&](std::int32_t e, auto at) {
    row_[next[at.first]] = at.second;
    source_[next[at.first]++] = static_cast<std::int32_t>(pattern.slot_of(static_cast<std::size_t>(e)));
  });
}

void PermutedMatrix::update(std::span<const double> values) {
  for (std::size_t e = 0; e < value_.size(); ++e) value_[e] = values[source_[e]];
}

cholmod_sparse PermutedMatrix::view() {
  cholmod_sparse view{};
  view.nrow = view.ncol = column_start_.size() - 1;
  view.nzmax = row_.size();
  view.p = column_start_.data();
  view.i = row_.data();
  view.x = value_.data();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.packed = 1;
  return view;
}

/// A read-only view without values.
cholmod_sparse view_of(const SparsePattern& pattern) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(pattern.size);
  view.nzmax = pattern.entries();
  view.p = const_cast<std::int32_t*>(pattern.column_start.data());
  view.i = const_cast<std::int32_t*>(pattern.row.data());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

cholmod_dense view_of(double* x, std::size_t size) {
  cholmod_dense view{};
  view.nrow = view.nzmax = view.d = size;
  view.ncol = 1;
  view.x = x;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

class CholmodFactorisation final : public Factorisation {
 public:
  explicit CholmodFactorisation(OrderingMethod method);
  ~CholmodFactorisation() override;

  std::string description() const override;
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  double factor_entries() const override { return entries_; }
  double factor_flops() const override { return flops_; }

 private:
  void free_factor();
  void analyse_unknowns(const SparsePattern& pattern);
  FactorResult result_of_last_call() const;

  OrderingMethod method_;
  MemoryPool pool_;
  CholmodCommon common_;
  const SparsePattern* pattern_ = nullptr;
  PermutedMatrix matrix_;
  cholmod_factor* factor_ = nullptr;                               // null for a matrix without unknowns
  cholmod_dense *workspace_y_ = nullptr, *workspace_e_ = nullptr;  // of cholmod_solve2
  bool has_factor_ = false;
  std::string ordering_;
  double entries_ = 0, flops_ = 0;
};

/// Neighbouring supernodes become one of n columns if n ≤ 20, or n ≤ 48 with at most a fraction of 0.8 of
/// zeros, or n ≤ 96 with 0.2, or with 0.08. Three unknowns per node want larger blocks than CHOLMOD's own 4,
/// 16, 48, 0.8, 0.1, 0.05: a factorisation of 10⁴ unknowns got 20–27 % faster, one of 10⁵ 7 % (triangles) to
/// 23 % (squares), one of 3·10⁵ 6–9 %; a solve 10 % slower. Of seven other sets, on tangents of 10³ to 3·10⁵
/// unknowns, none gains more than 5 %.
void merge_supernodes(cholmod_common& common) {
  constexpr std::size_t kColumns[] = {20, 48, 96};
  constexpr double kZeros[] = {0.8, 0.2, 0.08};
  std::copy(std::begin(kColumns), std::end(kColumns), common.nrelax);
  std::copy(std::begin(kZeros), std::end(kZeros), common.zrelax);
}

/// On nets of 1000 to 4400 nodes supernodal factorisations after AMD took 0.9 to 1.04 times as long as after
/// METIS, of up to 1.1 times the operations, and METIS as long as one or two of them; of 6000 nodes 0.99 to
/// 1.09 times as long, of 16 000 1.1 to 1.2 times. After dissection, those of panels took 0.72 (6500 nodes),
/// 0.85 (26 000) and 0.91 (10⁵) of the time after METIS, for 0.84, 0.88 and 0.94 of the operations.
constexpr LargeNets kLargeNets{5000, OrderingMethod::dissection};

CholmodFactorisation::CholmodFactorisation(OrderingMethod method) : method_(method) {
  common_->nmethods = 1;
  common_->method[0].ordering = CHOLMOD_GIVEN;
  common_->supernodal = CHOLMOD_SUPERNODAL;
  common_->final_ll = 1;
  common_->quick_return_if_not_posdef = 1;
  merge_supernodes(*common_.get());
}

CholmodFactorisation::~CholmodFactorisation() { free_factor(); }

void CholmodFactorisation::free_factor() {
  cholmod_free_factor(&factor_, common_.get());
  cholmod_free_dense(&workspace_y_, common_.get());
  cholmod_free_dense(&workspace_e_, common_.get());
  pool_.clear();
  pattern_ = nullptr;
  ordering_.clear();
  entries_ = flops_ = 0;
  has_factor_ = false;
}

std::string CholmodFactorisation::description() const {
  int version[3];
  cholmod_version(version);
  std::string text = "CHOLMOD supernodal LLT " + std::to_string(version[0]) + "." +
                     std::to_string(version[1]) + "." + std::to_string(version[2]);
  return ordering_.empty() ? text : text + ", " + ordering_ + " on the node graph";
}

void CholmodFactorisation::analyse(const SparsePattern& pattern) {
  assert(pattern.symmetric);
  const SingleThreadScope single_thread;
  free_factor();
  if (pattern.size > 0) analyse_unknowns(pattern);
  pattern_ = &pattern;
}

void CholmodFactorisation::analyse_unknowns(const SparsePattern& pattern) {
  NodeOrdering ordering = order_nodes(pattern, method_, kLargeNets);
  ordering_ = ordering.method;
  cholmod_sparse view = view_of(pattern);
  factor_ = cholmod_analyze_p(&view, ordering.unknown.data(), nullptr, 0, common_.get());
  if (factor_ == nullptr) {
    throw std::runtime_error("cannot analyse a matrix of " + std::to_string(pattern.size) +
                             " unknowns: CHOLMOD status " + std::to_string(common_->status));
  }
  entries_ = common_->lnz;
  flops_ = common_->fl;
  matrix_.set_up(pattern, {static_cast<const std::int32_t*>(factor_->Perm), factor_->n});
}

FactorResult CholmodFactorisation::result_of_last_call() const {
  // The status must be read now, because a solve with an incomplete factor would reset it to 0.
  switch (common_->status) {
    case CHOLMOD_OK:
      return {};
    case CHOLMOD_NOT_POSDEF:
      return {FactorStatus::not_positive_definite, static_cast<const int*>(factor_->Perm)[factor_->minor]};
    case CHOLMOD_OUT_OF_MEMORY:
    case CHOLMOD_TOO_LARGE:
      return {FactorStatus::out_of_memory};
    default:
      return {FactorStatus::failed};
  }
}

FactorResult CholmodFactorisation::factorise(std::span<const double> values) {
  assert(pattern_ != nullptr && values.size() == pattern_->value_slots());
  const SingleThreadScope single_thread;
  const MemoryPoolScope pool(pool_);
  has_factor_ = false;
  if (factor_ != nullptr) {
    if (const std::int32_t column = find_column_not_finite(*pattern_, values); column >= 0) {
      return {FactorStatus::failed, column};
    }
    matrix_.update(values);
    cholmod_sparse view = matrix_.view();
    double no_shift[2] = {0, 0};
    factor_->minor = factor_->n;
    common_->status = CHOLMOD_OK;
    cholmod_super_numeric(&view, nullptr, no_shift, factor_, common_.get());  // (1)
    if (const FactorResult result = result_of_last_call(); result.status != FactorStatus::ok) return result;
  }
  has_factor_ = true;
  return {FactorStatus::ok, -1, 0};
}

void CholmodFactorisation::solve(std::span<const double> rhs, std::span<double> x) {
  assert(has_factor_);
  if (factor_ == nullptr) return;
  assert(rhs.size() == factor_->n && x.size() == factor_->n);
  const SingleThreadScope single_thread;
  // No memory pool here: the workspace is kept once it is made, and would occupy a block that `factorise`
  // returns.
  cholmod_dense b = view_of(const_cast<double*>(rhs.data()), rhs.size());  // only read
  cholmod_dense result = view_of(x.data(), x.size());
  cholmod_dense* handle = &result;
  const int solved = cholmod_solve2(CHOLMOD_A, factor_, &b, nullptr, &handle, nullptr, &workspace_y_,
                                    &workspace_e_, common_.get());  // (2)
  if (!solved) throw std::bad_alloc();
  assert(handle == &result);
}

}  // namespace

std::unique_ptr<Factorisation> make_cholmod_factorisation(OrderingMethod method) {
  return std::make_unique<CholmodFactorisation>(method);
}

}  // namespace netloft
