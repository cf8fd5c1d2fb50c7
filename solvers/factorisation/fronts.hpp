// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "framework/assembler/workers.hpp"
#include "solvers/factorisation/front_schedule.hpp"

namespace netloft {

/// An array of doubles that begins at a cache line and is not initialised. resize() throws std::bad_alloc.
class Room {
 public:
  void resize(std::size_t count);
  void clear() {
    all_.reset();
    begin_ = nullptr;
  }
  bool is_empty() const { return begin_ == nullptr; }
  double* at(std::size_t i) { return begin_ + i; }

 private:
  static constexpr std::size_t kLine = 8;
  std::unique_ptr<double[]> all_;
  double* begin_ = nullptr;
};

/// The numbers of a tree of fronts: values of the matrix, factors, updates, and the vector of a solve. Each
/// function works on one front; the caller visits the fronts in an order that front_schedule.hpp allows.
class Fronts {
 public:
  /// `values` is the number of values of the matrix. `tree` and `schedule` must outlive the last call.
  void plan(const FrontTree& tree, const FrontSchedule& schedule, std::size_t values, const PivotRule& rule);

  /// The memory that has_room() allocates [bytes].
  double bytes() const;
  /// Allocates the memory at the first call after plan(). Returns false if there is not enough.
  bool has_room();

  std::span<double> values() { return values_; }
  std::span<double> by_place() { return by_place_; }

  /// Eliminates a front: with this thread alone if `workers` is nullptr, otherwise with all `workers`.
  Elimination eliminate(std::size_t front, Workers* workers);
  /// forward() and backward() solve the part of L y = b, or of U x = y, that belongs to a front, in the
  /// vector by_place(). Call forward() for children before parents, backward() for parents before children.
  void forward(std::size_t front);
  void backward(std::size_t front);
  /// The same for Uᵀ y = b and Lᵀ x = y, which solve the transposed equations.
  void forward_transposed(std::size_t front);
  void backward_transposed(std::size_t front);

 private:
  void make_room();
  void forget_room();
  FrontPanels panels_of(std::size_t front);
  /// The update of a front: C of (1) in front_tree.hpp, column by column.
  std::span<double> update_of(std::size_t front);
  void set_entries(std::size_t front);
  void keep_diagonal(std::size_t front);
  Elimination first_cancelled(std::size_t front);
  ChildUpdate left_by(std::size_t child);
  void pass_up(std::size_t front, void (*kernel)(const FrontPanels&, double*));
  void pass_down(std::size_t front, void (*kernel)(const FrontPanels&, double*));

  const FrontTree* tree_ = nullptr;
  const FrontSchedule* schedule_ = nullptr;
  std::size_t value_count_ = 0;
  PivotRule rule_;
  const FrontKernels& kernels_ = front_kernels();
  const MatrixKernels& matrix_kernels_ = matrix_kernels();
  std::vector<double> values_;  // values of the matrix, by slot
  Room panels_, updates_[2];
  std::vector<std::int32_t> exchanged_;  // row exchanged with each pivot's row, by place of the pivot
  std::vector<double> by_place_, of_front_;
};

}  // namespace netloft
