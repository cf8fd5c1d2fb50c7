// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_schedule.hpp"

#include <algorithm>
#include <utility>

#include "solvers/factorisation/front_kernels.hpp"

namespace netloft {
namespace {

// Number of branches (subtrees) per thread, on average. In nested dissections of nets, each level of the tree
// has 0.7 times the work of the level above; with smaller branches, more work would remain for the trunk (the
// fronts outside all branches).
constexpr double kBranchesPerThread = 2;

class Scheduler {
 public:
  explicit Scheduler(const FrontTree& tree) : tree_(tree), fronts_(tree.fronts.size() - 1) {}

  FrontSchedule schedule(std::size_t threads) {
    find_parities();
    sum_up_work();
    const double largest =
        threads > 1 ? tree_.flops / (kBranchesPerThread * static_cast<double>(threads)) : -1;
    for (std::size_t s = 0; s < fronts_; ++s)
      if (is_branch(s, largest)) schedule_.branches.push_back({first_[s], s + 1});
    list_trunk();
    stack_updates();
    std::sort(schedule_.branches.begin(), schedule_.branches.end(), [&](const auto& a, const auto& b) {
      return std::pair(-work_[a.last - 1], a.first) < std::pair(-work_[b.last - 1], b.first);
    });
    return std::move(schedule_);
  }

 private:
  void find_parities() {
    schedule_.parity.resize(fronts_);
    for (std::size_t s = fronts_; s-- > 0;)
      schedule_.parity[s] = tree_.fronts[s].parent < 0 ? 0 : 1 - schedule_.parity[parent(s)];
  }

  std::size_t parent(std::size_t s) const { return static_cast<std::size_t>(tree_.fronts[s].parent); }

  /// Sums for each front the operations of its subtree. The fronts of a subtree are numbered consecutively;
  /// the number of the first is stored in first_.
  void sum_up_work() {
    work_.assign(fronts_, 0);
    first_.resize(fronts_);
    for (std::size_t s = 0; s < fronts_; ++s) first_[s] = s;
    for (std::size_t s = 0; s < fronts_; ++s) {
      work_[s] += flops_of(tree_.fronts[s]);
      if (tree_.fronts[s].parent < 0) continue;
      work_[parent(s)] += work_[s];
      first_[parent(s)] = std::min(first_[parent(s)], first_[s]);
    }
  }

  bool is_branch(std::size_t s, double largest) const {
    return work_[s] <= largest && (tree_.fronts[s].parent < 0 || work_[parent(s)] > largest);
  }

  void list_trunk() {
    std::size_t next = 0;
    for (const auto& branch : schedule_.branches) {
      for (; next < branch.first; ++next) schedule_.trunk.push_back(next);
      next = branch.last;
    }
    for (; next < fronts_; ++next) schedule_.trunk.push_back(next);
  }

  void stack_updates() {
    schedule_.update.resize(fronts_);
    for (const auto& branch : schedule_.branches) {
      std::vector<std::size_t> fronts(branch.last - branch.first);
      for (std::size_t s = branch.first; s < branch.last; ++s) fronts[s - branch.first] = s;
      stack(fronts);
    }
    stack(schedule_.trunk);
  }

  /// Places the updates of `fronts` on two new stacks, after all existing updates. Updates of children that
  /// belong to a branch stay on the stacks of that branch.
  void stack(const std::vector<std::size_t>& fronts) {
    const std::size_t bottom[2] = {schedule_.room[0], schedule_.room[1]};
    std::size_t top[2] = {bottom[0], bottom[1]};
    for (const std::size_t s : fronts) {
      const Front& front = tree_.fronts[s];
      std::size_t &own = top[schedule_.parity[s]], &below = top[1 - schedule_.parity[s]];
      schedule_.update[s] = own;
      own += static_cast<std::size_t>(front.others * upper_stride(front.others));
      for (int parity : {0, 1}) schedule_.room[parity] = std::max(schedule_.room[parity], top[parity]);
      for (std::int32_t c = tree_.child_start[s]; c < tree_.child_start[s + 1]; ++c) {
        const std::size_t update = schedule_.update[static_cast<std::size_t>(tree_.child[c])];
        if (update >= bottom[1 - schedule_.parity[s]]) below = std::min(below, update);
      }
    }
  }

  const FrontTree& tree_;
  std::size_t fronts_;
  FrontSchedule schedule_;
  std::vector<double> work_;        // [floating-point operations]
  std::vector<std::size_t> first_;  // first front of the subtree of each front
};

}  // namespace

FrontSchedule make_front_schedule(const FrontTree& tree, std::size_t threads) {
  return Scheduler(tree).schedule(threads);
}

}  // namespace netloft
