// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace netloft {

/// A fixed set of threads that share out ranges. Allocates nothing after construction.
class Workers {
 public:
  explicit Workers(int threads) {
    for (int i = 1; i < threads; ++i) pool_.emplace_back([this, i] { serve(static_cast<std::size_t>(i)); });
  }
  ~Workers() {
    stop_ = true;
    start_.fetch_add(1, std::memory_order_release);
    start_.notify_all();
    for (auto& thread : pool_) thread.join();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t size() const { return pool_.size() + 1; }

  /// Calls body(worker, index) for every index below `count`; worker w takes the w-th of equal ranges.
  /// Serial when there are fewer than `serial_below` indices.
  template <class Body>
  void run(std::size_t count, std::size_t serial_below, const Body& body) {
    if (pool_.empty() || count < serial_below || count < 2) {
      for (std::size_t i = 0; i < count; ++i) body(0, i);
      return;
    }
    context_ = &body, count_ = count;
    call_ = [](const void* context, std::size_t worker, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) (*static_cast<const Body*>(context))(worker, i);
    };
    pending_.store(pool_.size(), std::memory_order_relaxed);
    start_.fetch_add(1, std::memory_order_release);
    start_.notify_all();
    work(0);
    while (const auto left = pending_.load(std::memory_order_acquire)) spin_or_wait(pending_, left);
  }

 private:
  static void spin_or_wait(std::atomic<std::size_t>& word, std::size_t old) {
    for (int i = 0; i < 2000; ++i)
      if (word.load(std::memory_order_acquire) != old) return;
    word.wait(old, std::memory_order_acquire);
  }
  void work(std::size_t worker) {
    call_(context_, worker, count_ * worker / size(), count_ * (worker + 1) / size());
  }
  void serve(std::size_t worker) {
    for (std::size_t seen = 0;;) {
      while (start_.load(std::memory_order_acquire) == seen) spin_or_wait(start_, seen);
      ++seen;
      if (stop_) return;
      work(worker);
      if (pending_.fetch_sub(1, std::memory_order_acq_rel) == 1) pending_.notify_all();
    }
  }

  std::vector<std::thread> pool_;
  std::atomic<std::size_t> start_{0}, pending_{0};
  std::atomic<bool> stop_{false};
  void (*call_)(const void*, std::size_t, std::size_t, std::size_t) = nullptr;
  const void* context_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace netloft
