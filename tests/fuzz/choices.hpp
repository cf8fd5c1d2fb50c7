// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace netloft::fuzz {

/// An input read as a sequence of choices. After the end of the input, every choice is the first option.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::size_t left() const { return left_; }
  bool flag() { return any<std::uint8_t>() & 1; }
  template <class T>
  T any() {
    T value{};
    const std::size_t count = std::min(left_, sizeof value);
    std::memcpy(&value, data_, count);
    data_ += count, left_ -= count;
    return value;
  }
  /// A whole number from lo to hi, both included.
  template <class T>
  T in(T lo, T hi) {
    using Unsigned = std::make_unsigned_t<T>;
    const Unsigned range = static_cast<Unsigned>(hi) - static_cast<Unsigned>(lo);
    const Unsigned drawn = range < 256 ? any<std::uint8_t>() : any<Unsigned>();
    const bool is_all = range == std::numeric_limits<Unsigned>::max();
    return static_cast<T>(static_cast<Unsigned>(lo) + (is_all ? drawn : drawn % (range + 1)));
  }
  template <class T, std::size_t Count>
  T pick(const T (&from)[Count]) {
    return from[in<std::size_t>(0, Count - 1)];
  }
  /// A number of arbitrary bits, which may be NaN.
  double number() { return any<double>(); }
  std::vector<std::uint8_t> bytes(std::size_t most) {
    const std::size_t count = std::min(most, left_);
    std::vector<std::uint8_t> taken(data_, data_ + count);
    data_ += count, left_ -= count;
    return taken;
  }
  std::string text(std::size_t most) {
    const auto taken = bytes(in<std::size_t>(0, most));
    return {taken.begin(), taken.end()};
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace netloft::fuzz
