// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <string>

namespace netloft::pictures {

/// The net plan of a result as SVG, like that of `netloft draw`. It is drawn from the texts of the scene and
/// the catalogue that the result contains; no file is opened. Empty if there is no plan, or if the plan has
/// errors.
std::string plan_drawing(const results::Result& result);

}  // namespace netloft::pictures
