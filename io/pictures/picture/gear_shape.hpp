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
  std::optional<results::StoredField> field;  // what is coloured; nothing: the part
  results::FieldScales scales;
  std::vector<double> values;                     // by cell
  std::vector<std::array<double, 3>> at_corners;  // by triangle; of netting these are shown
  results::CatchBody fish;
  std::vector<results::BodyPlate> plates;
  std::vector<Point3> hulls;  // of ships: corners of triangles

  /// The colour of a value on some kind of cell; that of a part where no field is shown.
  Colour colour(results::CellKind kind, std::uint32_t cell, double value) const;
  Colour colour_of_cell(results::CellKind kind, std::uint32_t cell) const {
    return colour(kind, cell, value_of(cell));
  }
  /// The colour of a rigid body.
  Colour colour_of_plate(const results::BodyPlate& plate) const;
  /// Whether single nodes that only touch the bed are shown: where nothing else has the field.
  bool shows_contacts() const;

 private:
  double value_of(std::uint32_t cell) const;
};

/// How values become colours.
struct Colouring {
  std::string field;  // a name of result.fields, "part", or empty for the first that there is
  bool is_logarithmic = false;
  bool by_element = false;  // netting in the values of its triangles, not in means at their corners
};

/// Throws std::invalid_argument with a sentence for a field that the result has not.
GearShape shape_of(const results::StoredShape& stored, std::size_t state, const Colouring& colouring);

/// The parts for which a picture has room: netting alone; boards and other bodies, too; bridles, warps and
/// ship, too.
enum class Framing { netting, boards, all };

/// "netting", "boards", "all"; nothing for other names.
std::optional<Framing> framing_called(const std::string& name);

/// Points that a picture has to hold, of a half model mirrored, too; everything if there is no netting.
std::vector<Point3> extent_of(const GearShape& shape, Framing framing);

}  // namespace netloft::pictures
