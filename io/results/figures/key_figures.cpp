// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/key_figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

namespace netloft::results {

namespace {

/// Whether the error of a figure is smaller than the figure itself.
bool is_known(const NamedScalar& figure) {
  return !(figure.solver_error + figure.mesh_error >= std::abs(figure.value));
}

}  // namespace

std::vector<const NamedScalar*> key_figures(const Result& result) {
  constexpr std::size_t kMost = 9;
  std::vector<const NamedScalar*> keys;
  const auto add = [&](std::string_view group, std::string_view what) {
    for (const auto& figure : result.figures)
      if (figure.name.starts_with(group) && figure.name.ends_with(what) && is_known(figure))
        keys.push_back(&figure);
  };
  for (const auto* what : {"headline_height", "upper_wing_spread", "lower_wing_spread", "area"})
    add("mouth/", what);
  add("pairs/", "/spread");
  add("drag/all/x", "");
  add("towing/pull", "");
  const auto first_pull = static_cast<std::ptrdiff_t>(keys.size());
  add("rigging/", "/tension_start");
  std::ranges::stable_sort(keys.begin() + first_pull, keys.end(), std::ranges::greater{},
                           [](const NamedScalar* figure) { return figure->value; });
  for (const auto& scalar : result.scalars) keys.push_back(&scalar);
  if (keys.size() > kMost) keys.resize(kMost);
  return keys;
}

}  // namespace netloft::results
