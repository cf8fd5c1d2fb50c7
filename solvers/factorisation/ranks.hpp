// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>

#include "framework/ranks/messages.hpp"
#include "solvers/factorisation/ranks_module.hpp"

namespace netloft {

/// What a launcher of MPI (mpirun, srun) has said to this process by the environment.
struct Launch {
  int rank = 0, size = 1;
  bool is_launched = false;
};
Launch launch_of_environment();

/// The processes that work together: they factorise, and evaluate shares of scenes. Rank 0 runs the program;
/// all others serve it and do nothing else. Factorisations that use it must not outlive it. Threads may use
/// it at the same time, and wait for each other.
class Ranks : public Messages {
 public:
  /// Opens the module and starts MPI. Throws std::runtime_error with a sentence if that cannot be.
  Ranks(const std::filesystem::path& module, const Launch& launch);
  Ranks(const RanksModule& module, const Launch& launch);
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  /// On rank 0: lets the others go.
  ~Ranks() override;

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  /// On all ranks but 0, until that lets them go. `shares` takes the orders about shares of scenes.
  void serve(ServesShares* shares = nullptr);

  int next_instance() override { return ++instances_; }
  /// Runs the job of a DMUMPS_STRUC_C on all ranks, `instance` being its number.
  void call(int instance, int job, int symmetry, void* mumps);

  /// Gives an order of branches; the ranks are the caller's until it lets the lock go.
  std::unique_lock<std::mutex> begin(int instance, int job);
  std::unique_lock<std::mutex> begin_shares(int instance, int job) override;
  void send(int rank, std::span<const std::byte> bytes) override {
    module_->send(rank, bytes.data(), bytes.size());
  }
  void receive(int rank, std::span<std::byte> bytes) override {
    module_->receive(rank, bytes.data(), bytes.size());
  }
  void broadcast(std::span<std::byte> bytes) override { module_->broadcast(bytes.data(), bytes.size()); }
  template <class T>
  void send(int rank, std::span<T> numbers) {
    module_->send(rank, numbers.data(), numbers.size_bytes());
  }
  template <class T>
  void receive(int rank, std::span<T> numbers) {
    module_->receive(rank, numbers.data(), numbers.size_bytes());
  }

 private:
  std::unique_lock<std::mutex> give(const RanksOrder& order);

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
