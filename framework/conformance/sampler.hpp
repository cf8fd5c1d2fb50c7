// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/specimen.hpp"

#include <random>
#include <span>

namespace netloft::conformance {

/// Draws parameters of which nothing is known but their table, the same ones for the same seed.
///
/// Parameters: a real is drawn (evenly on a logarithmic scale) from what is usual for its unit, see
/// sampler.cpp, cut to its allowed range; from the range itself when the two do not meet. Integers lie in the
/// lower 100 of their range, choices take every word in turn. Part 0 keeps all defaults; the others keep each
/// with probability 1/2. Tables have 4 rows; their columns are drawn by unit, the first in ascending order;
/// those over two arguments have two values of each.
class ParameterSampler {
 public:
  ParameterSampler(std::span<const netloft_parameter> table, std::uint64_t seed)
      : table_(table), random_(seed) {}

  double uniform(double lo, double hi);
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(uniform(0, double(count))); }
  /// Evenly distributed on the sphere.
  void direction(double (&d)[3]);

  /// Parameters of part number `part`.
  Values parameters(std::size_t part);
  /// Enough parts for every word of every choice.
  std::size_t parts() const;

 protected:
  double real(double lo, double hi, double least, double most);

 private:
  Value value(const netloft_parameter& parameter, std::size_t part);
  Samples rows(const netloft_parameter& parameter);

  std::span<const netloft_parameter> table_;
  std::mt19937_64 random_;
};

/// Of sampled parameters those that have no default.
Values required_of(std::span<const netloft_parameter> table, const Values& sampled);

/// The same for data and states of an element.
///
/// Data: by unit in the same way, lengths from 0.5 m to 2 m, pure numbers from 0.2 to 1.8, one time in four
/// -1, 0 or 1. A pure datum with one number per node is a coordinate of the corners: from -4 to 4, triangles
/// drawn again until they cover at least 2 square units. What `create` refuses is drawn again.
/// Numbers that a part shares are drawn like the coordinates of one more node. Bodies are turned by up to two
/// turns about any axis; their datum `side` is -1 or 1.
/// Positions: nodes scattered evenly in a cube as wide as the element's lengths (times the extent of its
/// corner coordinates) and a factor from 0.1 to 3, so that elements are stretched or slack; one in eight is
/// 1000 times smaller, nearly collapsed. Velocities, currents [m/s] and accelerations [m/s²] are of size 1,
/// shears [1/s] of size 0.1.
class Sampler : public ParameterSampler {
 public:
  Sampler(const ElementType& type, std::uint64_t seed)
      : ParameterSampler(type.parameters, seed), type_(type) {}

  void data(Sample& sample, std::size_t element);
  void state(const Sample& sample, std::size_t element, States& states, std::size_t lane);
  /// Length of an element's data [m], 1 m if it has none, times the extent of its corner coordinates.
  double size(const Sample& sample, std::size_t element) const;
  /// The same without the corner coordinates: the length at which a plain bar is at rest.
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
