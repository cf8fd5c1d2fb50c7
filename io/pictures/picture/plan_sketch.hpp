// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <string>

namespace netloft::pictures {

/// The outlines and names of the panels as they lie on the plan, as SVG; of a half model that half. Empty if
/// the result does not say where panels lie.
std::string plan_sketch(const results::StoredShape& stored);

}  // namespace netloft::pictures
