// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <list>
#include <memory>
#include <utility>

namespace netloft::gears {

/// Stores the last few results of a pure function with their inputs. Inputs are compared by value, so that a
/// result is returned only for its own input. Not safe for several threads.
template <class Input, class Result>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}

  /// The result for `input`: a stored one, or that of make(input), which returns a shared pointer. If make()
  /// throws, the exception is passed on and nothing is stored. `From` is a type that can be converted to
  /// `Input`; it is converted only if the result has to be stored.
  template <class From = Input, class Make>
  std::shared_ptr<Result> of(From&& input, const Make& make) {
    const auto same = std::ranges::find_if(kept_, [&](const Kept& one) { return one.first == input; });
    if (same != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, same);
      return same->second;
    }
    std::shared_ptr<Result> result = make(std::as_const(input));
    kept_.emplace_front(std::forward<From>(input), result);
    if (kept_.size() > most_) kept_.pop_back();
    return result;
  }

 private:
  using Kept = std::pair<Input, std::shared_ptr<Result>>;
  std::size_t most_;
  std::list<Kept> kept_;  // the most recently used first
};

}  // namespace netloft::gears
