// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

#include "solvers/factorisation/front_schedule.hpp"

namespace netloft {

/// A subtree as a tree of its own, for whoever eliminates it somewhere else. Its values are those of the
/// matrix that its fronts add up, in the order of FrontTree::of_matrix, and its places those of its pivots
/// and after them `outside`, the others of its root. (Others of any front below are among them, or pivots.)
struct FrontBranch {
  FrontTree tree;  // without the matrix and the order of unknowns
  std::int32_t first_place = 0;
  std::span<const std::int32_t> outside;  // places in the whole tree, which has to outlive this
  std::size_t values = 0;

  std::size_t places() const { return static_cast<std::size_t>(tree.fronts.back().first) + outside.size(); }
};

/// The fronts from `first` to before `last`, which are a front and all below it.
FrontBranch cut_branch(const FrontTree& tree, std::size_t first, std::size_t last);

/// Leaves no room for the factors of these fronts.
void leave_out_panels(FrontTree& tree, std::size_t first, std::size_t last);

/// The values of a branch, out of those of the matrix.
void gather_values(const FrontTree& tree, std::size_t first, std::size_t last, std::span<const double> values,
                   std::span<double> of_branch);

}  // namespace netloft
