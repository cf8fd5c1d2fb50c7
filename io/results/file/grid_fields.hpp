// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "io/formats/hdf5/vtkhdf.hpp"
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>
#include <span>
#include <vector>

namespace netloft::results {

/// A number per cell.
struct CellField {
  formats::FieldSpec spec;
  std::vector<double> values;
};

/// The mesh that ParaView shows of a scene: elements between their own nodes, and
/// elements on single nodes and on bodies.
formats::Mesh make_mesh(const scenes::LoadedScene& loaded, const Assembler& assembler);
/// The rotation vectors of rigid bodies at their origins, NaN elsewhere; nothing where there are no bodies.
std::optional<std::pair<formats::FieldSpec, std::vector<double>>> rotation_field(
    const scenes::LoadedScene& loaded, const Assembler& assembler, std::span<const double> x);
/// Labels of points and cells: the part they belong to, and the position of a point on its panel.
std::vector<formats::StaticField> label_points(const scenes::LoadedScene& loaded);
formats::StaticField label_cells(const scenes::LoadedScene& loaded, const Assembler& assembler);
/// Gathers outputs of all families, those of one name in one field; elements without that output have no
/// value. Elements on the netting of other parts, such as the catch in a cod-end, have no cells of
/// their own: theirs are those between the same nodes. Which these are is found once.
class OutputFields {
 public:
  OutputFields(const scenes::LoadedScene& loaded, const Assembler& assembler);
  std::vector<CellField> gather(const FamilyOutputs& outputs) const;

 private:
  struct Source {
    std::size_t family, output, field;  // the output of a family, and the field it goes to
  };
  std::vector<formats::FieldSpec> specs_;
  std::vector<Source> sources_;
  std::vector<std::vector<std::size_t>> cells_;  // of every family, of its elements
  std::size_t count_ = 0;                        // of cells
};
/// The places of the corners of a cell on the panel of the cell; nodes on seams belong to several panels.
/// Along a twine of diamond netting u = V + U or v = V - U is constant, so that twines can be drawn from it.
formats::StaticField label_corners(const scenes::LoadedScene& loaded, const Assembler& assembler);

}  // namespace netloft::results
