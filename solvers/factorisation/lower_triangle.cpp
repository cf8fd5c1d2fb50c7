// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/lower_triangle.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>

#include "solvers/factorisation/foreseen_memory.hpp"

namespace netloft {
namespace {

/// Calls visit(row, column, entry) for every entry of a pattern, column by column.
template <class Visit>
void for_entries(const SparsePattern& pattern, Visit&& visit) {
  for (std::int32_t c = 0; c < pattern.size; ++c)
    for (std::int32_t e = pattern.column_start[c]; e < pattern.column_start[c + 1]; ++e)
      visit(pattern.row[e], c, e);
}

/// The full pattern that belongs to a lower triangle. For each entry, it has the index of its value in the
/// triangle.
struct WholePattern {
  SparsePattern pattern;
  std::vector<std::int32_t> source;

  explicit WholePattern(const SparsePattern& lower);

 private:
  void count_entries(const SparsePattern& lower);
  void interleave();
};

WholePattern::WholePattern(const SparsePattern& lower) {
  pattern.size = lower.size;
  pattern.node = lower.node;
  pattern.symmetric = false;
  count_entries(lower);
  std::vector<std::int32_t> next(pattern.column_start.begin(), pattern.column_start.end() - 1);
  const auto put = [&](std::int32_t row, std::int32_t column, std::int32_t entry) {
    pattern.row[next[column]] = row;
    source[next[column]++] = static_cast<std::int32_t>(lower.slot_of(static_cast<std::size_t>(entry)));
  };
  // Rows are sorted, because the upper entries of a column come from earlier columns in increasing order.
  for_entries(lower, [&](auto row, auto column, auto entry) {
    if (row != column) put(column, row, entry);
  });
  for_entries(lower, put);
  interleave();
}

/// Stores columns with the same rows row by row, so that the values of a pair of nodes are adjacent.
void WholePattern::interleave() {
  const auto& start = pattern.column_start;
  const auto rows = [&](std::int32_t c) {
    return std::span(pattern.row).subspan(start[c], start[c + 1] - start[c]);
  };
  pattern.slot.resize(source.size());
  for (std::int32_t first = 0, last = 1; first < pattern.size; first = last++) {
    while (last < pattern.size && pattern.node[last] == pattern.node[first] &&
           std::ranges::equal(rows(last), rows(first)))
      ++last;
    for (std::int32_t c = first; c < last; ++c)
      for (std::int32_t e = start[c]; e < start[c + 1]; ++e)
        pattern.slot[e] = start[first] + (e - start[c]) * (last - first) + c - first;
  }
  pattern.slots = source.size();
  std::vector<std::int32_t> by_slot(source.size());
  for (std::size_t e = 0; e < source.size(); ++e) by_slot[pattern.slot[e]] = source[e];
  source = std::move(by_slot);
}

void WholePattern::count_entries(const SparsePattern& lower) {
  auto& start = pattern.column_start;
  start.assign(static_cast<std::size_t>(lower.size) + 1, 0);
  for_entries(lower, [&](auto row, auto column, auto) {
    ++start[column + 1];
    if (row != column) ++start[row + 1];
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  pattern.row.resize(start.back());
  source.resize(start.back());
}

class LowerTriangleFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  explicit LowerTriangleFactorisation(std::unique_ptr<Factorisation> inner) : inner_(std::move(inner)) {}

  std::string description() const override { return inner_->description(); }
  void analyse(const SparsePattern& pattern) override {
    assert(pattern.symmetric);
    whole_ = std::make_unique<WholePattern>(pattern);
    values_.resize(whole_->source.size());
    inner_->analyse(whole_->pattern);
  }
  FactorResult factorise(std::span<const double> values) override {
    for (std::size_t e = 0; e < values_.size(); ++e) values_[e] = values[whole_->source[e]];
    return inner_->factorise(values_);
  }
  void solve(std::span<const double> rhs, std::span<double> x) override { inner_->solve(rhs, x); }
  void solve_transposed(std::span<const double> rhs, std::span<double> x) override { solve(rhs, x); }
  double factor_entries() const override { return inner_->factor_entries(); }
  double factor_flops() const override { return inner_->factor_flops(); }
  double factor_bytes() const override { return factor_bytes_of(*inner_); }

 private:
  std::unique_ptr<Factorisation> inner_;
  std::unique_ptr<WholePattern> whole_;
  std::vector<double> values_;
};

}  // namespace

std::unique_ptr<Factorisation> make_factorisation_of_lower_triangle(std::unique_ptr<Factorisation> inner) {
  return std::make_unique<LowerTriangleFactorisation>(std::move(inner));
}

}  // namespace netloft
