// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/svg.hpp"
#include "io/gears/meshing/gear_mesh.hpp"

namespace netloft::gears {

/// Draws a plan in the manner of ISO 3169, and returns the size of the drawing. The scale of
/// panels is stretched length along the gear and half the stretched width across; their labels are mesh
/// counts, cuttings, mesh size and twine. Edges that are hung on ropes are thick and labelled with the length
/// of rope. A list of ropes, floats and seams, and a scale, follow below.
formats::DrawingSize draw_plan(const NetPlan& plan, formats::LineDrawing& picture);

/// Draws the same picture with the triangles of `mesh`, which belongs to the whole `gear` made from `plan`.
formats::DrawingSize draw_mesh(const NetPlan& plan, const Gear& gear, const GearMesh& mesh,
                               formats::LineDrawing& picture);

}  // namespace netloft::gears
