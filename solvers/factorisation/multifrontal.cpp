// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/multifrontal.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "solvers/factorisation/finite_values.hpp"
#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/fronts.hpp"
#include "solvers/factorisation/lower_triangle.hpp"

namespace netloft {
namespace {

constexpr double kLargestError = 1e-9;  // backward error (2) above which the spare factorisation takes over
// Least work [floating-point operations] for several threads. With less, a factorisation takes less than 5
// ms, so that threads gain little.
constexpr double kWorthThreads = 2e8;
constexpr double kErrorToRefine = 1e-12;  // backward error (2) above which a solution is refined
constexpr PivotRule kLargePivots{.least = 1e-8, .positive = false},
    kPositivePivots{.least = 0, .positive = true};

class MultifrontalFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  MultifrontalFactorisation(MakeSpare make_spare, OrderingMethod method, int threads, const PivotRule& rule)
      : make_spare_(std::move(make_spare)), method_(method), threads_(threads), rule_(rule) {}

  std::string description() const override;
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  void solve_transposed(std::span<const double> rhs, std::span<double> x) override;
  double factor_entries() const override { return tree_.entries; }
  double factor_flops() const override { return tree_.flops; }
  double factor_bytes() const override;

 private:
  enum class State { none, own, spare };

  void schedule();
  bool has_room();
  bool take(std::span<const double> values);
  Elimination eliminate_all(std::size_t& front);
  Elimination eliminate_branches(std::size_t& failed);
  FactorResult refuse(std::size_t front, const Elimination& end);
  FactorResult hand_over();
  void solve_alone(std::span<double> x, bool transposed = false);
  double find_residual(std::span<const double> x, std::span<const double> rhs);
  void check(std::span<double> x);

