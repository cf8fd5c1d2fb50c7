// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/fronts.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "solvers/factorisation/shared_front.hpp"

namespace netloft {
namespace {

/// A pivot counts as zero if it is at most this fraction of its diagonal entry in the matrix. A pivot is that
/// entry minus squares: in singular matrices, rounding leaves fractions of up to 1e-14; the smallest fraction
/// in the gear library is above 1e-10.
constexpr double kRoundingOfPivot = 1e-12;

}  // namespace

void Room::resize(std::size_t count) {
  all_.reset();
  all_.reset(new double[count + kLine]);
  void* begin = all_.get();
  std::size_t bytes = (count + kLine) * sizeof(double);
  begin_ = static_cast<double*>(std::align(kLine * sizeof(double), count * sizeof(double), begin, bytes));
}

void Fronts::plan(const FrontTree& tree, const FrontSchedule& schedule, std::size_t values,
                  const PivotRule& rule) {
  forget_room();
  tree_ = &tree;
  schedule_ = &schedule;
  value_count_ = values;
  rule_ = rule;
}

void Fronts::forget_room() {
  panels_.clear();
  for (Room& updates : updates_) updates.clear();
}

void Fronts::make_room() {
  for (int parity : {0, 1}) updates_[parity].resize(schedule_->room[parity]);
  values_.resize(value_count_);
  exchanged_.resize(tree_->unknown.size());
  by_place_.resize(tree_->unknown.size());
  of_front_.assign(static_cast<std::size_t>(tree_->most_unknowns) + kTileRows, 0.0);
  panels_.resize(tree_->panels);
}

double Fronts::bytes() const {
  if (!tree_) return 0;
  const std::size_t unknowns = tree_->unknown.size();
  const std::size_t doubles =
      tree_->panels + schedule_->room[0] + schedule_->room[1] + value_count_ + unknowns;
  return static_cast<double>(doubles * sizeof(double) + unknowns * sizeof(std::int32_t));
}

bool Fronts::has_room() {
  try {
    if (panels_.is_empty()) make_room();
    return true;
  } catch (const std::bad_alloc&) {
    forget_room();
    return false;
  }
}

FrontPanels Fronts::panels_of(std::size_t front) {
  const Front& f = tree_->fronts[front];
  double* left = panels_.at(f.panels);
  return {f.pivots, f.others, left, left + f.pivots * left_stride(f.pivots, f.others)};
}

std::span<double> Fronts::update_of(std::size_t front) {
  const std::int32_t others = tree_->fronts[front].others;
  return {updates_[schedule_->parity[front]].at(schedule_->update[front]),
          static_cast<std::size_t>(others * upper_stride(others))};
}

Elimination Fronts::eliminate(std::size_t front, Workers* workers) {
  const Front& f = tree_->fronts[front];
  const FrontPanels panels = panels_of(front);
  const std::span<double> update = update_of(front);
  std::fill(panels_.at(f.panels), panels_.at(tree_->fronts[front + 1].panels), 0.0);
  std::ranges::fill(update, 0.0);
  set_entries(front);
  if (rule_.positive) keep_diagonal(front);
  for (std::int32_t c = tree_->child_start[front]; c < tree_->child_start[front + 1]; ++c)
    matrix_kernels_.add_child(left_by(static_cast<std::size_t>(tree_->child[c])), panels, update.data());
  std::int32_t* exchanged = exchanged_.data() + f.first;
  Elimination e = workers ? eliminate_together(kernels_, panels, rule_, exchanged, *workers)
                          : kernels_.eliminate(panels, rule_, exchanged);
  if (rule_.positive && e.stopped_at < 0) e = first_cancelled(front);
  if (e.stopped_at < 0)
    workers ? update_together(kernels_, panels, update.data(), *workers)
            : kernels_.update(panels, update.data());
  return e;
}

/// Stores the diagonal entries that the matrix has in a front. The panels contain them only until the updates
/// of the children are added.
void Fronts::keep_diagonal(std::size_t front) {
  const Front& f = tree_->fronts[front];
  const FrontPanels panels = panels_of(front);
  for (std::int32_t k = 0; k < f.pivots; ++k)
    by_place_[f.first + k] = panels.left[k * (left_stride(f.pivots, f.others) + 1)];
}

/// Finds the first pivot of a front that is mere rounding: at most kRoundingOfPivot times its diagonal entry
/// in the matrix.
Elimination Fronts::first_cancelled(std::size_t front) {
  const Front& f = tree_->fronts[front];
  const FrontPanels panels = panels_of(front);
  for (std::int32_t k = 0; k < f.pivots; ++k)
    if (!(panels.left[k * (left_stride(f.pivots, f.others) + 1)] > kRoundingOfPivot * by_place_[f.first + k]))
      return {k};
  return {};
}

/// Copies the entries of the matrix into the panels of a front, which are zero before.
void Fronts::set_entries(std::size_t front) {
  double* panels = panels_.at(tree_->fronts[front].panels);
  for (std::size_t k = tree_->fronts[front].entries; k < tree_->fronts[front + 1].entries; ++k) {
    const FrontEntries& entries = tree_->of_matrix[k];
    const double* from = values_.data() + entries.slot;
    double* to = panels + entries.target;
    to[0] = from[0];
    if (entries.size == 1) continue;
    const std::ptrdiff_t down = entries.down, across = entries.across;
    to[across] = from[1];
    to[2 * across] = from[2];
    to += down;
    to[0] = from[3];
    to[across] = from[4];
    to[2 * across] = from[5];
    to += down;
    to[0] = from[6];
    to[across] = from[7];
    to[2 * across] = from[8];
  }
}

/// Returns C_child of (1) in front_tree.hpp.
ChildUpdate Fronts::left_by(std::size_t child) {
  const Front &front = tree_->fronts[child], &next = tree_->fronts[child + 1];
  return {update_of(child).data(), front.others, {tree_->runs.data() + front.runs, next.runs - front.runs}};
}

/// Calls a kernel with the unknowns of a front, and adds its results for other unknowns.
void Fronts::pass_up(std::size_t front, void (*kernel)(const FrontPanels&, double*)) {
  const Front& f = tree_->fronts[front];
  double *own = by_place_.data() + f.first, *y = of_front_.data();
  const std::int32_t* other = tree_->other.data() + f.indices;
  std::copy_n(own, f.pivots, y);
  std::fill_n(y + f.pivots, f.others, 0.0);
  kernel(panels_of(front), y);
  std::copy_n(y, f.pivots, own);
  for (std::int32_t i = 0; i < f.others; ++i) by_place_[other[i]] += y[f.pivots + i];
}

/// Calls a kernel with the unknowns of a front and the known values of other unknowns.
void Fronts::pass_down(std::size_t front, void (*kernel)(const FrontPanels&, double*)) {
  const Front& f = tree_->fronts[front];
  double *own = by_place_.data() + f.first, *y = of_front_.data();
  const std::int32_t* other = tree_->other.data() + f.indices;
  std::copy_n(own, f.pivots, y);
  for (std::int32_t i = 0; i < f.others; ++i) y[f.pivots + i] = by_place_[other[i]];
  kernel(panels_of(front), y);
  std::copy_n(y, f.pivots, own);
}

void Fronts::forward(std::size_t front) {
  const Front& f = tree_->fronts[front];
  double* own = by_place_.data() + f.first;
  const std::int32_t* exchanged = exchanged_.data() + f.first;
  for (std::int32_t k = 0; k < f.pivots; ++k) std::swap(own[k], own[exchanged[k]]);
  pass_up(front, kernels_.forward);
}

void Fronts::backward(std::size_t front) { pass_down(front, kernels_.backward); }

void Fronts::forward_transposed(std::size_t front) { pass_up(front, kernels_.forward_transposed); }

void Fronts::backward_transposed(std::size_t front) {
  pass_down(front, kernels_.backward_transposed);
  const Front& f = tree_->fronts[front];
  double* own = by_place_.data() + f.first;
  const std::int32_t* exchanged = exchanged_.data() + f.first;
  for (std::int32_t k = f.pivots; k-- > 0;) std::swap(own[k], own[exchanged[k]]);
}

}  // namespace netloft
