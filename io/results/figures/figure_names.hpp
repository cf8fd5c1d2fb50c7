// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/named_scalar.hpp"

namespace netloft::results {

/// A name in words: "headline height" for "headline_height", "door spread" for "door/spread".
std::string spoken(std::string name);

/// The name of a principal figure in reports, on cards and in pictures: "headline height" for
/// "mouth/headline_height". Empty if the figure is not a principal one.
std::string principal_name(const std::string& figure);

/// Whether any figure belongs to a net plan. The figures of rigid bodies, which come first, do not.
bool are_of_plan(const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
