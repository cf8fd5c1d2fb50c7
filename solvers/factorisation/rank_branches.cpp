// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/rank_branches.hpp"

#include <algorithm>

#include "solvers/factorisation/ranks.hpp"

namespace netloft {
namespace {

/// What precedes a branch on its way.
struct Sizes {
  std::uint64_t fronts, others, runs, child_starts, children, entries, panels, values;
  std::int32_t most_unknowns, own, outside;
  bool is_definite;
};

Sizes sizes_of(const FrontBranch& branch) {
  const FrontTree& tree = branch.tree;
  return {tree.fronts.size(),
          tree.other.size(),
          tree.runs.size(),
          tree.child_start.size(),
          tree.child.size(),
          tree.of_matrix.size(),
          tree.panels,
          branch.values,
          tree.most_unknowns,
          tree.fronts.back().first,
          static_cast<std::int32_t>(branch.outside.size()),
          tree.is_definite};
}

void send_branch(Ranks& ranks, int rank, const FrontBranch& branch) {
  const FrontTree& tree = branch.tree;
  const Sizes sizes = sizes_of(branch);
  ranks.send(rank, std::span(&sizes, 1));
  ranks.send(rank, std::span(tree.fronts));
  ranks.send(rank, std::span(tree.other));
  ranks.send(rank, std::span(tree.runs));
  ranks.send(rank, std::span(tree.child_start));
  ranks.send(rank, std::span(tree.child));
  ranks.send(rank, std::span(tree.of_matrix));
}

template <class T>
void receive_vector(Ranks& ranks, std::vector<T>& numbers, std::uint64_t count) {
  numbers.resize(count);
  ranks.receive(0, std::span(numbers));
}

Sizes receive_tree(Ranks& ranks, FrontTree& tree) {
  Sizes sizes;
  ranks.receive(0, std::span(&sizes, 1));
  receive_vector(ranks, tree.fronts, sizes.fronts);
  receive_vector(ranks, tree.other, sizes.others);
  receive_vector(ranks, tree.runs, sizes.runs);
  receive_vector(ranks, tree.child_start, sizes.child_starts);
  receive_vector(ranks, tree.child, sizes.children);
  receive_vector(ranks, tree.of_matrix, sizes.entries);
  tree.panels = sizes.panels;
  tree.most_unknowns = sizes.most_unknowns;
  tree.is_definite = sizes.is_definite;
  return sizes;
}

}  // namespace

RemoteBranches::RemoteBranches(Ranks& ranks) : ranks_(ranks), instance_(ranks.next_instance()) {}

RemoteBranches::~RemoteBranches() {
  if (job_.owns_lock()) job_.unlock();
  ranks_.begin(instance_, static_cast<int>(BranchJob::forget));
}

void RemoteBranches::plan(const FrontTree& tree, const FrontSchedule& schedule) {
  tree_ = &tree;
  schedule_ = &schedule;
  branches_.clear();
  bytes_.assign(static_cast<std::size_t>(ranks_.size()), 0);
  const auto job = ranks_.begin(instance_, static_cast<int>(BranchJob::plan));
  for (int rank = 1; rank < ranks_.size(); ++rank) {
    const std::uint64_t count = static_cast<std::uint64_t>(
        std::ranges::count(schedule.remote, rank, &FrontSchedule::RemoteBranch::rank));
    ranks_.send(rank, std::span(&count, 1));
  }
  for (const auto& [first, last, rank] : schedule.remote) {
    const FrontBranch branch = cut_branch(tree, first, last);
    send_branch(ranks_, rank, branch);
    double bytes = 0;
    ranks_.receive(rank, std::span(&bytes, 1));
    bytes_[static_cast<std::size_t>(rank)] += bytes;
    numbers_.reserve(std::max(branch.values, branch.outside.size()));  // so that nothing fails half-way
    branches_.push_back({branch.first_place, branch.tree.fronts.back().first, branch.outside, branch.values});
  }
}

double RemoteBranches::bytes() const { return bytes_.empty() ? 0 : std::ranges::max(bytes_); }

bool RemoteBranches::begin_elimination(std::span<const double> values) {
  job_ = ranks_.begin(instance_, static_cast<int>(BranchJob::eliminate));
  if (!have_room()) return job_.unlock(), false;
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const auto& [first, last, rank] = schedule_->remote[b];
    numbers_.resize(branches_[b].values);
    gather_values(*tree_, first, last, values, numbers_);
    ranks_.send(rank, std::span(numbers_));
  }
  return true;
}

/// Asks every rank, and tells all of them what all have said.
bool RemoteBranches::have_room() {
  std::uint8_t all = 1;
  for (int rank = 1; rank < ranks_.size(); ++rank) {
    std::uint8_t one = 0;
    ranks_.receive(rank, std::span(&one, 1));
    all = all && one;
  }
  for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, std::span(&all, 1));
  return all;
}

