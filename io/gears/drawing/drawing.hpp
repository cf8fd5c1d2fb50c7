// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <string>

namespace netloft::gears {

/// The plan as an SVG picture, in the manner of ISO 3169: panels to the scale of stretched length by half of
/// the stretched width, with mesh counts, cuttings, mesh size and twine; edges that are hung on ropes are
/// drawn thick, with the length of rope; below them the list of ropes, floats and seams, and a scale.
std::string draw_plan(const NetPlan& plan);

/// Draws the same picture with the triangles of `mesh`, which belongs to the whole `gear` made from `plan`.
std::string draw_mesh(const NetPlan& plan, const Gear& gear, const GearMesh& mesh);

}  // namespace netloft::gears
