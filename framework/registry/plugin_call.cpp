// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/plugin_call.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <cstdlib>

namespace netloft {

namespace {

constexpr std::size_t kThreads = 128;
constexpr std::size_t kSignalStack = std::size_t{1} << 16;  // enough for AVX-512 registers and a handler

struct ThreadCalls {
  CallStack calls;
  std::atomic<bool> is_taken{false}, was_taken{false};
  alignas(16) char signal_stack[kSignalStack]{};
};

// The array is initialised with zeros; therefore, pages that are never used take no memory.
constinit ThreadCalls all_calls[kThreads];

/// Reserves an entry for this thread, and releases it when the thread ends.
class ThreadPlace {
 public:
  ThreadPlace() noexcept {
    for (auto& place : all_calls) {
      if (place.is_taken.exchange(true)) continue;
      mine_ = &place;
      mine_->was_taken = true;
      mine_->calls.take_mode_of_host();
      set_signal_stack();
      return;
    }
  }
  ~ThreadPlace() {
    if (!mine_) return;
    if (has_signal_stack_) remove_signal_stack();
    mine_->is_taken = false;
  }
  ThreadPlace(const ThreadPlace&) = delete;
  ThreadPlace& operator=(const ThreadPlace&) = delete;
  CallStack& calls() { return mine_ ? mine_->calls : all_calls[kThreads - 1].calls; }

 private:
  /// Sets a separate stack for signal handlers, unless there is one. A handler needs it to report a stack
  /// overflow.
  void set_signal_stack() {
    stack_t stack{};
    if (sigaltstack(nullptr, &stack) != 0 || !(stack.ss_flags & SS_DISABLE)) return;
    stack = {};
    stack.ss_sp = mine_->signal_stack;
    stack.ss_size = kSignalStack;
    has_signal_stack_ = sigaltstack(&stack, nullptr) == 0;
  }
  void remove_signal_stack() {
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }
  ThreadCalls* mine_ = nullptr;
  bool has_signal_stack_ = false;
};

std::atomic<int> standing_still{0};
thread_local bool may_cross = false;
thread_local CallStack* known = nullptr;

}  // namespace

std::string text_of(const CallFrame& frame) {
  std::string text = frame.type ? frame.type : "the program itself";
  if (frame.what) text += std::string(", ") + frame.what;
  return frame.name ? text + " " + frame.name : text;
}

void CallStack::push(const CallFrame& frame) noexcept {
  const std::uint32_t depth = depth_.load(std::memory_order_relaxed);
  if (depth < kDeepest) {
    Slot& slot = frames_[depth];
    slot.type.store(frame.type, std::memory_order_relaxed);
    slot.what.store(frame.what, std::memory_order_relaxed);
    slot.name.store(frame.name, std::memory_order_relaxed);
    slot.kind.store(frame.kind, std::memory_order_relaxed);
  }
  if (frame.kind == CallFrame::Kind::host)
    callbacks_.store(callbacks_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  depth_.store(depth + 1, std::memory_order_release);
  crossings_.store(crossings_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

void CallStack::pop() noexcept {
  const std::uint32_t depth = depth_.load(std::memory_order_relaxed) - 1;
  if (depth < lowest_.load(std::memory_order_relaxed)) lowest_.store(depth, std::memory_order_relaxed);
  depth_.store(depth, std::memory_order_release);
  crossings_.store(crossings_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

CallFrame CallStack::at(std::uint32_t i) const {
  const Slot& slot = frames_[std::min(i, kDeepest - 1)];
  return {slot.type.load(std::memory_order_relaxed), slot.what.load(std::memory_order_relaxed),
          slot.name.load(std::memory_order_relaxed), slot.kind.load(std::memory_order_relaxed)};
}

CallFrame CallStack::innermost() const {
  const std::uint32_t n = depth();
  return n == 0 ? CallFrame{} : at(n - 1);
}

std::optional<CallFrame> CallStack::innermost_plugin() const {
  for (std::uint32_t i = std::min(depth(), kDeepest); i-- > 0;)
    if (const CallFrame frame = at(i); frame.kind != CallFrame::Kind::host) return frame;
  return {};
}

void CallStack::blame(const char* did, const char* detail) noexcept {
  if (depth_of_blame_ > 0) return;
  for (depth_of_blame_ = std::min(depth(), kDeepest); depth_of_blame_ > 1; --depth_of_blame_)
    if (at(depth_of_blame_ - 1).kind != CallFrame::Kind::host) break;
  depth_of_blame_ = std::max(depth_of_blame_, std::uint32_t{1});
  const CallFrame frame = at(depth_of_blame_ - 1);
  const auto text = [](const char* word) { return word ? word : ""; };
  std::snprintf(blame_, sizeof blame_, "%s %s %s%s%s%s%s", frame.type ? frame.type : "a plugin", did,
                text(frame.what), frame.name ? " " : "", text(frame.name), detail && *detail ? ": " : "",
                text(detail));
}

void CallStack::blame_for_mode() noexcept {
  std::fesetenv(FE_DFL_ENV);  // also resets the x87 registers, which have a mode of their own
  mode_of_host_.set();
  blame("left another floating-point mode (rounding, subnormal numbers or traps) behind in");
}

std::string CallStack::take_blame() {
  std::string text = blame_;
  blame_[0] = 0;
  depth_of_blame_ = 0;
  return text;
}

void PluginCall::end_after_jump() noexcept {
  while (calls_.depth() > depth_ + 1) calls_.pop();
  calls_.blame("jumped over functions of the program (longjmp) in");
  std::abort();
}

std::string take_broken_rule() {
  CallStack& calls = calls_of_this_thread();
  return calls.has_blame(calls.depth()) ? calls.take_blame() : std::string();
}

bool take_broken_rule(std::span<char> text) noexcept {
  if (!text.empty()) text.back() = 0;
  const std::string broken = take_broken_rule();
  if (!broken.empty() && !text.empty()) std::snprintf(text.data(), text.size(), "%s", broken.c_str());
  return !broken.empty();
}

CallStack& calls_of_this_thread() noexcept {
  if (known) return *known;
  static thread_local ThreadPlace place;
  return *(known = &place.calls());
}

const CallStack* known_calls_of_this_thread() noexcept { return known; }

std::vector<CallStack*> calls_of_all_threads() {
  std::vector<CallStack*> all;
  for (auto& place : all_calls)
    if (place.was_taken) all.push_back(&place.calls);
  return all;
}

void stop_others_at_the_boundary() noexcept {
  may_cross = true;
  detail::boundary_closed = true;
}

int threads_at_the_boundary() noexcept { return standing_still; }

namespace detail {

std::atomic<bool> boundary_closed{false};

void wait_if_boundary_closed() noexcept {
  if (may_cross) return;
  ++standing_still;
  for (;;) pause();
}

}  // namespace detail

}  // namespace netloft
