// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace netloft::formats {

/// The SI value of a text such as "10 mm", or a sentence that explains why the text has none.
struct Quantity {
  double value = 0;   // finite value in the requested unit
  std::string error;  // empty if the value is valid
  std::string hint;   // the cure, if one is known
  bool ok() const { return error.empty(); }
};

/// Reads a number with a unit: "10 mm", "-5N", "1.5e-3 m", "3 kn", "0.001 N.m/rad", "5 %", "1025 kg/m3".
/// `si_unit` is the unit of the result: "m", "N", "kg/m3", "rad", "1" for a pure number. Dimensions must
/// agree, and an angle is not a pure number. Several threads may call this.
Quantity to_si(std::string_view text, std::string_view si_unit);

/// A number and its unit as written: "2.5 kn" gives 2.5 and "kn", "0.2" gives 0.2 and "".
struct WrittenQuantity {
  double number = 0;
  std::string unit;   // a unit that to_si() accepts
  std::string error;  // empty if number and unit are valid
  std::string hint;
  bool ok() const { return error.empty(); }
};
WrittenQuantity read_as_written(std::string_view text);

/// The name of a quantity in `unit`, with its article: "a force" for "N"; a unit without a name is "a value".
std::string dimension_name(std::string_view unit);

/// The shortest decimal number from which `value` is read again.
std::string format(double value);
/// The value as text, followed by its unit unless that is "1".
std::string format(double value, std::string_view unit);

}  // namespace netloft::formats
