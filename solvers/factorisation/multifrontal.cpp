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
#include "solvers/factorisation/front_kernels.hpp"
#include "solvers/factorisation/front_schedule.hpp"
#include "solvers/factorisation/shared_front.hpp"

namespace netloft {
namespace {

constexpr double kLeastPivot = 1e-8;    // relative to the norm of the columns of L
constexpr double kLargestError = 1e-9;  // (2); a larger error is handed over to another code
// Below this [floating-point operations] a factorisation takes less than 5 ms, and threads would gain little.
constexpr double kWorthThreads = 2e8;
constexpr double kErrorToRefine = 1e-12;  // (2); a smaller error is not refined

/// Uninitialised doubles that begin at a cache line.
class Room {
 public:
  void resize(std::size_t count) {
    all_.reset();
    all_.reset(new double[count + kLine]);
    void* begin = all_.get();
    std::size_t bytes = (count + kLine) * sizeof(double);
    begin_ = static_cast<double*>(std::align(kLine * sizeof(double), count * sizeof(double), begin, bytes));
  }
  void clear() { all_.reset(), begin_ = nullptr; }
  bool is_empty() const { return begin_ == nullptr; }
  double* at(std::size_t i) { return begin_ + i; }

 private:
  static constexpr std::size_t kLine = 8;
  std::unique_ptr<double[]> all_;
  double* begin_ = nullptr;
};

class MultifrontalFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  MultifrontalFactorisation(MakeSpare make_spare, OrderingMethod method, int threads)
      : make_spare_(std::move(make_spare)), method_(method), threads_(threads) {}

  std::string description() const override;
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  double factor_entries() const override { return tree_.entries; }
  double factor_flops() const override { return tree_.flops; }
  double factor_bytes() const override;

 private:
  enum class State { none, own, spare };

  void forget_room();
  void make_room();
  bool has_room();
  bool take(std::span<const double> values);
  Elimination eliminate_all(std::size_t& front);
  Elimination eliminate_branches(std::size_t& failed);
  Elimination eliminate(std::size_t front, bool together);
  FrontPanels panels_of(std::size_t front);
  double* update_of(std::size_t front);
  void set_entries(std::size_t front);
  ChildUpdate left_by(std::size_t child);
  FactorResult hand_over();
  void solve_alone(std::span<double> x);
  void forward(std::size_t front);
  void backward(std::size_t front);
  double find_residual(std::span<const double> x, std::span<const double> rhs);
  void check(std::span<double> x);

