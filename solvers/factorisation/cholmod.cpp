// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/cholmod.hpp"

#include <algorithm>
#include <cassert>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "solvers/factorisation/finite_values.hpp"
#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/memory_pool.hpp"
#include "solvers/factorisation/suitesparse_scope.hpp"

namespace netloft {
namespace {

/// CHOLMOD's functions for indices of 32 bits, and for indices of 64 bits.
template <class Index>
struct Calls;

template <>
struct Calls<std::int32_t> {
  static constexpr int kIndex = CHOLMOD_INT;
  static constexpr const char* kName = "";
  static constexpr auto* analyse = cholmod_analyze_p;
  static constexpr auto* factorise = cholmod_super_numeric;
  static constexpr auto* solve = cholmod_solve2;
  static constexpr auto* free_factor = cholmod_free_factor;
  static constexpr auto* free_dense = cholmod_free_dense;
};

template <>
struct Calls<SuiteSparse_long> {
  static constexpr int kIndex = CHOLMOD_LONG;
  static constexpr const char* kName = ", indices of 64 bits";
  static constexpr auto* analyse = cholmod_l_analyze_p;
  static constexpr auto* factorise = cholmod_l_super_numeric;
  static constexpr auto* solve = cholmod_l_solve2;
  static constexpr auto* free_factor = cholmod_l_free_factor;
  static constexpr auto* free_dense = cholmod_l_free_dense;
};

/// The lower triangle of P A Pᵀ, where the target of each entry of A is computed once. CHOLMOD would permute
/// A in every factorisation, through two transposes and with allocations.
template <class Index>
class PermutedMatrix {
 public:
  void set_up(const SparsePattern& pattern, std::span<const Index> unknown_at);

  void update(std::span<const double> values);

  cholmod_sparse view();

