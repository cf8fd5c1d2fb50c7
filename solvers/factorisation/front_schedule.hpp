// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/factorisation/front_tree.hpp"

namespace netloft {

/// The order in which several threads eliminate fronts (front_tree.hpp), and the places of their updates.
/// Branches are independent subtrees; each thread takes one branch at a time. The trunk consists of all other
/// fronts; they follow after all branches, children before parents, and all threads work together on each of
/// them. Every front sums the same numbers in the same order as with one thread; the factors therefore have
/// the same bits for any number of threads.
///
/// Updates are kept on two stacks, one for fronts at even depths in the tree and one for fronts at odd
/// depths. The updates of children are on top of one stack when their parent pushes its update onto the
/// other. Each branch and the trunk have separate stacks in the same two blocks of memory.
struct FrontSchedule {
  struct Branch {
    std::size_t first, last;  // first front, and one past the last
  };
  std::vector<Branch> branches;      // branches with most work first
  std::vector<std::size_t> trunk;    // fronts that belong to no branch
  std::vector<std::uint8_t> parity;  // parity of the depth of each front
  std::vector<std::size_t> update;   // where the update of each front begins in the block of its parity
  std::size_t room[2]{};             // size of the two blocks [doubles]
};

/// Plans the elimination. With one thread, all fronts are in the trunk.
FrontSchedule make_front_schedule(const FrontTree& tree, std::size_t threads);

}  // namespace netloft
