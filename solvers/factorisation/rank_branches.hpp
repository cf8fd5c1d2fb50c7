// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "solvers/factorisation/front_branch.hpp"
#include "solvers/factorisation/fronts.hpp"

namespace netloft {

class Ranks;

/// What rank 0 has the others do with branches of a tree of fronts. Each job is an order to all
/// (Ranks::begin), and then messages between rank 0 and those that have branches, in the order of their
/// fronts.
enum class BranchJob : int { plan, eliminate, solve, forget };

/// The end of the elimination of a branch.
struct BranchEnd {
  Elimination elimination;
  std::int32_t front = 0;  // of the branch, where it stopped
};

/// On rank 0: the branches that others have. Everything is computed there in the same order as it would be
/// here, with the same bits.
class RemoteBranches {
 public:
  explicit RemoteBranches(Ranks& ranks);
  ~RemoteBranches();

  /// Sends the branches that `schedule` gives away. Both must outlive the last call.
  void plan(const FrontTree& tree, const FrontSchedule& schedule);
  /// What the rank takes that takes most [bytes].
  double bytes() const;

  /// Sends values of the matrix. Between this and end_elimination() the ranks work. Returns false if one of
  /// them has not enough memory; then there is nothing to end.
  bool begin_elimination(std::span<const double> values);
  /// Puts the updates of branches where `fronts` has them.
  std::vector<BranchEnd> end_elimination(Fronts& fronts);

  /// Solutions go forward through all branches in order, and back through all. In between everything else may
  /// be done in by_place().
  void begin_solution();
  void forward(std::size_t branch, std::span<double> by_place);
  void backward(std::size_t branch, std::span<double> by_place);
  void end_solution() { job_.unlock(); }

 private:
  struct Remote {
    std::int32_t first_place = 0, own = 0;
    std::span<const std::int32_t> outside;
    std::size_t values = 0;
  };
  bool have_room();
  void exchange_outside(std::size_t branch, std::span<double> by_place);

  Ranks& ranks_;
  int instance_;
  std::unique_lock<std::mutex> job_;
  const FrontTree* tree_ = nullptr;
  const FrontSchedule* schedule_ = nullptr;
  std::vector<Remote> branches_;
  std::vector<double> bytes_, numbers_;
};

/// On all other ranks: works on the branches that they are given.
class BranchServer {
 public:
  explicit BranchServer(Ranks& ranks) : ranks_(ranks) {}
  void serve(int instance, BranchJob job);

 private:
  struct Served {
    FrontTree tree;
    FrontSchedule schedule;
    Fronts fronts;
    std::int32_t own = 0, outside = 0;
    BranchEnd end;
  };
  using Branches = std::vector<std::unique_ptr<Served>>;
  void plan(Branches& branches);
  void eliminate(Branches& branches);
  void eliminate(Served& branch);
  void solve(Branches& branches);

  Ranks& ranks_;
  std::map<int, Branches> instances_;
};

}  // namespace netloft
