// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/floating_point_mode.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace netloft {

/// A call that a thread is making. If a plugin crashes or never returns, a signal handler or another thread
/// reads from it which function of the plugin was called.
struct CallFrame {
  // Whose code is running: that of the host, of an element, or of a method (solver, strategy …). Methods call
  // the host in turn.
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
  /// Least depth since the last call of watch_depth(). Calls at a smaller depth have been running all the
  /// time since.
  std::uint32_t lowest() const { return lowest_.load(std::memory_order_relaxed); }
  void watch_depth() { lowest_.store(depth(), std::memory_order_relaxed); }
  CallFrame at(std::uint32_t i) const;
  /// The innermost call; its kind is `host` if no plugin is running.
  CallFrame innermost() const;
  /// The innermost call into a plugin that has not returned yet, even if the plugin is calling back into the
  /// host; nullopt if no plugin is being called.
  std::optional<CallFrame> innermost_plugin() const;

  // The functions below are for the thread of this stack only.
  /// Notes that the innermost plugin broke a rule of the plugin interface. `did` is a phrase such as "let an
  /// exception out of", and `detail` the text of the exception, if any. Until take_blame(), only the first
  /// note is kept.
  void blame(const char* did, const char* detail = nullptr) noexcept;
  /// Whether the blamed plugin was called at a depth greater than `depth`. A plugin that was called at a
  /// smaller depth is still running; its call asks again when it ends.
  bool has_blame(std::uint32_t depth) const { return depth_of_blame_ > depth; }
  const char* blame_text() const { return blame_; }
  /// Returns the note as a sentence and deletes it. Example: "evil/weight let an exception out of term pull:
  /// no stiffness".
  std::string take_blame();
  /// Restores the floating-point mode of the host. If another mode was set, blames the innermost plugin.
  void restore_mode() noexcept {
    if (FloatingPointMode::now() != mode_of_host_) [[unlikely]]
      blame_for_mode();
  }

  /// Stores the present floating-point mode as the mode of the host. A thread does this only once, before its
  /// first call of a plugin, because reading the mode before every call would take as long as the check after
  /// every call.
  void take_mode_of_host() noexcept { mode_of_host_ = FloatingPointMode::now(); }

 private:
  void blame_for_mode() noexcept;
  struct Slot {
    std::atomic<const char*> type{nullptr}, what{nullptr}, name{nullptr};
    std::atomic<CallFrame::Kind> kind{CallFrame::Kind::host};
  };
  Slot frames_[kDeepest];
  std::atomic<std::uint32_t> depth_{0}, lowest_{0};
  std::atomic<std::uint64_t> crossings_{0}, callbacks_{0};
  FloatingPointMode mode_of_host_;
  std::uint32_t depth_of_blame_ = 0;  // zero: there is no blame
  char blame_[256] = "";
};

/// The calls of this thread. The first use sets a separate stack for signal handlers. The reference remains
/// valid. All threads beyond the first 128 share one object.
CallStack& calls_of_this_thread() noexcept;
/// The calls of this thread, for signal handlers, which may not allocate; nullptr if the thread made no call
/// yet.
const CallStack* known_calls_of_this_thread() noexcept;
/// The call stacks of all threads that have made a call, in the order of their first calls.
std::vector<CallStack*> calls_of_all_threads();

/// Stops every other thread for ever, as soon as it enters or leaves a plugin. Afterwards, only this thread
/// accesses the data that the host uses during calls of plugins.
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
  PluginCall(const CallFrame& frame) noexcept : calls_(calls_of_this_thread()), depth_(calls_.depth()) {
    calls_.push(frame);
  }
  ~PluginCall() {
    calls_.pop();
    if (detail::boundary_closed.load(std::memory_order_relaxed)) detail::wait_if_boundary_closed();
  }
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

  void blame_exception(const char* what) noexcept { calls_.blame("let an exception out of", what); }
  /// Whether the plugin has kept the rules of the plugin interface in the call that has ended. Restores the
  /// host's floating-point mode. Ends the program if the plugin jumped over functions of the host (longjmp),
  /// because the state of the host is then unknown.
  bool kept_the_rules() noexcept {
    if (calls_.depth() != depth_ + 1) [[unlikely]]
      end_after_jump();
    calls_.restore_mode();
    return !calls_.has_blame(depth_);
  }

 private:
  [[noreturn]] void end_after_jump() noexcept;
  CallStack& calls_;
  std::uint32_t depth_;
};

/// Calls a function of a plugin. Returns its result, or `failed` if the plugin broke a rule of the plugin
/// interface: if it let an exception out, or left another floating-point mode, which is restored.
/// take_broken_rule() then returns a sentence about the broken rule. A plugin that ends the thread ends the
/// program.
template <class Body>
std::invoke_result_t<Body> call_plugin(const CallFrame& frame, std::invoke_result_t<Body> failed,
                                       Body&& body) noexcept {
  PluginCall call(frame);
  try {
    const auto result = body();
    return call.kept_the_rules() ? result : failed;
  } catch (const std::exception& e) {
    call.blame_exception(e.what());
  } catch (...) {
    call.blame_exception(nullptr);
  }
  call.kept_the_rules();
  return failed;
}

/// Returns a sentence about the first rule that a plugin broke on this thread since the last call of this
/// function; empty if no rule was broken. The plugin need not be the one that was called last: it may be a
/// law that an element called. Ignores plugins that are still running.
std::string take_broken_rule();
/// Writes the sentence of take_broken_rule() into `text`, and returns whether there was one. If there was
/// none, `text` keeps what a plugin wrote, but its last byte is set to zero.
bool take_broken_rule(std::span<char> text) noexcept;

/// Records that a plugin has called the host during the lifetime of the object. The host computes in its own
/// floating-point mode.
class HostCall {
 public:
  HostCall() noexcept : calls_(calls_of_this_thread()) {
    if (detail::boundary_closed.load(std::memory_order_relaxed)) detail::wait_if_boundary_closed();
    if (calls_.depth() > 0) calls_.restore_mode();
    calls_.push({});
  }
  ~HostCall() { calls_.pop(); }
  HostCall(const HostCall&) = delete;
  HostCall& operator=(const HostCall&) = delete;

 private:
  CallStack& calls_;
};

}  // namespace netloft
