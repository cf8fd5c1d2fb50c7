// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <string>

namespace netloft::pictures {

/// The net plan of a result as SVG, drawn like that of `netloft draw` from the texts that the result has of
/// its scene and catalogue. No file is opened. Empty without a plan, or if the plan in these texts has
/// errors.
std::string plan_drawing(const results::Result& result);

}  // namespace netloft::pictures
