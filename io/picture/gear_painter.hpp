// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/picture/canvas.hpp"
#include "io/picture/projection.hpp"
#include "io/result/stored_result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::io {

/// A state of a result, ready to be painted: positions, and the colour of every cell.
struct GearShape {
  const StoredResult* result = nullptr;
  std::vector<Point3> nodes;
  std::vector<Colour> colours;       // by cell
  std::optional<StoredField> field;  // what is coloured; nothing: the part
  std::optional<ColourScale> scale;
  bool is_cut_below = false;  // there are smaller values than the scale begins with
};

/// `field` is a name of result.fields, "part", or empty for the first that there is. Throws
/// std::invalid_argument with a sentence for a field that the result has not.
GearShape shape_of(const StoredResult& result, std::size_t state, const std::string& field);

/// Points that a picture has to hold: the nodes of netting, or of everything if there is none or
/// `with_ropes`; of a half model mirrored, too.
std::vector<Point3> extent_of(const GearShape& shape, bool with_ropes);

/// Paints netting in twines as far apart as the picture can show, ropes, floats; hidden surfaces are right in
/// every pixel.
Image paint(const GearShape& shape, const Projection& projection, std::size_t width, std::size_t height,
            const Colour& ground);

}  // namespace netloft::io
