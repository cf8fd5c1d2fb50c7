// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>

#include "solvers/factorisation/ranks_module.hpp"

namespace netloft {

/// What a launcher of MPI (mpirun, srun) has said to this process by the environment.
struct Launch {
  int rank = 0, size = 1;
  bool is_launched = false;
};
Launch launch_of_environment();

/// The processes that factorise together. Rank 0 runs the program; all others serve it and do nothing else.
/// Factorisations that use it must not outlive it. Threads may use it at the same time, and wait for each
/// other.
class Ranks {
 public:
  /// Opens the module and starts MPI. Throws std::runtime_error with a sentence if that cannot be.
  Ranks(const std::filesystem::path& module, const Launch& launch);
  Ranks(const RanksModule& module, const Launch& launch);
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  /// On rank 0: lets the others go.
  ~Ranks();

  int rank() const { return rank_; }
  int size() const { return size_; }
  /// On all ranks but 0, until that lets them go.
  void serve();

  int next_instance() { return ++instances_; }
  /// Runs the job of a DMUMPS_STRUC_C on all ranks, `instance` being its number.
  void call(int instance, int job, int symmetry, void* mumps);

  /// Gives an order of branches; the ranks are the caller's until it lets the lock go.
  std::unique_lock<std::mutex> begin(int instance, int job);
  template <class T>
  void send(int rank, std::span<T> numbers) {
    module_->send(rank, numbers.data(), numbers.size_bytes());
  }
  template <class T>
  void receive(int rank, std::span<T> numbers) {
    module_->receive(rank, numbers.data(), numbers.size_bytes());
  }

 private:
  const RanksModule* module_ = nullptr;
  int rank_ = 0, size_ = 1;
  std::atomic<int> instances_{0};
  std::mutex one_at_a_time_;
};

/// Which factorisations are distributed: those of `from` unknowns and more, if there are ranks.
struct RankUse {
  /// Below, a factorisation takes less than 0.1 s and 0.2 GB in one process (README.md).
  static constexpr std::int32_t kFrom = 100'000;
  Ranks* ranks = nullptr;
  std::int32_t from = kFrom;
  bool has_same_bits = false;  // by our own fronts, else by MUMPS
};

}  // namespace netloft
