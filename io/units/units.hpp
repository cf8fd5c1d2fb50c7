// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace netloft::io {

/// What a text such as "10 mm" says in SI, or the sentence why it says nothing.
struct Quantity {
  double value = 0;   // in the unit that was asked for; finite
  std::string error;  // empty: value is good
  std::string hint;   // the cure, where one is known
  bool ok() const { return error.empty(); }
};

/// Reads number and unit: "10 mm", "-5N", "1.5e-3 m", "3 kn", "0.001 N.m/rad", "5 %", "1025 kg/m3".
/// `si_unit` is what the caller computes in: "m", "N", "kg/m3", "rad", "1" for a pure number.
/// Dimensions must agree, and an angle is not a pure number. Safe to call from several threads.
Quantity to_si(std::string_view text, std::string_view si_unit);

/// What a value in `unit` is called, with its article: "N" is "a force"; a unit without a name is "a value".
std::string dimension_name(std::string_view unit);

/// The shortest decimal that reads back as `value`.
std::string format(double value);
/// The same with its unit behind it; the unit "1" is not written.
std::string format(double value, std::string_view unit);

}  // namespace netloft::io
