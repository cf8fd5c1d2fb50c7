// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace netloft {

/// Who is at work on a thread, from the outside in. A plugin that crashes or never returns takes the thread
/// with it; what it was called for stands here, for a signal handler or another thread to read.
struct CallFrame {
  enum class Kind : std::uint32_t { host, element, method };  // a method calls back: solver, strategy …
  const char* type = nullptr;                                 // "rope/bar"
  const char* what = nullptr;                                 // "term", "create", "solve"
  const char* name = nullptr;                                 // of the term; may be null
  Kind kind = Kind::host;
};

/// "rope/bar, term elastic" or "newton/newton, solve".
std::string text_of(const CallFrame& frame);

/// The calls of one thread. Written by it alone, without a lock; others read.
class CallStack {
 public:
  static constexpr std::uint32_t kDeepest = 24;  // what is nested deeper has no name

  void push(const CallFrame& frame) noexcept;
  void pop() noexcept;

  std::uint32_t depth() const { return depth_.load(std::memory_order_acquire); }
  /// Grows with every entry and exit: unchanged, the same call goes on.
  std::uint64_t crossings() const { return crossings_.load(std::memory_order_acquire); }
  /// Calls that methods made back to the host.
  std::uint64_t callbacks() const { return callbacks_.load(std::memory_order_relaxed); }
  /// Least depth since the last `watch_depth`: the frames below it have stood since then.
  std::uint32_t lowest() const { return lowest_.load(std::memory_order_relaxed); }
  void watch_depth() { lowest_.store(depth(), std::memory_order_relaxed); }
  CallFrame at(std::uint32_t i) const;
  /// Who is at work now; a frame of the host where no plugin is.
  CallFrame innermost() const;
  /// The plugin that is at work, or that called the host which is; none: the host alone.
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

/// The calls of this thread, at the first use with a stack of its own for signal handlers. A reference that
/// stays good; threads beyond the first 128 share one and are not told apart.
CallStack& calls_of_this_thread() noexcept;
/// The same for signal handlers; null for a thread that made none.
const CallStack* known_calls_of_this_thread() noexcept;
/// The calls of every thread that made some, the first being whichever came first.
std::vector<CallStack*> calls_of_all_threads();

/// From now on no other thread than this one goes from a plugin to the host, nor back: who tries stands still
/// for ever. What the host was holding when a plugin was called is then this thread's alone.
void stop_others_at_the_boundary() noexcept;
/// Threads that stand still for that reason.
int threads_at_the_boundary() noexcept;

namespace detail {
extern std::atomic<bool> boundary_closed;
void wait_if_boundary_closed() noexcept;
}  // namespace detail

/// This thread runs code of a plugin as long as the object lives. Nothing is allocated.
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

/// A plugin's call has come back to the host as long as the object lives.
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
