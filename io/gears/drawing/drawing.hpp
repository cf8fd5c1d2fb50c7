// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <string>

namespace netloft::gears {

/// Draws a plan as an SVG picture in the manner of ISO 3169. The scale of panels is stretched length along
/// the gear and half the stretched width across; their labels are mesh counts, cuttings, mesh size and twine.
/// Edges that are hung on ropes are thick and labelled with the length of rope. A list of ropes, floats and
/// seams, and a scale, follow below.
std::string draw_plan(const NetPlan& plan);

/// Draws the same picture with the triangles of `mesh`, which belongs to the whole `gear` made from `plan`.
std::string draw_mesh(const NetPlan& plan, const Gear& gear, const GearMesh& mesh);

}  // namespace netloft::gears