  MakeSpare make_spare_;
  OrderingMethod method_;
  const SparsePattern* pattern_ = nullptr;
  FrontTree tree_;
  int threads_;
  std::unique_ptr<Workers> workers_;  // null: one thread
  FrontSchedule schedule_;
  std::vector<Elimination> ends_;  // of branches
  const FrontKernels& kernels_ = front_kernels();
  const MatrixKernels& matrix_kernels_ = matrix_kernels();
  std::vector<double> values_;  // by slots
  Room panels_, updates_[2];
  std::vector<std::int32_t> exchanged_;  // rows, by place
  std::vector<double> by_place_, of_front_, rhs_, residual_, products_, sizes_;
  SparsePattern spare_pattern_;  // without slots
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
  forget_room();
  tree_ = pattern.size > 0 ? make_front_tree(pattern, method_) : FrontTree{};
  if (threads_ < 2 || tree_.flops < kWorthThreads)
    workers_.reset();
  else if (!workers_)
    workers_ = std::make_unique<Workers>(threads_);
  schedule_ =
      pattern.size > 0 ? make_front_schedule(tree_, workers_ ? workers_->size() : 1) : FrontSchedule{};
  ends_.resize(schedule_.branches.size());
  pattern_ = &pattern;
}

void MultifrontalFactorisation::forget_room() {
  panels_.clear();
  for (Room& updates : updates_) updates.clear();
}

void MultifrontalFactorisation::make_room() {
  const auto size = static_cast<std::size_t>(pattern_->size);
  for (int parity : {0, 1}) updates_[parity].resize(schedule_.room[parity]);
  values_.resize(pattern_->value_slots()), exchanged_.resize(size);
  for (auto* v : {&by_place_, &rhs_, &residual_}) v->resize(size);
  for (auto* v : {&products_, &sizes_}) v->resize(3 * size);
  of_front_.assign(static_cast<std::size_t>(tree_.most_unknowns) + kTileRows, 0.0);
  panels_.resize(tree_.panels);
}

/// What make_room() makes.
double MultifrontalFactorisation::factor_bytes() const {
  if (!pattern_) return 0;
  const std::size_t doubles = tree_.panels + schedule_.room[0] + schedule_.room[1] + pattern_->value_slots() +
                              9 * static_cast<std::size_t>(pattern_->size);
  return static_cast<double>(doubles * sizeof(double) +
                             static_cast<std::size_t>(pattern_->size) * sizeof(std::int32_t));
}

bool MultifrontalFactorisation::has_room() {
  try {
    if (panels_.is_empty()) make_room();
    return true;
  } catch (const std::bad_alloc&) {
    forget_room();
    return false;
  }
}

FactorResult MultifrontalFactorisation::factorise(std::span<const double> values) {
  assert(pattern_ != nullptr && values.size() == pattern_->value_slots());
  state_ = State::none, is_checked_ = false;
  if (pattern_->size > 0) {
    if (!has_room()) return {FactorStatus::out_of_memory};
    if (!take(values)) return {FactorStatus::failed, find_column_not_finite(*pattern_, values)};
    std::size_t front = 0;
    const Elimination e = eliminate_all(front);
    if (e.column_is_zero)
      return {FactorStatus::singular, tree_.unknown[tree_.fronts[front].first + e.stopped_at]};
    if (e.stopped_at >= 0) return hand_over();
  }
  state_ = State::own;
  return {};
}

/// Takes the values. Returns false if some are not finite; values of unused slots do not count.
bool MultifrontalFactorisation::take(std::span<const double> values) {
  return matrix_kernels_.take(values.first(values_.size()), values_.data()) ||
         find_column_not_finite(*pattern_, values) < 0;
}

/// Of several fronts that cannot be eliminated the first is reported, as one thread would meet it.
Elimination MultifrontalFactorisation::eliminate_all(std::size_t& front) {
  std::size_t failed = tree_.fronts.size();
  const Elimination e = eliminate_branches(failed);
  for (const std::size_t f : schedule_.trunk) {
    if (f > failed) break;
    if (const Elimination own = eliminate(f, workers_ != nullptr); own.stopped_at >= 0) {
      front = f;
      return own;
    }
  }
  front = failed;
  return e;
}

/// `failed` becomes the first front that cannot be eliminated, if there is one. All before it are.
Elimination MultifrontalFactorisation::eliminate_branches(std::size_t& failed) {
  if (schedule_.branches.empty()) return {};
  std::atomic<std::size_t> first{failed};
  workers_->run(schedule_.branches.size(), 2, [&](std::size_t, std::size_t b) {
    ends_[b] = {};
    for (std::size_t f = schedule_.branches[b].first; f < schedule_.branches[b].last && f < first; ++f) {
      if ((ends_[b] = eliminate(f, false)).stopped_at < 0) continue;
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

FrontPanels MultifrontalFactorisation::panels_of(std::size_t front) {
  const Front& f = tree_.fronts[front];
  double* left = panels_.at(f.panels);
  return {f.pivots, f.others, left, left + f.pivots * left_stride(f.pivots, f.others)};
}

double* MultifrontalFactorisation::update_of(std::size_t front) {
  return updates_[schedule_.parity[front]].at(schedule_.update[front]);
}

/// By this thread alone, or by all threads `together`.
Elimination MultifrontalFactorisation::eliminate(std::size_t front, bool together) {
  const Front& f = tree_.fronts[front];
  const FrontPanels panels = panels_of(front);
  double* update = update_of(front);
  std::fill(panels_.at(f.panels), panels_.at(tree_.fronts[front + 1].panels), 0.0);
  std::fill_n(update, f.others * upper_stride(f.others), 0.0);
  set_entries(front);
  for (std::int32_t c = tree_.child_start[front]; c < tree_.child_start[front + 1]; ++c)
    matrix_kernels_.add_child(left_by(static_cast<std::size_t>(tree_.child[c])), panels, update);
  std::int32_t* exchanged = exchanged_.data() + f.first;
  const Elimination e = together ? eliminate_together(kernels_, panels, kLeastPivot, exchanged, *workers_)
                                 : kernels_.eliminate(panels, kLeastPivot, exchanged);
  if (e.stopped_at < 0)
    together ? update_together(kernels_, panels, update, *workers_) : kernels_.update(panels, update);
  return e;
}

/// Sets the entries of the matrix; nothing has been added at these places yet.
void MultifrontalFactorisation::set_entries(std::size_t front) {
  double* panels = panels_.at(tree_.fronts[front].panels);
  for (std::size_t k = tree_.fronts[front].entries; k < tree_.fronts[front + 1].entries; ++k) {
    const FrontEntries& entries = tree_.of_matrix[k];
    const double* from = values_.data() + entries.slot;
    double* to = panels + entries.target;
    to[0] = from[0];
    if (entries.size == 1) continue;
    const std::ptrdiff_t down = entries.down, across = entries.across;
    to[across] = from[1], to[2 * across] = from[2];
    to += down;
    to[0] = from[3], to[across] = from[4], to[2 * across] = from[5];
    to += down;
    to[0] = from[6], to[across] = from[7], to[2 * across] = from[8];
  }
}

/// The update of a child in the sum (1) of the tree.
ChildUpdate MultifrontalFactorisation::left_by(std::size_t child) {
  const Front &front = tree_.fronts[child], &next = tree_.fronts[child + 1];
  return {update_of(child), front.others, {tree_.runs.data() + front.runs, next.runs - front.runs}};
}

/// Factorises the same values with the fallback code.
FactorResult MultifrontalFactorisation::hand_over() {
  if (!spare_) {
    spare_pattern_ = *pattern_;
    spare_pattern_.slot.clear();
    spare_ = make_spare_();
    spare_->analyse(spare_pattern_);
  }
  spare_values_.resize(pattern_->entries());
  for (std::size_t e = 0; e < spare_values_.size(); ++e) spare_values_[e] = values_[pattern_->slot_of(e)];
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

void MultifrontalFactorisation::solve_alone(std::span<double> x) {
  for (std::size_t k = 0; k < by_place_.size(); ++k) by_place_[k] = x[tree_.unknown[k]];
  const std::size_t fronts = tree_.fronts.size() - 1;
  for (std::size_t front = 0; front < fronts; ++front) forward(front);
  for (std::size_t front = fronts; front-- > 0;) backward(front);
  for (std::size_t k = 0; k < by_place_.size(); ++k) x[tree_.unknown[k]] = by_place_[k];
}

void MultifrontalFactorisation::forward(std::size_t front) {
  const Front& f = tree_.fronts[front];
  double *own = by_place_.data() + f.first, *y = of_front_.data();
  const std::int32_t *exchanged = exchanged_.data() + f.first, *other = tree_.other.data() + f.indices;
  for (std::int32_t k = 0; k < f.pivots; ++k) std::swap(own[k], own[exchanged[k]]);
  std::copy_n(own, f.pivots, y);
  std::fill_n(y + f.pivots, f.others, 0.0);
  kernels_.forward(panels_of(front), y);
  std::copy_n(y, f.pivots, own);
  for (std::int32_t i = 0; i < f.others; ++i) by_place_[other[i]] += y[f.pivots + i];
}

void MultifrontalFactorisation::backward(std::size_t front) {
  const Front& f = tree_.fronts[front];
  double *own = by_place_.data() + f.first, *y = of_front_.data();
  const std::int32_t* other = tree_.other.data() + f.indices;
  std::copy_n(own, f.pivots, y);
  for (std::int32_t i = 0; i < f.others; ++i) y[f.pivots + i] = by_place_[other[i]];
  kernels_.backward(panels_of(front), y);
  std::copy_n(y, f.pivots, own);
}

/// Computes b − A x, and returns (2).
double MultifrontalFactorisation::find_residual(std::span<const double> x, std::span<const double> rhs) {
  matrix_kernels_.multiply(tree_.matrix, values_.data(), x, products_.data(), sizes_.data());
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
  // If the fallback fails as well, the present result is kept.
  if (!(error <= kLargestError) && hand_over().status == FactorStatus::ok) spare_->solve(rhs_, x);
}

}  // namespace

std::unique_ptr<Factorisation> make_multifrontal_factorisation(MakeSpare make_spare, OrderingMethod method,
                                                               int threads) {
  return std::make_unique<MultifrontalFactorisation>(std::move(make_spare), method, threads);
}

}  // namespace netloft
