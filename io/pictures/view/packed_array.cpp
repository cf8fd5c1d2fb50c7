// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/packed_array.hpp"

#include "io/pictures/picture/base64.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace netloft::pictures {

namespace {

/// Reorders bytes: first the first bytes of all numbers, then their second bytes, and so on. Neighbouring
/// bytes are then similar and compress well.
template <class Number>
std::vector<unsigned char> shuffled(std::span<const Number> numbers) {
  std::vector<unsigned char> bytes(numbers.size_bytes());
  const auto* from = reinterpret_cast<const unsigned char*>(numbers.data());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t k = 0; k < sizeof(Number); ++k)
      bytes[k * numbers.size() + i] = from[i * sizeof(Number) + k];
  return bytes;
}

template <class Number>
nlohmann::ordered_json pack(std::span<const Number> numbers, const char* type) {
  return {{"t", type}, {"n", numbers.size()}, {"d", base64(bytes_of(deflated(shuffled(numbers))))}};
}

}  // namespace

nlohmann::ordered_json packed(std::span<const double> values) {
  const std::vector<float> floats(values.begin(), values.end());
  return pack<float>(floats, "f32");
}

nlohmann::ordered_json packed(std::span<const std::uint32_t> values) {
  return pack<std::uint32_t>(values, "u32");
}

float rounded_to_shown(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  if (!std::isfinite(value)) return static_cast<float>(value);
  return static_cast<float>(
      std::ldexp(std::nearbyint(std::ldexp(fraction, kShownBits)), exponent - kShownBits));
}

nlohmann::ordered_json packed_as_shown(std::span<const double> values) {
  std::vector<float> floats(values.size());
  std::transform(values.begin(), values.end(), floats.begin(), rounded_to_shown);
  return pack<float>(floats, "f32");
}

}  // namespace netloft::pictures
