// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_schedule.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "solvers/factorisation/front_kernels.hpp"

namespace netloft {
namespace {

// Branches that a thread gets on average. In nested dissections of nets each level of the tree has 0.7 times
// the work of the one above it, so that smaller branches would leave more to the trunk.
constexpr double kBranchesPerThread = 2;

class Scheduler {
 public:
  explicit Scheduler(const FrontTree& tree) : tree_(tree), fronts_(tree.fronts.size() - 1) {}

  FrontSchedule schedule(std::size_t threads, int ranks) {
    find_parities();
    sum_up_work();
    if (ranks > 1) send_branches(ranks);
    const double pieces = (threads > 1 ? kBranchesPerThread * static_cast<double>(threads) : 1) * ranks;
    const double largest = pieces > 1 ? tree_.flops / pieces : -1;
    for (std::size_t s = 0; s < fronts_; ++s)
      if (is_branch(s, largest) && !is_remote(s)) schedule_.branches.push_back({first_[s], s + 1});
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

  /// Of each front with all below it, and the first of these: they come in a row.
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

  /// Gives the branches with most work away first, each to the rank that has least so far. Rank 0 comes last
  /// among equals, since it has the trunk, too.
  void send_branches(int ranks) {
    const double share = tree_.flops / ranks;
    std::vector<std::size_t> roots;
    for (std::size_t s = 0; s < fronts_; ++s)
      if (is_branch(s, share)) roots.push_back(s);
    std::ranges::stable_sort(roots, std::greater{}, [&](std::size_t s) { return work_[s]; });
    std::vector<double> load(static_cast<std::size_t>(ranks), 0);  // of ranks 1, 2, …, 0
    for (const std::size_t s : roots) {
      const auto least = std::ranges::min_element(load);
      *least += work_[s];
      const int rank = static_cast<int>(least - load.begin() + 1) % ranks;
      if (rank > 0) schedule_.remote.push_back({first_[s], s + 1, rank});
    }
    std::ranges::sort(schedule_.remote, {}, &FrontSchedule::RemoteBranch::first);
  }

  bool is_remote(std::size_t s) const {
    return std::ranges::any_of(schedule_.remote,
                               [&](const auto& branch) { return branch.first <= s && s < branch.last; });
  }

  void list_trunk() {
    std::vector<FrontSchedule::Branch> branches = schedule_.branches;
    for (const auto& [first, last, rank] : schedule_.remote) branches.push_back({first, last});
    std::ranges::sort(branches, {}, &FrontSchedule::Branch::first);
    std::size_t next = 0;
    for (const auto& branch : branches) {
      for (; next < branch.first; ++next) schedule_.trunk.push_back(next);
      next = branch.last;
    }
    for (; next < fronts_; ++next) schedule_.trunk.push_back(next);
  }

  void stack_updates() {
    schedule_.update.resize(fronts_);
    for (const auto& branch : schedule_.remote) push_update(branch.last - 1);
    for (const auto& branch : schedule_.branches) {
      std::vector<std::size_t> fronts(branch.last - branch.first);
      for (std::size_t s = branch.first; s < branch.last; ++s) fronts[s - branch.first] = s;
      stack(fronts);
    }
    stack(schedule_.trunk);
  }

  /// Lays one update behind all that is there.
  void push_update(std::size_t s) {
    std::size_t& room = schedule_.room[schedule_.parity[s]];
    schedule_.update[s] = room;
    room += size_of_update(s);
  }

  std::size_t size_of_update(std::size_t s) const {
    const std::int32_t others = tree_.fronts[s].others;
    return static_cast<std::size_t>(others * upper_stride(others));
  }

  std::size_t size_of_scratch(std::size_t s) const {
    const Front& front = tree_.fronts[s];
    return tree_.is_definite ? static_cast<std::size_t>(front.pivots * upper_stride(front.others)) : 0;
  }

  /// Lays the updates of some fronts onto stacks behind all that is there. Those of children that lie before
  /// these stacks belong to branches and stay.
  void stack(const std::vector<std::size_t>& fronts) {
    const std::size_t bottom[2] = {schedule_.room[0], schedule_.room[1]};
    std::size_t top[2] = {bottom[0], bottom[1]};
    for (const std::size_t s : fronts) {
      std::size_t &own = top[schedule_.parity[s]], &below = top[1 - schedule_.parity[s]];
      schedule_.update[s] = own;
      own += size_of_update(s);
      for (int parity : {0, 1}) schedule_.room[parity] = std::max(schedule_.room[parity], top[parity]);
      std::size_t& room = schedule_.room[schedule_.parity[s]];
      room = std::max(room, own + size_of_scratch(s));
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
  std::vector<std::size_t> first_;  // of the subtree of each front
};

}  // namespace

FrontSchedule make_front_schedule(const FrontTree& tree, std::size_t threads, int ranks) {
  return Scheduler(tree).schedule(threads, ranks);
}

}  // namespace netloft
