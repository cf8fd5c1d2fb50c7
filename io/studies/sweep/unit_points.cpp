// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/unit_points.hpp"

#include "io/scenes/water/dice.hpp"

#include <boost/random/sobol.hpp>

#include <cassert>
#include <numeric>
#include <utility>

namespace netloft::studies {

namespace {

using Points = std::vector<std::vector<double>>;

/// A number in (0, 1): the middle of one of 2^53 equal intervals, chosen by the upper 53 bits.
double in_open_interval(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53; }

std::vector<std::size_t> shuffled(std::size_t count, scenes::Dice& dice) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[dice.index(i)]);
  return order;
}

Points latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  Points points(count, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    scenes::Dice dice("latin-hypercube " + std::to_string(d), seed);
    const auto order = shuffled(count, dice);
    for (std::size_t i = 0; i < count; ++i)
      points[i][d] =
          (static_cast<double>(order[i]) + in_open_interval(dice.next())) / static_cast<double>(count);
  }
  return points;
}

Points sobol(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  assert(dimensions <= kMostSobolVariables);
  boost::random::sobol_engine<std::uint64_t, 64> engine(dimensions);
  std::vector<std::uint64_t> shift(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d)
    shift[d] = scenes::Dice("sobol " + std::to_string(d), seed).next();
  Points points(count, std::vector<double>(dimensions));
  // The engine skips the origin, the first point of the sequence. It is added here, because sets of 2^k
  // points fill the cube evenly only with the origin.
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t d = 0; d < dimensions; ++d)
      points[i][d] = in_open_interval((i == 0 ? 0 : engine()) ^ shift[d]);
  return points;
}

}  // namespace

Points unit_points(Sampling sampling, std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  if (dimensions == 0) return Points(count);
  return sampling == Sampling::sobol ? sobol(count, dimensions, seed)
                                     : latin_hypercube(count, dimensions, seed);
}

}  // namespace netloft::studies
