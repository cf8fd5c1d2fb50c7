// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <string>

namespace netloft::pictures {

/// The outlines and names of the panels in their places on the plan, as SVG; in a half model, only the
/// modelled half. An empty text if the result does not contain the places of panels on the plan.
std::string plan_sketch(const results::StoredShape& stored);

}  // namespace netloft::pictures
