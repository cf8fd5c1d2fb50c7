// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace netloft {

/// A call that a thread is making. If a plugin crashes or never returns, a signal handler or another thread
/// reads here which function of the plugin was called.
struct CallFrame {
  // The owner of the code that runs: the host, an element, or a method (solver, strategy …), which calls the
  // host in turn.
  enum class Kind : std::uint32_t { host, element, method };
  const char* type = nullptr;  // component, such as "rope/bar"
  const char* what = nullptr;  // function of the component: "term", "create", "solve"
  const char* name = nullptr;  // name of the term; may be nullptr
  Kind kind = Kind::host;
};

/// Writes a call in words: "rope/bar, term elastic" or "newton/newton, solve".
std::string text_of(const CallFrame& frame);

/// The nested calls of one thread, the outermost first. Only this thread writes, without a lock; other
/// threads may read.
class CallStack {
 public:
  static constexpr std::uint32_t kDeepest = 24;  // number of nested calls that are recorded

  void push(const CallFrame& frame) noexcept;
  void pop() noexcept;

  std::uint32_t depth() const { return depth_.load(std::memory_order_acquire); }
  /// Number of times that a call began or ended. As long as it is unchanged, the same call is running.
  std::uint64_t crossings() const { return crossings_.load(std::memory_order_acquire); }
  /// Number of calls that methods made back to the host.
  std::uint64_t callbacks() const { return callbacks_.load(std::memory_order_relaxed); }
  /// Least depth since the last call of `watch_depth`. The calls below that depth have been running since
  /// then.
  std::uint32_t lowest() const { return lowest_.load(std::memory_order_relaxed); }
  void watch_depth() { lowest_.store(depth(), std::memory_order_relaxed); }
  CallFrame at(std::uint32_t i) const;
  /// The innermost call; a frame of the kind `host` if no plugin is running.
  CallFrame innermost() const;
  /// The innermost call into a plugin that has not returned yet, even if the plugin is calling back into the
  /// host; nullopt if no plugin is being called.
  std::optional<CallFrame> innermost_plugin() const;

 private:
  struct Slot {
    std::atomic<const char*> type{nullptr}, what{nullptr}, name{nullptr};
    std::atomic<CallFrame::Kind> kind{CallFrame::Kind::host};
  };
  Slot frames_[kDeepest];
  std::atomic<std::uint32_t> depth_{0}, lowest_{0};
  std::atomic<std::uint64_t> crossings_{0}, callbacks_{0};
};

/// The calls of this thread. The first use sets a separate stack for signal handlers. The reference remains
/// valid; threads beyond the first 128 share one object and are not distinguished.
CallStack& calls_of_this_thread() noexcept;
/// The calls of this thread, for signal handlers, which may not allocate; nullptr if the thread made no call
/// yet.
const CallStack* known_calls_of_this_thread() noexcept;
/// The call stacks of all threads that have made a call, in the order of their first calls.
std::vector<CallStack*> calls_of_all_threads();

/// Stops every other thread for ever, as soon as it enters or leaves a plugin. This thread then has exclusive
/// access to the data that the host uses during calls of plugins.
void stop_others_at_the_boundary() noexcept;
/// Number of threads that stop_others_at_the_boundary() has stopped so far.
int threads_at_the_boundary() noexcept;

namespace detail {
extern std::atomic<bool> boundary_closed;
void wait_if_boundary_closed() noexcept;
}  // namespace detail

/// Records that this thread runs code of a plugin during the lifetime of the object. Allocates nothing.
class PluginCall {
 public:
  PluginCall(const CallFrame& frame) noexcept : calls_(calls_of_this_thread()) { calls_.push(frame); }
  ~PluginCall() {
    calls_.pop();
    if (detail::boundary_closed.load(std::memory_order_relaxed)) detail::wait_if_boundary_closed();
  }
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

 private:
  CallStack& calls_;
};

/// Records that a plugin has called the host during the lifetime of the object.
class HostCall {
 public:
  HostCall() noexcept : calls_(calls_of_this_thread()) {
    if (detail::boundary_closed.load(std::memory_order_relaxed)) detail::wait_if_boundary_closed();
    calls_.push({});
  }
  ~HostCall() { calls_.pop(); }
  HostCall(const HostCall&) = delete;
  HostCall& operator=(const HostCall&) = delete;

 private:
  CallStack& calls_;
};

}  // namespace netloft
