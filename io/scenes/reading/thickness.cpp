// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/thickness.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/formats/units/in_metres.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <algorithm>
#include <numeric>

namespace netloft::scenes {

namespace {

double number_of(const Part& part, const KnownParameter& known) {
  return number_or(0, part.parameters, known.name);
}

/// The length of a mesh bar of netting [m]; 0 for other parts. Netting in triangles has it as a datum. In a
/// panel in bars, an element stands for `parallel` twines side by side, each of which is `parallel` mesh bars
/// long.
double bar_of(const Geometry& geometry) {
  if (const auto* bars = find_data(geometry.data, datum::kBarLength))
    return *std::min_element(bars->begin(), bars->end());
  const auto *rest = find_data(geometry.data, datum::kRestLength),
             *parallel = find_data(geometry.data, datum::kParallel);
  return rest && parallel ? rest->front() / parallel->front() : 0;
}

}  // namespace

std::optional<ThicknessFault> thickness_fault(const Part& part, const Geometry& geometry) {
  const double twine = number_of(part, parameter::kTwineDiameter), bar = bar_of(geometry);
  if (bar > 0 && twine >= bar)
    return ThicknessFault{"twine", "diameter = " + formats::in_metres(twine) + ", and bars of " +
                                       formats::in_metres(bar) + ": no mesh can open"};
  const auto* rest = find_data(geometry.data, datum::kRestLength);
  if (!rest || bar > 0) return {};
  const double rope = number_of(part, parameter::kRopeDiameter),
               length = std::accumulate(rest->begin(), rest->end(), 0.0);
  if (rope > 0 && rope >= length)
    return ThicknessFault{
        "rope", "diameter = " + formats::in_metres(rope) + ", and a length of " + formats::in_metres(length)};
  return {};
}

}  // namespace netloft::scenes
