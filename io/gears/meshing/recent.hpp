// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <list>
#include <memory>
#include <utility>

namespace netloft::gears {

/// The last few results of a pure function, each with its input. Inputs are compared by value, so that no
/// result is ever taken for that of another input. For one thread.
template <class Input, class Result>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}

  /// The result for `input`: kept, or made by make(input), which returns a shared pointer. What make() throws
  /// passes through, and nothing is kept.
  template <class Make>
  std::shared_ptr<Result> of(Input input, const Make& make) {
    const auto same = std::ranges::find(kept_, input, &Kept::first);
    if (same != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, same);
      return same->second;
    }
    std::shared_ptr<Result> result = make(std::as_const(input));
    kept_.emplace_front(std::move(input), result);
    if (kept_.size() > most_) kept_.pop_back();
    return result;
  }

 private:
  using Kept = std::pair<Input, std::shared_ptr<Result>>;
  std::size_t most_;
  std::list<Kept> kept_;  // the last one that was wanted first
};

}  // namespace netloft::gears
