// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_branch.hpp"

#include <algorithm>

namespace netloft {
namespace {

template <class T>
std::vector<T> piece(const std::vector<T>& all, std::size_t from, std::size_t to) {
  return {all.begin() + static_cast<std::ptrdiff_t>(from), all.begin() + static_cast<std::ptrdiff_t>(to)};
}

std::size_t values_of(const FrontEntries& entries) {
  return static_cast<std::size_t>(entries.size * entries.size);
}

class Cutter {
 public:
  Cutter(const FrontTree& tree, std::size_t first, std::size_t last)
      : whole_(tree), first_(first), last_(last), begin_(tree.fronts[first]), end_(tree.fronts[last]) {}

  FrontBranch cut() {
    const Front& root = whole_.fronts[last_ - 1];
    branch_.first_place = begin_.first;
    branch_.outside = {whole_.other.data() + root.indices, static_cast<std::size_t>(root.others)};
    cut_fronts();
    cut_children();
    name_others();
    number_values();
    FrontTree& tree = branch_.tree;
    tree.runs = piece(whole_.runs, begin_.runs, end_.runs);
    tree.panels = end_.panels - begin_.panels;
    tree.is_definite = whole_.is_definite;
    return std::move(branch_);
  }

 private:
  void cut_fronts() {
    std::vector<Front>& fronts = branch_.tree.fronts;
    fronts = piece(whole_.fronts, first_, last_ + 1);
    fronts.back().first = fronts[fronts.size() - 2].first + fronts[fronts.size() - 2].pivots;
    for (Front& front : fronts) {
      front.first -= begin_.first;
      front.parent -= static_cast<std::int32_t>(first_);
      front.indices -= begin_.indices;
      front.panels -= begin_.panels;
      front.runs -= begin_.runs;
      front.entries -= begin_.entries;
      branch_.tree.most_unknowns = std::max(branch_.tree.most_unknowns, front.pivots + front.others);
    }
    fronts[fronts.size() - 2].parent = -1;
  }

  void cut_children() {
    FrontTree& tree = branch_.tree;
    tree.child_start = piece(whole_.child_start, first_, last_ + 1);
    const std::int32_t begin = tree.child_start.front();
    tree.child = piece(whole_.child, static_cast<std::size_t>(begin),
                       static_cast<std::size_t>(tree.child_start.back()));
    for (std::int32_t& start : tree.child_start) start -= begin;
    for (std::int32_t& child : tree.child) child -= static_cast<std::int32_t>(first_);
  }

  void name_others() {
    std::vector<std::int32_t>& others = branch_.tree.other;
    others = piece(whole_.other, begin_.indices, end_.indices);
    const std::int32_t own = branch_.tree.fronts.back().first;
    for (std::int32_t& other : others)
      other = other < begin_.first + own ? other - begin_.first : own + place_outside(other);
  }

  std::int32_t place_outside(std::int32_t place) const {
    return static_cast<std::int32_t>(std::ranges::lower_bound(branch_.outside, place) -
                                     branch_.outside.begin());
  }

  void number_values() {
    FrontTree& tree = branch_.tree;
    tree.of_matrix = piece(whole_.of_matrix, begin_.entries, end_.entries);
    for (FrontEntries& entries : tree.of_matrix) {
      entries.slot = static_cast<std::uint32_t>(branch_.values);
      branch_.values += values_of(entries);
    }
  }

  const FrontTree& whole_;
  std::size_t first_, last_;
  const Front &begin_, &end_;
  FrontBranch branch_;
};

}  // namespace

FrontBranch cut_branch(const FrontTree& tree, std::size_t first, std::size_t last) {
  return Cutter(tree, first, last).cut();
}

void leave_out_panels(FrontTree& tree, std::size_t first, std::size_t last) {
  const std::size_t begin = tree.fronts[first].panels, size = tree.fronts[last].panels - begin;
  for (std::size_t s = first; s < last; ++s) tree.fronts[s].panels = begin;
  for (std::size_t s = last; s < tree.fronts.size(); ++s) tree.fronts[s].panels -= size;
  tree.panels -= size;
}

void gather_values(const FrontTree& tree, std::size_t first, std::size_t last, std::span<const double> values,
                   std::span<double> of_branch) {
  double* to = of_branch.data();
  for (std::size_t k = tree.fronts[first].entries; k < tree.fronts[last].entries; ++k)
    to = std::copy_n(values.data() + tree.of_matrix[k].slot, values_of(tree.of_matrix[k]), to);
}

}  // namespace netloft
