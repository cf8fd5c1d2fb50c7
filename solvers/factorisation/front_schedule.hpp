// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/factorisation/front_tree.hpp"

namespace netloft {

/// The order in which several threads eliminate fronts, and the places of the updates. Branches are
/// independent subtrees; a thread takes one at a time. The trunk is the rest of the tree; its fronts follow
/// after all branches, children before parents, and all threads work on each of them. Every front sums the
/// same numbers in the same order as with one thread, so that the factors have the same bits for any number
/// of threads.
///
/// Updates are on two stacks, chosen by the parity of the depth of a front: the updates of the children are
/// on top of one stack when their parent pushes its update onto the other. Each branch and the trunk have
/// separate stacks in the same two blocks of memory.
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
