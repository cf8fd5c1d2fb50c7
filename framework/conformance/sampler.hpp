// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/specimen.hpp"

#include <random>
#include <span>

namespace netloft::conformance {

/// Draws parameters from their table alone; the same seed gives the same parameters.
///
/// A real is drawn on a logarithmic scale from the usual values of its unit (sampler.cpp) within its allowed
/// range. If the range contains no usual value, it is drawn from the range itself. Integers are among the
/// lowest 100 of their range, choices use their words in turn. Part 0 has all defaults; in other parts, each
/// parameter has its default with probability 1/2. Tables have 4 rows; their columns are drawn by unit, the
/// first in ascending order. Tables over two arguments have two values of each.
class ParameterSampler {
 public:
  ParameterSampler(std::span<const netloft_parameter> table, std::uint64_t seed)
      : table_(table), random_(seed) {}

  double uniform(double lo, double hi);
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform(0, double(count))); }
  /// A unit vector, uniformly distributed on the sphere.
  void direction(double (&d)[3]);

  /// Parameters of part number `part`.
  Values parameters(std::size_t part);
  /// The number of parts in which every word of every choice occurs at least once.
  std::size_t parts() const;

 protected:
  double real(double lo, double hi, double least, double most);

 private:
  Value value(const netloft_parameter& parameter, std::size_t part);
  Samples rows(const netloft_parameter& parameter);

  std::span<const netloft_parameter> table_;
  std::mt19937_64 random_;
};

/// The sampled parameters that have no default.
Values required_of(std::span<const netloft_parameter> table, const Values& sampled);

/// Draws parameters, data and states of an element.
///
/// Data are drawn by unit like parameters, except for lengths from 0.5 m to 2 m and pure numbers from 0.2 to
/// 1.8. Every fourth pure number is −1, 0 or 1. A datum without unit that has one number per node is a
/// coordinate of the corners, from −4 to 4; triangles are drawn again until they cover at least 2 square
/// units. Data that `create` refuses are drawn again. Unknowns shared by a part are drawn like the
/// coordinates of one more node. Bodies have rotations of up to two turns about any axis; their datum `side`
/// is −1 or 1. Nodes are distributed uniformly in a cube. Its side is size() times a factor from 0.1 to 3, so
/// that elements are stretched or slack; one cube in eight is 1000 times smaller, so that the element has
/// nearly collapsed. Velocities, currents [m/s] and accelerations [m/s²] are of magnitude 1, shears [1/s] of
/// magnitude 0.1.
class Sampler : public ParameterSampler {
 public:
  Sampler(const ElementType& type, std::uint64_t seed)
      : ParameterSampler(type.parameters, seed), type_(type) {}

  void data(Sample& sample, std::size_t element);
  void state(const Sample& sample, std::size_t element, States& states, std::size_t lane);
  /// The length among an element's data [m], or 1 m if no datum is a length, times the extent of the
  /// element's corner coordinates.
  double size(const Sample& sample, std::size_t element) const;
  /// The length among an element's data alone [m], such as the rest length of a bar.
  double length(const Sample& sample, std::size_t element) const;
  bool is_corner(const netloft_datum& datum) const;

 private:
  double number(const netloft_datum& datum);
  void turn(States& states, std::size_t lane);
  void lay_bed(States& states, std::size_t node, double length, std::size_t lane);
  bool covers_nothing(const Sample& sample, std::size_t element) const;

  const ElementType& type_;
};

}  // namespace netloft::conformance
