// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/part_legend.hpp"

#include "io/pictures/picture/drawn_text.hpp"

#include <fmt/format.h>

namespace netloft::pictures {

namespace {

constexpr double kNameSize = 13, kNameRow = 19, kSquare = 11, kAfterSquare = 5, kAfterColour = 16;

/// Whether each part has something that is drawn.
std::vector<bool> drawn_parts(const GearShape& shape) {
  const results::StoredMesh& mesh = shape.stored->mesh;
  std::vector<bool> is_drawn(shape.stored->parts.size());
  for (const auto* cells : {&mesh.triangle_cells, &mesh.bar_cells, &mesh.dot_cells})
    for (const auto cell : *cells)
      if (const auto part = mesh.cell_part[cell]; !shape.stored->parts[part].is_contact)
        is_drawn[part] = true;
  return is_drawn;
}

}  // namespace

PartLegend::PartLegend(const GearShape& shape, double width) : width_(width) {
  if (shape.field) return;
  const std::vector<bool> is_drawn = drawn_parts(shape);
  std::vector<std::vector<std::string>> names(part_colours().size());
  for (std::size_t part = 0; part < is_drawn.size(); ++part)
    if (is_drawn[part]) names[part % names.size()].push_back(shape.stored->parts[part].name);
  for (std::size_t k = 0; k < names.size(); ++k) add(part_colours()[k], names[k]);
  if (!shape.fish.triangles.empty()) add(kCatchColour, {"catch"});
  if (!shape.hulls.empty()) add(kShipColour, {"ship"});
}

void PartLegend::add(const Colour& colour, const std::vector<std::string>& names) {
  const double length =
      kSquare + kAfterSquare + text_width(fmt::format("{}", fmt::join(names, ", ")), kNameSize);
  if (x_ + length > width_ && length <= width_) x_ = width_;  // begins a new row
  for (std::size_t i = 0; i < names.size(); ++i)
    append(names[i] + (i + 1 < names.size() ? ", " : ""), i == 0 ? std::optional(colour) : std::nullopt);
  x_ += kAfterColour;
}

void PartLegend::append(const std::string& text, const std::optional<Colour>& colour) {
  const double before = colour ? kSquare + kAfterSquare : 0, length = before + text_width(text, kNameSize);
  if (rows_ == 0 || x_ + length > width_) {
    ++rows_;
    x_ = 0;
  }
  entries_.push_back({x_, rows_ - 1, text, colour});
  x_ += length;
}

double PartLegend::height() const { return kNameRow * static_cast<double>(rows_); }

void PartLegend::add_to(SheetLayout& layout, double left, double top) const {
  for (const Entry& entry : entries_) {
    double x = left + entry.x;
    const double base = top + kNameRow * static_cast<double>(entry.row) + kNameSize;
    if (entry.colour) {
      layout.boxes.push_back({x, base - kSquare + 1, kSquare, kSquare, *entry.colour});
      x += kSquare + kAfterSquare;
    }
    layout.words.push_back({x, base, entry.text, kNameSize});
  }
}

}  // namespace netloft::pictures
