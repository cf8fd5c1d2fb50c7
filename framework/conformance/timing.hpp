// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <chrono>
#include <limits>

namespace netloft::conformance {

/// Time of `work` on an object that `prepare` makes for each repeat [ns]. The result is the least time of
/// several repeats, because disturbances only make a measurement longer.
template <class Prepare, class Work>
double least_nanoseconds(Prepare&& prepare, Work&& work) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 15; ++repeat) {
    auto prepared = prepare();
    const auto start = Clock::now();
    work(prepared);
    const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
    least = std::min(least, spent.count());
  }
  return least;
}

/// Mean time of one of many calls [ns].
template <class Call>
double least_nanoseconds_of(Call&& call) {
  static constexpr int kCalls = 100;
  return least_nanoseconds([] { return kCalls; },
                           [&](int calls) {
                             while (calls-- > 0) call();
                           }) /
         kCalls;
}

}  // namespace netloft::conformance
