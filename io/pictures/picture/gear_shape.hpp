// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/colour_map.hpp"
#include "io/pictures/picture/view_projection.hpp"
#include "io/results/file/body_plates.hpp"
#include "io/results/file/catch_body.hpp"
#include "io/results/file/field_scale.hpp"
#include "io/results/file/stored_shape.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::pictures {

/// A state of a result, ready to be painted.
struct GearShape {
  const results::StoredShape* stored = nullptr;
  std::vector<Point3> nodes;
  std::optional<results::StoredField> field;  // the field that is coloured; nullopt: colours show the parts
  results::FieldScales scales;
  std::vector<double> values;                     // values of the cells
  std::vector<std::array<double, 3>> at_corners;  // values at the corners of each triangle, for netting
  results::CatchBody fish;
  std::vector<results::BodyPlate> plates;
  std::vector<Point3> hulls;  // corners of the triangles of ships

  /// The colour of a value on a kind of cell; without a field, the colour of the cell's part.
  Colour colour(results::CellKind kind, std::uint32_t cell, double value) const;
  Colour colour_of_cell(results::CellKind kind, std::uint32_t cell) const {
    return colour(kind, cell, value_of(cell));
  }
  /// The colour of a rigid body.
  Colour colour_of_plate(const results::BodyPlate& plate) const;
  /// Whether the picture shows single nodes that touch the bed: only if no other cells have the field.
  bool shows_contacts() const;

 private:
  double value_of(std::uint32_t cell) const;
};

/// The mapping from values to colours.
struct Colouring {
  std::string field;  // a name in result.fields, "part", or empty for the first field
  bool is_logarithmic = false;
  bool by_element = false;  // whether netting shows the values of its triangles, not means at corners
};

/// Throws std::invalid_argument with a sentence for a field that the result does not have.
GearShape shape_of(const results::StoredShape& stored, std::size_t state, const Colouring& colouring);

/// The parts that must fit in a picture. `netting`: the netting; `boards`: also boards and other bodies;
/// `all`: also bridles, warps and ship.
enum class Framing { netting, boards, all };

/// The framing "netting", "boards" or "all"; nullopt for other names.
std::optional<Framing> framing_called(const std::string& name);

/// The points that must fit in the picture, including mirrored points of a half model. If there is no
/// netting, all points must fit.
std::vector<Point3> extent_of(const GearShape& shape, Framing framing);

}  // namespace netloft::pictures
