// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/named_scalar.hpp"

namespace netloft::results {

/// A name in words: "headline height" for "headline_height", "door spread" for "door/spread".
std::string spoken(std::string name);

/// The name of a principal figure (a figure that reports show first) on screen and in pictures: "headline
/// height" for "mouth/headline_height". Empty for other figures.
std::string principal_name(const std::string& figure);

/// Whether the figures include those of a net plan. Figures of a net plan come last in the list, after those
/// of rigid bodies.
bool are_of_plan(const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