std::vector<BranchEnd> RemoteBranches::end_elimination(Fronts& fronts) {
  std::vector<BranchEnd> ends(branches_.size());
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const auto& [first, last, rank] = schedule_->remote[b];
    ranks_.receive(rank, std::span(&ends[b], 1));
    if (ends[b].elimination.stopped_at < 0) ranks_.receive(rank, fronts.update_of(last - 1));
  }
  job_.unlock();
  return ends;
}

void RemoteBranches::begin_solution() { job_ = ranks_.begin(instance_, static_cast<int>(BranchJob::solve)); }

void RemoteBranches::forward(std::size_t branch, std::span<double> by_place) {
  const Remote& remote = branches_[branch];
  const int rank = schedule_->remote[branch].rank;
  ranks_.send(rank, by_place.subspan(remote.first_place, remote.own));
  exchange_outside(branch, by_place);
  ranks_.receive(rank, std::span(numbers_));
  for (std::size_t i = 0; i < numbers_.size(); ++i) by_place[remote.outside[i]] = numbers_[i];
}

void RemoteBranches::backward(std::size_t branch, std::span<double> by_place) {
  const Remote& remote = branches_[branch];
  exchange_outside(branch, by_place);
  ranks_.receive(schedule_->remote[branch].rank, by_place.subspan(remote.first_place, remote.own));
}

/// Sends what is at the places outside, of which numbers_ has as many then.
void RemoteBranches::exchange_outside(std::size_t branch, std::span<double> by_place) {
  const Remote& remote = branches_[branch];
  numbers_.resize(remote.outside.size());
  for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = by_place[remote.outside[i]];
  ranks_.send(schedule_->remote[branch].rank, std::span(numbers_));
}

void BranchServer::serve(int instance, BranchJob job) {
  Branches& branches = instances_[instance];
  if (job == BranchJob::plan) plan(branches);
  if (job == BranchJob::eliminate) eliminate(branches);
  if (job == BranchJob::solve) solve(branches);
  if (job == BranchJob::forget) instances_.erase(instance);
}

void BranchServer::plan(Branches& branches) {
  std::uint64_t count = 0;
  ranks_.receive(0, std::span(&count, 1));
  branches.clear();
  for (; count > 0; --count) {
    Served& branch = *branches.emplace_back(std::make_unique<Served>());
    const Sizes sizes = receive_tree(ranks_, branch.tree);
    branch.own = sizes.own;
    branch.outside = sizes.outside;
    branch.schedule = make_front_schedule(branch.tree, 1);
    branch.fronts.plan(branch.tree, branch.schedule, sizes.values,
                       static_cast<std::size_t>(sizes.own + sizes.outside));
    const double bytes = branch.fronts.bytes();
    ranks_.send(0, std::span(&bytes, 1));
  }
}

/// All values are received first: rank 0 works on its own part then.
void BranchServer::eliminate(Branches& branches) {
  std::uint8_t has_room =
      std::ranges::all_of(branches, [](const auto& branch) { return branch->fronts.has_room(); });
  ranks_.send(0, std::span(&has_room, 1));
  ranks_.receive(0, std::span(&has_room, 1));
  if (!has_room) return;
  for (const auto& branch : branches) ranks_.receive(0, branch->fronts.values());
  for (const auto& branch : branches) eliminate(*branch);
  for (const auto& branch : branches) {
    ranks_.send(0, std::span(&branch->end, 1));
    if (branch->end.elimination.stopped_at < 0)
      ranks_.send(0, branch->fronts.update_of(branch->tree.fronts.size() - 2));
  }
}

void BranchServer::eliminate(Served& branch) {
  const auto fronts = static_cast<std::int32_t>(branch.tree.fronts.size()) - 1;
  branch.end = {};
  for (std::int32_t& front = branch.end.front; front < fronts; ++front)
    if ((branch.end.elimination = branch.fronts.eliminate(front, nullptr)).stopped_at >= 0) return;
}

void BranchServer::solve(Branches& branches) {
  for (const auto& branch : branches) {
    const std::span<double> x = branch->fronts.by_place();
    ranks_.receive(0, x.first(branch->own));
    ranks_.receive(0, x.subspan(branch->own));
    for (std::size_t front = 0; front + 1 < branch->tree.fronts.size(); ++front)
      branch->fronts.forward(front);
    ranks_.send(0, x.subspan(branch->own));
  }
  for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch) {
    Fronts& fronts = (*branch)->fronts;
    const std::span<double> x = fronts.by_place();
    ranks_.receive(0, x.subspan((*branch)->own));
    for (std::size_t front = (*branch)->tree.fronts.size() - 1; front-- > 0;) fronts.backward(front);
    ranks_.send(0, x.first((*branch)->own));
  }
}

}  // namespace netloft
