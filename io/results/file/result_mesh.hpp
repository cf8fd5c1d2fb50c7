// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/results/file/stored_shape.hpp"

namespace netloft::results {

enum class MeshFormat { own, obj, vtk };

/// The shape of a result as the text of a mesh that a scene can use: the nodes at their positions in a state,
/// and a region for each rope and for each panel. Comments in the text give the lengths of ropes, and list
/// what a mesh cannot express (netting gathered in a node, bars of several twines). Throws
/// std::invalid_argument if the result has neither ropes nor panels.
std::string mesh_of(const StoredShape& stored, std::size_t state, MeshFormat format = MeshFormat::own);

}  // namespace netloft::results
