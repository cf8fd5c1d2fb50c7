// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/factorisation/front_tree.hpp"

namespace netloft {

/// In which order fronts are eliminated by several threads, and where their updates lie. Branches are
/// subtrees that need nothing of one another: a thread takes one at a time. The trunk is what is left; its
/// fronts come after all branches, children before parents, and all threads work on each. Every front adds up
/// the same numbers in the same order as alone, so that the factors have the same bits for any number of
/// threads.
///
/// Updates lie on two stacks, by the parity of a front's depth: children are on top of the one when their
/// parent pushes its own onto the other. Branches and the trunk have stacks of their own in the same two
/// rooms.
struct FrontSchedule {
  struct Branch {
    std::size_t first, last;  // fronts, one past the last
  };
  std::vector<Branch> branches;      // those with most work first
  std::vector<std::size_t> trunk;    // fronts
  std::vector<std::uint8_t> parity;  // of the depth of each front
  std::vector<std::size_t> update;   // of each front, in the room of its parity
  std::size_t room[2]{};             // doubles
};

/// For one thread everything is trunk.
FrontSchedule make_front_schedule(const FrontTree& tree, std::size_t threads);

}  // namespace netloft
