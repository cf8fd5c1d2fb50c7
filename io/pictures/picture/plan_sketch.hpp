// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <string>

namespace netloft::pictures {

/// The outlines and names of the panels in their places on the plan, as SVG; only the modelled half of a half
/// model. An empty text if the result does not say where the panels are on the plan.
std::string plan_sketch(const results::StoredShape& stored);

}  // namespace netloft::pictures