 private:
  std::vector<Index> column_start_, row_;
  std::vector<std::int32_t> source_;  // entry -> the caller's value
  std::vector<double> value_;
};

template <class Index>
void PermutedMatrix<Index>::set_up(const SparsePattern& pattern, std::span<const Index> unknown_at) {
  std::vector<std::int32_t> position(pattern.size);
  for (std::int32_t k = 0; k < pattern.size; ++k) position[unknown_at[k]] = k;

  column_start_.assign(pattern.size + 1, 0);
  const auto for_each_entry = [&](auto&& visit) {
    for (std::int32_t k = 0; k < pattern.size; ++k) {
      const auto column = static_cast<std::int32_t>(unknown_at[k]);
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
  std::vector<Index> next = column_start_;
  for_each_entry([&](std::int32_t e, auto at) {
    row_[next[at.first]] = at.second;
    source_[next[at.first]++] = static_cast<std::int32_t>(pattern.slot_of(static_cast<std::size_t>(e)));
  });
}

template <class Index>
void PermutedMatrix<Index>::update(std::span<const double> values) {
  for (std::size_t e = 0; e < value_.size(); ++e) value_[e] = values[source_[e]];
}

template <class Index>
cholmod_sparse PermutedMatrix<Index>::view() {
  cholmod_sparse view{};
  view.nrow = view.ncol = column_start_.size() - 1;
  view.nzmax = row_.size();
  view.p = column_start_.data();
  view.i = row_.data();
  view.x = value_.data();
  view.stype = -1;
  view.itype = Calls<Index>::kIndex;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.packed = 1;
  return view;
}

/// A pattern in CHOLMOD's form, without values. If the indices have 64 bits, they are copies of those of the
/// pattern; CHOLMOD only reads them.
template <class Index>
class PatternView {
 public:
  explicit PatternView(const SparsePattern& pattern) {
    if constexpr (!std::is_same_v<Index, std::int32_t>) {
      column_start_.assign(pattern.column_start.begin(), pattern.column_start.end());
      row_.assign(pattern.row.begin(), pattern.row.end());
      view_.p = column_start_.data();
      view_.i = row_.data();
    } else {
      view_.p = const_cast<Index*>(pattern.column_start.data());
      view_.i = const_cast<Index*>(pattern.row.data());
    }
    view_.nrow = view_.ncol = static_cast<std::size_t>(pattern.size);
    view_.nzmax = pattern.entries();
    view_.stype = -1;
    view_.itype = Calls<Index>::kIndex;
    view_.xtype = CHOLMOD_PATTERN;
    view_.dtype = CHOLMOD_DOUBLE;
    view_.sorted = view_.packed = 1;
  }
  cholmod_sparse* get() { return &view_; }

 private:
  std::vector<Index> column_start_, row_;
  cholmod_sparse view_{};
};

cholmod_dense view_of(double* x, std::size_t size) {
  cholmod_dense view{};
  view.nrow = view.nzmax = view.d = size;
  view.ncol = 1;
  view.x = x;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

class CholmodFactors {
 public:
  virtual ~CholmodFactors() = default;
  /// Returns false if the factor has more entries than Index can count.
  virtual bool analyse(const SparsePattern& pattern, const NodeOrdering& ordering) = 0;
  virtual const char* name() const = 0;
  virtual FactorResult factorise(std::span<const double> values) = 0;
  virtual void solve(std::span<const double> rhs, std::span<double> x) = 0;
  virtual double bytes() const = 0;
  double entries = 0, flops = 0;
};

template <class Index>
class FactorsOf final : public CholmodFactors {
 public:
  FactorsOf();
  ~FactorsOf() override;

  bool analyse(const SparsePattern& pattern, const NodeOrdering& ordering) override;
  const char* name() const override { return Cholmod::kName; }
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  double bytes() const override;

 private:
  using Cholmod = Calls<Index>;
  FactorResult result_of_last_call() const;

  MemoryPool pool_;
  CholmodCommon common_{Cholmod::kIndex};
  PermutedMatrix<Index> matrix_;
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *workspace_y_ = nullptr, *workspace_e_ = nullptr;  // workspace of cholmod_solve2
};

class CholmodFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  CholmodFactorisation(OrderingMethod method, IndexWidth width) : method_(method), width_(width) {}

  std::string description() const override;
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  double factor_entries() const override { return factors_ ? factors_->entries : 0; }
  double factor_flops() const override { return factors_ ? factors_->flops : 0; }
  double factor_bytes() const override { return factors_ ? factors_->bytes() : 0; }

 private:
  void analyse_unknowns(const SparsePattern& pattern);

  OrderingMethod method_;
  IndexWidth width_;
  const SparsePattern* pattern_ = nullptr;
  std::unique_ptr<CholmodFactors> factors_;  // nullptr for a matrix without unknowns
  bool has_factor_ = false;
  std::string ordering_;
};

/// Neighbouring supernodes are merged into one of n columns in four cases: n ≤ 20; n ≤ 48 with at most a
/// fraction of 0.8 of zeros among its entries; n ≤ 96 with at most 0.2; any n with at most 0.08. With three
/// unknowns per node, larger blocks are better than CHOLMOD's own 4, 16, 48, 0.8, 0.1, 0.05: a factorisation
/// got 20–27 % faster for 10⁴ unknowns, 7 % (triangles) to 23 % (squares) for 10⁵, 6–9 % for 3·10⁵; a solve
/// got 10 % slower. None of seven other sets gains over 5 % on tangents of 10³ to 3·10⁵ unknowns.
void merge_supernodes(cholmod_common& common) {
  constexpr std::size_t kColumns[] = {20, 48, 96};
  constexpr double kZeros[] = {0.8, 0.2, 0.08};
  std::copy(std::begin(kColumns), std::end(kColumns), common.nrelax);
  std::copy(std::begin(kZeros), std::end(kZeros), common.zrelax);
}

/// From 5000 nodes on, `dissection` is tried beside AMD. Below, AMD suffices: supernodal factorisations of
/// nets ordered by AMD take 0.9 to 1.04 times as long as after METIS for 1000 to 4400 nodes (with up to 1.1
/// times the operations), 0.99 to 1.09 times for 6000, and 1.1 to 1.2 times for 16 000; METIS itself takes as
/// long as one or two factorisations. For panels ordered by dissection instead of METIS, the ratio is 0.72
/// (6500 nodes), 0.85 (26 000) and 0.91 (10⁵), with 0.84, 0.88 and 0.94 of the operations.
constexpr LargeNets kLargeNets{5000, OrderingMethod::dissection};

template <class Index>
FactorsOf<Index>::FactorsOf() {
  common_->nmethods = 1;
  common_->method[0].ordering = CHOLMOD_GIVEN;
  common_->supernodal = CHOLMOD_SUPERNODAL;
  common_->final_ll = 1;
  common_->quick_return_if_not_posdef = 1;
  merge_supernodes(*common_.get());
}

template <class Index>
FactorsOf<Index>::~FactorsOf() {
  Cholmod::free_factor(&factor_, common_.get());
  Cholmod::free_dense(&workspace_y_, common_.get());
  Cholmod::free_dense(&workspace_e_, common_.get());
}

template <class Index>
bool FactorsOf<Index>::analyse(const SparsePattern& pattern, const NodeOrdering& ordering) {
  std::vector<Index> order(ordering.unknown.begin(), ordering.unknown.end());
  PatternView<Index> view(pattern);
  factor_ = Cholmod::analyse(view.get(), order.data(), nullptr, 0, common_.get());
  if (factor_ == nullptr && common_->status == CHOLMOD_TOO_LARGE) return false;
  if (factor_ == nullptr) {
    throw std::runtime_error("cannot analyse a matrix of " + std::to_string(pattern.size) +
                             " unknowns: CHOLMOD status " + std::to_string(common_->status));
  }
  entries = common_->lnz;
  flops = common_->fl;
  matrix_.set_up(pattern, {static_cast<const Index*>(factor_->Perm), factor_->n});
  return true;
}

/// Memory [bytes] of the supernodes of L with their zeros, of the largest update and of the workspace of a
/// solve.
template <class Index>
double FactorsOf<Index>::bytes() const {
  const auto n = static_cast<double>(factor_->n);
  return sizeof(double) * (static_cast<double>(factor_->xsize) + static_cast<double>(factor_->maxcsize) +
                           static_cast<double>(factor_->maxesize) + n) +
         5 * n * sizeof(Index);
}

template <class Index>
FactorResult FactorsOf<Index>::result_of_last_call() const {
  // The status must be read now, because a solve with an incomplete factor would reset it to 0.
  switch (common_->status) {
    case CHOLMOD_OK:
      return {FactorStatus::ok, -1, 0};
    case CHOLMOD_NOT_POSDEF:
      return {FactorStatus::not_positive_definite,
              static_cast<std::int32_t>(static_cast<const Index*>(factor_->Perm)[factor_->minor])};
    case CHOLMOD_OUT_OF_MEMORY:
    case CHOLMOD_TOO_LARGE:
      return {FactorStatus::out_of_memory};
    default:
      return {FactorStatus::failed};
  }
}

template <class Index>
FactorResult FactorsOf<Index>::factorise(std::span<const double> values) {
  const MemoryPoolScope pool(pool_);
  matrix_.update(values);
  cholmod_sparse view = matrix_.view();
  double no_shift[2] = {0, 0};
  factor_->minor = factor_->n;
  common_->status = CHOLMOD_OK;
  Cholmod::factorise(&view, nullptr, no_shift, factor_, common_.get());  // (1)
  return result_of_last_call();
}

template <class Index>
void FactorsOf<Index>::solve(std::span<const double> rhs, std::span<double> x) {
  assert(rhs.size() == factor_->n && x.size() == factor_->n);
  // The workspace stays allocated between calls. Therefore it must not come from the memory pool, where it
  // would keep a block that `factorise` has returned and needs again.
  cholmod_dense b = view_of(const_cast<double*>(rhs.data()), rhs.size());  // CHOLMOD only reads b
  cholmod_dense result = view_of(x.data(), x.size());
  cholmod_dense* handle = &result;
  const int solved = Cholmod::solve(CHOLMOD_A, factor_, &b, nullptr, &handle, nullptr, &workspace_y_,
                                    &workspace_e_, common_.get());  // (2)
  if (!solved) throw std::bad_alloc();
  assert(handle == &result);
}

std::string CholmodFactorisation::description() const {
  int version[3];
  cholmod_version(version);
  std::string text = "CHOLMOD supernodal LLT " + std::to_string(version[0]) + "." +
                     std::to_string(version[1]) + "." + std::to_string(version[2]);
  if (factors_) text += factors_->name();
  return ordering_.empty() ? text : text + ", " + ordering_ + " on the node graph";
}

void CholmodFactorisation::analyse(const SparsePattern& pattern) {
  assert(pattern.symmetric);
  const SingleThreadScope single_thread;
  factors_.reset();
  ordering_.clear();
  has_factor_ = false;
  if (pattern.size > 0) analyse_unknowns(pattern);
  pattern_ = &pattern;
}

void CholmodFactorisation::analyse_unknowns(const SparsePattern& pattern) {
  const NodeOrdering ordering = order_nodes(pattern, method_, kLargeNets);
  if (width_ == IndexWidth::as_needed) factors_ = std::make_unique<FactorsOf<std::int32_t>>();
  if (!factors_ || !factors_->analyse(pattern, ordering)) {
    factors_ = std::make_unique<FactorsOf<SuiteSparse_long>>();
    if (!factors_->analyse(pattern, ordering))
      throw std::runtime_error(
          "the matrix has more entries than CHOLMOD has indices for; a coarser mesh has fewer");
  }
  ordering_ = ordering.method;
}

FactorResult CholmodFactorisation::factorise(std::span<const double> values) {
  assert(pattern_ != nullptr && values.size() == pattern_->value_slots());
  const SingleThreadScope single_thread;
  has_factor_ = false;
  if (factors_) {
    if (const std::int32_t column = find_column_not_finite(*pattern_, values); column >= 0) {
      return {FactorStatus::failed, column};
    }
    if (const FactorResult result = factors_->factorise(values); result.status != FactorStatus::ok)
      return result;
  }
  has_factor_ = true;
  return {FactorStatus::ok, -1, 0};
}

void CholmodFactorisation::solve(std::span<const double> rhs, std::span<double> x) {
  assert(has_factor_);
  if (!factors_) return;
  const SingleThreadScope single_thread;
  factors_->solve(rhs, x);
}

}  // namespace

std::unique_ptr<Factorisation> make_cholmod_factorisation(OrderingMethod method) {
  return make_cholmod_factorisation_of(IndexWidth::as_needed, method);
}

std::unique_ptr<Factorisation> make_cholmod_factorisation_of(IndexWidth width, OrderingMethod method) {
  return std::make_unique<CholmodFactorisation>(method, width);
}

}  // namespace netloft