  MakeSpare make_spare_;
  OrderingMethod method_;
  const SparsePattern* pattern_ = nullptr;
  FrontTree tree_;
  int threads_;
  PivotRule rule_;
  std::unique_ptr<Workers> workers_;  // nullptr: one thread
  FrontSchedule schedule_;
  std::vector<Elimination> ends_;  // results of the branches
  const MatrixKernels& matrix_kernels_ = matrix_kernels();
  Fronts fronts_;
  std::vector<double> rhs_, residual_, products_, sizes_;
  SparsePattern spare_pattern_;  // pattern for the spare factorisation, without slots
  std::vector<double> spare_values_;
  std::unique_ptr<Factorisation> spare_;
  State state_ = State::none;
  bool is_checked_ = false;
};

std::string MultifrontalFactorisation::description() const {
  const std::string text = "multifrontal LU";
  return tree_.ordering.empty() ? text : text + ", " + tree_.ordering + " on the node graph";
}

void MultifrontalFactorisation::analyse(const SparsePattern& pattern) {
  assert(!pattern.symmetric);
  state_ = State::none;
  spare_.reset();
  pattern_ = &pattern;
  tree_ = {};
  schedule_ = {};
  if (pattern.size > 0) {
    tree_ = make_front_tree(pattern, method_);
    schedule();
  }
  ends_.resize(schedule_.branches.size());
  fronts_.plan(tree_, schedule_, pattern.value_slots(), rule_);
}

void MultifrontalFactorisation::schedule() {
  if (threads_ < 2 || tree_.flops < kWorthThreads)
    workers_.reset();
  else if (!workers_)
    workers_ = std::make_unique<Workers>(threads_);
  schedule_ = make_front_schedule(tree_, workers_ ? workers_->size() : 1);
}

bool MultifrontalFactorisation::has_room() {
  if (!fronts_.has_room()) return false;
  const auto size = static_cast<std::size_t>(pattern_->size);
  try {
    for (auto* v : {&rhs_, &residual_}) v->resize(size);
    for (auto* v : {&products_, &sizes_}) v->resize(3 * size);
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

double MultifrontalFactorisation::factor_bytes() const {
  if (!pattern_) return 0;
  return fronts_.bytes() + 8.0 * pattern_->size * sizeof(double);
}

FactorResult MultifrontalFactorisation::factorise(std::span<const double> values) {
  assert(pattern_ != nullptr && values.size() == pattern_->value_slots());
  state_ = State::none;
  is_checked_ = rule_.positive;  // elimination with positive pivots is always stable
  if (pattern_->size > 0) {
    if (!has_room()) return {FactorStatus::out_of_memory};
    if (!take(values)) return {FactorStatus::failed, find_column_not_finite(*pattern_, values)};
    std::size_t front = 0;
    const Elimination e = eliminate_all(front);
    if (e.stopped_at >= 0) return refuse(front, e);
  }
  state_ = State::own;
  return {FactorStatus::ok, -1, rule_.positive ? 0 : -1};
}

/// The result if the elimination stopped in a front.
FactorResult MultifrontalFactorisation::refuse(std::size_t front, const Elimination& end) {
  const std::int32_t column = tree_.unknown[tree_.fronts[front].first + end.stopped_at];
  if (rule_.positive) return {FactorStatus::not_positive_definite, column};
  if (end.column_is_zero || !make_spare_) return {FactorStatus::singular, column};
  return hand_over();
}

/// Copies the values. Returns false if some are not finite; unused slots are ignored.
bool MultifrontalFactorisation::take(std::span<const double> values) {
  return matrix_kernels_.take(values.first(fronts_.values().size()), fronts_.values().data()) ||
         find_column_not_finite(*pattern_, values) < 0;
}

/// Eliminates all fronts. If several fronts fail, the first of them in the order of elimination is reported,
/// as with one thread.
Elimination MultifrontalFactorisation::eliminate_all(std::size_t& front) {
  std::size_t failed = tree_.fronts.size();
  const Elimination end = eliminate_branches(failed);
  for (const std::size_t f : schedule_.trunk) {
    if (f > failed) break;
    if (const Elimination own = fronts_.eliminate(f, workers_.get()); own.stopped_at >= 0) {
      front = f;
      return own;
    }
  }
  front = failed;
  return end;
}

/// Eliminates the branches. If fronts cannot be eliminated, `failed` becomes the first of them; all fronts
/// before it are eliminated.
Elimination MultifrontalFactorisation::eliminate_branches(std::size_t& failed) {
  if (schedule_.branches.empty()) return {};
  std::atomic<std::size_t> first{failed};
  workers_->run(ends_.size(), 2, [&](std::size_t, std::size_t b) {
    ends_[b] = {};
    for (std::size_t f = schedule_.branches[b].first; f < schedule_.branches[b].last && f < first; ++f) {
      if ((ends_[b] = fronts_.eliminate(f, nullptr)).stopped_at < 0) continue;
      for (std::size_t known = first; f < known && !first.compare_exchange_weak(known, f);) {
      }
      return;
    }
  });
  failed = first;
  for (std::size_t b = 0; b < ends_.size(); ++b)
    if (schedule_.branches[b].first <= failed && failed < schedule_.branches[b].last) return ends_[b];
  return {};
}

/// Factorises the same values with the spare factorisation.
FactorResult MultifrontalFactorisation::hand_over() {
  if (!spare_) {
    spare_pattern_ = *pattern_;
    spare_pattern_.slot.clear();
    spare_ = make_spare_();
    spare_->analyse(spare_pattern_);
  }
  spare_values_.resize(pattern_->entries());
  for (std::size_t e = 0; e < spare_values_.size(); ++e)
    spare_values_[e] = fronts_.values()[pattern_->slot_of(e)];
  const FactorResult result = spare_->factorise(spare_values_);
  if (result.status == FactorStatus::ok) state_ = State::spare;
  return result;
}

void MultifrontalFactorisation::solve(std::span<const double> rhs, std::span<double> x) {
  assert(state_ != State::none);
  if (pattern_->size == 0) return;
  assert(rhs.size() == static_cast<std::size_t>(pattern_->size) && x.size() == rhs.size());
  if (state_ == State::spare) return spare_->solve(rhs, x);
  if (!is_checked_) std::copy(rhs.begin(), rhs.end(), rhs_.begin());
  if (x.data() != rhs.data()) std::copy(rhs.begin(), rhs.end(), x.begin());
  solve_alone(x);
  if (!is_checked_) check(x);
}

/// The factor is checked first, with the equations that are not transposed.
void MultifrontalFactorisation::solve_transposed(std::span<const double> rhs, std::span<double> x) {
  assert(state_ != State::none);
  if (pattern_->size == 0) return;
  assert(rhs.size() == static_cast<std::size_t>(pattern_->size) && x.size() == rhs.size());
  if (state_ == State::own && !is_checked_) {
    solve(rhs, x);
    rhs = rhs_;  // `x` may be `rhs`
  }
  if (state_ == State::spare) return spare_->solve_transposed(rhs, x);
  if (x.data() != rhs.data()) std::copy(rhs.begin(), rhs.end(), x.begin());
  solve_alone(x, true);
}

void MultifrontalFactorisation::solve_alone(std::span<double> x, bool transposed) {
  const std::span<double> by_place = fronts_.by_place();
  for (std::size_t k = 0; k < by_place.size(); ++k) by_place[k] = x[tree_.unknown[k]];
  const std::size_t fronts = tree_.fronts.size() - 1;
  for (std::size_t f = 0; f < fronts; ++f) transposed ? fronts_.forward_transposed(f) : fronts_.forward(f);
  for (std::size_t f = fronts; f-- > 0;) transposed ? fronts_.backward_transposed(f) : fronts_.backward(f);
  for (std::size_t k = 0; k < by_place.size(); ++k) x[tree_.unknown[k]] = by_place[k];
}

/// Computes the residual b − A x, and returns the backward error (2) of multifrontal.hpp.
double MultifrontalFactorisation::find_residual(std::span<const double> x, std::span<const double> rhs) {
  matrix_kernels_.multiply(tree_.matrix, fronts_.values().data(), x, products_.data(), sizes_.data());
  double error = 0;
  for (std::size_t i = 0; i < rhs.size(); ++i) {
    const double *product = &products_[3 * i], *size = &sizes_[3 * i];
    residual_[i] = rhs[i] - (product[0] + product[1] + product[2]);
    const double sum = std::abs(rhs[i]) + (size[0] + size[1] + size[2]);
    if (!std::isfinite(sum)) return std::numeric_limits<double>::infinity();
    if (std::abs(residual_[i]) > error * sum) error = std::abs(residual_[i]) / sum;
  }
  return error;
}

void MultifrontalFactorisation::check(std::span<double> x) {
  is_checked_ = true;
  double error = find_residual(x, rhs_);
  if (error > kErrorToRefine) {
    solve_alone(residual_);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += residual_[i];
    error = find_residual(x, rhs_);
  }
  // If the spare factorisation fails as well, the present result is kept.
  if (!(error <= kLargestError) && make_spare_ && hand_over().status == FactorStatus::ok)
    spare_->solve(rhs_, x);
}

}  // namespace

std::unique_ptr<Factorisation> make_multifrontal_factorisation(MakeSpare make_spare, OrderingMethod method,
                                                               int threads) {
  return std::make_unique<MultifrontalFactorisation>(std::move(make_spare), method, threads, kLargePivots);
}

std::unique_ptr<Factorisation> make_definite_factorisation(OrderingMethod method, int threads) {
  return make_factorisation_of_lower_triangle(
      std::make_unique<MultifrontalFactorisation>(nullptr, method, threads, kPositivePivots));
}

}  // namespace netloft
