// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <string>

namespace netloft::pictures {

/// The outlines and names of the panels at their places on the plan, as SVG. For a half model, it shows only
/// the modelled half. Empty if the result does not contain the places of panels on the plan.
std::string plan_sketch(const results::StoredShape& stored);

}  // namespace netloft::pictures
