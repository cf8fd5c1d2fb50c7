// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/plugin_call.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

namespace netloft {

/// A fixed set of threads that divide the indices of a loop among themselves. Allocates nothing after
/// construction. The calling thread works as well. Each index goes to the first thread that is free, so that
/// no thread waits for another one that starts late or gets no core.
class Workers {
 public:
  explicit Workers(int threads) {
    pool_.reserve(static_cast<std::size_t>(threads > 1 ? threads - 1 : 0));
    try {
      for (int i = 1; i < threads; ++i) pool_.emplace_back([this, i] { serve(static_cast<std::size_t>(i)); });
    } catch (const std::system_error&) {
      // Ignored: the system has no more threads, and the result is bit-identical with fewer.
    }
    while (ready_.load(std::memory_order_acquire) < pool_.size()) std::this_thread::yield();
  }
  ~Workers() {
    stop_ = true;
    open(0);
    for (auto& thread : pool_) thread.join();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t size() const { return pool_.size() + 1; }

  /// Calls body(worker, index) for every index below `count` and returns when all are done. Runs serially if
  /// there are fewer than `serial_below` indices.
  template <class Body>
  void run(std::size_t count, std::size_t serial_below, const Body& body) {
    if (pool_.empty() || count < serial_below || count < 2 || count > kMask) {
      for (std::size_t i = 0; i < count; ++i) body(0, i);
      return;
    }
    context_ = &body;
    call_ = [](const void* context, std::size_t worker, std::size_t i) {
      (*static_cast<const Body*>(context))(worker, i);
    };
    done_.store(0, std::memory_order_relaxed);
    open(count);
    while (take_one(0)) {
    }
    while (done_.load(std::memory_order_acquire) != count) pause();
  }

 private:
  // The ticket holds the number of the loop, the count of its indices and the next index. One atomic
  // operation therefore takes an index of a known loop, and no loop ends before all its indices are done.
  static constexpr std::uint64_t kBits = 24, kMask = (1u << kBits) - 1;
  static std::size_t count_of(std::uint64_t ticket) { return ticket >> kBits & kMask; }
  static std::size_t index_of(std::uint64_t ticket) { return ticket & kMask; }
  // Number of pauses after which a waiting thread goes to sleep. This many pauses take about as long as the
  // system needs to wake a thread. Waiting for this time before sleeping costs at most twice as much as if
  // the thread had known in advance how long it would have to wait (A. Karlin, M. Manasse, L. McGeoch and S.
  // Owicki, Competitive randomized algorithms for nonuniform problems, 1990). Measured on two cores of an AMD
  // EPYC: a pause takes 24 ns, and a thread wakes 21 us after it is called (median of 2000; the fastest tenth
  // takes up to 18 us), which is 900 pauses. Other processors differ. No bench prints these figures.
  static constexpr int kSpins = 1000;

  static void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("isb" ::: "memory");  // `yield` does nothing on most of these processors
#endif
  }
  void open(std::size_t count) {
    ticket_.store(++loop_ << 2 * kBits | static_cast<std::uint64_t>(count) << kBits,
                  std::memory_order_release);
    ticket_.notify_all();
  }
  bool take_one(std::size_t worker) {
    std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
    if (index_of(ticket) >= count_of(ticket)) return false;
    ticket = ticket_.fetch_add(1, std::memory_order_acq_rel);
    if (index_of(ticket) >= count_of(ticket)) return false;
    call_(context_, worker, index_of(ticket));
    done_.fetch_add(1, std::memory_order_acq_rel);
    return true;
  }
  void serve(std::size_t worker) {
    calls_of_this_thread();  // allocates this thread's record of plugin calls here, outside of iterations
    ready_.fetch_add(1, std::memory_order_release);
    while (!stop_) {
      while (take_one(worker)) {
      }
      std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
      for (int i = 0; i < kSpins && index_of(ticket) >= count_of(ticket) && !stop_; ++i) {
        pause();
        ticket = ticket_.load(std::memory_order_acquire);
      }
      if (index_of(ticket) >= count_of(ticket) && !stop_) ticket_.wait(ticket, std::memory_order_acquire);
    }
  }

  std::vector<std::thread> pool_;
  std::atomic<std::uint64_t> ticket_{0};
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> ready_{0};
  std::uint64_t loop_ = 0;
  void (*call_)(const void*, std::size_t, std::size_t) = nullptr;
  const void* context_ = nullptr;
};

}  // namespace netloft
