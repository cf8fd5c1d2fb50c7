// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/mesh/mesh.hpp"
#include "io/results/file/stored_shape.hpp"

namespace netloft::results {

enum class MeshFormat { own, obj, vtk };

/// The shape of a result as the text of a mesh, so that a result is an input: its nodes where they are in a
/// state, a region for each rope and for each panel of triangles. The lengths of ropes, and what has no place
/// in a mesh (netting gathered in a node, bars of several twines), are written as comments. Throws
/// std::invalid_argument if it has neither ropes nor panels.
std::string mesh_of(const StoredShape& stored, std::size_t state, MeshFormat format = MeshFormat::own);

}  // namespace netloft::results
