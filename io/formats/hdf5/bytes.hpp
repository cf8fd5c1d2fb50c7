// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::formats {

static_assert(std::endian::native == std::endian::little,
              "journals are little-endian, and written as they are");

/// Reads the number that begins at byte `place`; the place need not be aligned.
template <class Number>
Number number_at(std::string_view bytes, std::size_t place) {
  Number value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

/// Writes plain data as consecutive bytes: integers and reals as 8 bytes each, arrays and texts with
/// their length before them.
class ByteWriter {
 public:
  void put(std::uint64_t value) { put_raw(&value, sizeof value); }
  void put(double value) { put_raw(&value, sizeof value); }
  void put(std::string_view text) {
    put(std::uint64_t{text.size()});
    put_raw(text.data(), text.size());
  }
  template <class Number>
  void put_array(std::span<const Number> values) {
    put(std::uint64_t{values.size()});
    put_raw(values.data(), values.size_bytes());
  }
  void put_array(const std::vector<double>& values) { put_array(std::span<const double>(values)); }

  void clear() { bytes_.clear(); }
  const std::string& bytes() const { return bytes_; }

 private:
  void put_raw(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

/// Reads the data of a ByteWriter in the same order; throws FileError if the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t integer() { return value<std::uint64_t>(); }
  double real() { return value<double>(); }
  std::string_view text() { return take(integer(), 1); }
  template <class Number>
  std::vector<Number> array() {
    const std::uint64_t count = integer();
    const std::string_view raw = take(count, sizeof(Number));
    std::vector<Number> values(count);
    if (count > 0) std::memcpy(values.data(), raw.data(), raw.size());
    return values;
  }
  std::vector<double> reals() { return array<double>(); }
  /// Skips an array of reals and returns its length.
  std::uint64_t skip_reals() {
    const std::uint64_t count = integer();
    take(count, sizeof(double));
    return count;
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  template <class Value>
  Value value() {
    Value result;
    std::memcpy(&result, take(1, sizeof result).data(), sizeof result);
    return result;
  }
  std::string_view take(std::uint64_t count, std::size_t size);

  std::string_view rest_;
};

}  // namespace netloft::formats
