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

/// A field with one number per cell.
struct CellField {
  formats::FieldSpec spec;
  std::vector<double> values;
};

/// The mesh of a scene for ParaView. Its cells are the elements on single nodes, on rigid bodies, and between
/// nodes of their own part. Elements on other parts, such as bending on ropes, are not drawn.
formats::Mesh make_mesh(const scenes::LoadedScene& loaded, const Assembler& assembler);
/// A point field with the rotation vector of each rigid body at its origin, and NaN at other nodes; nullopt
/// if the scene has no bodies.
std::optional<std::pair<formats::FieldSpec, std::vector<double>>> rotation_field(
    const scenes::LoadedScene& loaded, const Assembler& assembler, std::span<const double> x);
/// Fields that label points with their part and their position on its panel, and cells with their part.
std::vector<formats::StaticField> label_points(const scenes::LoadedScene& loaded);
formats::StaticField label_cells(const scenes::LoadedScene& loaded, const Assembler& assembler);
/// Makes cell fields of the element outputs. Outputs with the same name are in one field, even if they belong
/// to different families (element types). Elements without the output of a field have the value NaN. Elements
/// on the netting of other parts, such as the catch in a cod-end, have no cells of their own and use the
/// cells between the same nodes. The constructor finds the cells of all elements.
class OutputFields {
 public:
  OutputFields(const scenes::LoadedScene& loaded, const Assembler& assembler);
  std::vector<CellField> gather(const FamilyOutputs& outputs) const;

 private:
  struct Source {
    std::size_t family, output, field;  // the output of a family that goes into a field
  };
  std::vector<formats::FieldSpec> specs_;
  std::vector<Source> sources_;
  std::vector<std::vector<std::size_t>> cells_;  // [family][element]: cell of the element
  std::size_t count_ = 0;                        // number of cells
};
/// A cell field with the panel coordinates (U, V) of each corner of a cell [meshes]. They are stored by cell,
/// because a node on a seam has different coordinates on each panel. A twine of diamond netting is a line on
/// which u = V + U or v = V - U is constant, so that pictures can draw twines from (U, V).
formats::StaticField label_corners(const scenes::LoadedScene& loaded, const Assembler& assembler);

}  // namespace netloft::results
