// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "io/hdf5/vtkhdf.hpp"
#include "io/report/answer.hpp"
#include "io/scene/loaded_scene.hpp"

#include <vector>

namespace netloft::io {

/// A number of every cell.
struct CellField {
  FieldSpec spec;
  std::vector<double> values;
};

/// What ParaView shows of a scene: elements on nodes of their own, and whatever sits on single nodes.
Mesh make_mesh(const LoadedScene& loaded, const Assembler& assembler);
/// Which part a point or a cell belongs to, and where on a panel a point lies.
std::vector<StaticField> label_points(const LoadedScene& loaded);
StaticField label_cells(const LoadedScene& loaded, const Assembler& assembler);
/// Outputs of all families under one name each; elements without it have none.
std::vector<CellField> gather_outputs(const LoadedScene& loaded, const Assembler& assembler,
                                      const FamilyOutputs& outputs_of);
/// A vector over all dofs, node by node; without what elements share, which is in no place.
std::vector<double> by_node(const LoadedScene& loaded, const Assembler& assembler,
                            const std::vector<double>& v);
/// Where the corners of a cell lie on the panel that the cell belongs to; nodes on seams belong to several
/// panels. Along a twine of diamond netting u = V + U or v = V - U is constant, so that twines can be drawn
/// from it.
StaticField label_corners(const LoadedScene& loaded, const Assembler& assembler);

}  // namespace netloft::io
