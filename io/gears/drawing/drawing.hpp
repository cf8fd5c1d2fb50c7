// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/svg.hpp"
#include "io/gears/meshing/gear_mesh.hpp"

namespace netloft::gears {

/// Draws a plan in the manner of ISO 3169, and returns the size of the drawing. Panels are drawn with their
/// stretched length along the gear and half of their stretched width across. Labels of panels show mesh
/// counts, cuttings, mesh size and twine. Edges that are hung on ropes are thick and labelled with the length
/// of rope. Below the panels are a list of ropes, floats and seams, and a scale.
formats::DrawingSize draw_plan(const NetPlan& plan, formats::LineDrawing& picture);

/// Draws the same picture with the triangles of `mesh`, which belongs to the whole `gear` made from `plan`.
formats::DrawingSize draw_mesh(const NetPlan& plan, const Gear& gear, const GearMesh& mesh,
                               formats::LineDrawing& picture);

}  // namespace netloft::gears
