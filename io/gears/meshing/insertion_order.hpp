// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/plane_predicates.hpp"

#include <cstdint>
#include <vector>

namespace netloft::gears {

/// The indices of points in their order along Hilbert's curve, in which successive points are close together.
/// The points must not all coincide.
std::vector<std::uint32_t> hilbert_order(const std::vector<PlanePoint>& points);

}  // namespace netloft::gears
