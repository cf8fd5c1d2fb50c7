// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string_view>

namespace netloft::scenes {

/// Random numbers that are the same on every machine: SplitMix64 (Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014), with a seed made from a name and a number.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  Dice(std::string_view name, std::uint64_t number);

  std::uint64_t next();
  double uniform(double lo, double hi);                  // a number from lo to hi, hi excluded
  double log_uniform(double lo, double hi);              // lo and hi must be above zero
  std::int64_t whole(std::int64_t lo, std::int64_t hi);  // a number from lo to hi, both ends included
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(next() % count); }

 private:
  std::uint64_t state_;
};

}  // namespace netloft::scenes
