// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/stored_shape.hpp"

#include "io/results/file/groups.hpp"
#include "io/results/file/no_number.hpp"
#include "io/results/file/read_result.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace netloft::results {

namespace {

StoredPart nameless_part() {
  StoredPart part;
  part.diameter = part.bar = kNone;
  part.twine_axes.fill(kNone);
  part.sheet = {kNone, kNone, kNone, kNone, kNone, kNone};
  return part;
}

double at_or_none(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : kNone;
}

void require(bool holds, const std::filesystem::path& path, const std::string& what) {
  if (!holds) throw formats::FileError(path.string() + " is damaged: " + what);
}

}  // namespace

StoredShape::StoredShape(const std::filesystem::path& path) : path_(path), reader_(path) {
  result = read_result(reader_, path);
  if (!reader_.has("/VTKHDF/Points") || !reader_.has("/VTKHDF/Steps"))
    throw formats::FileError(path.string() + " holds no shape: the run ended before its first output");
  read_parts();
  read_mesh();
  read_bodies();
  read_fields();
  find_contacts();
  read_bed();
  read_series();
}

double StoredShape::known(const std::string& at) const {
  return reader_.has(at) && !reader_.is_group(at) ? reader_.real(at) : kNone;
}

std::vector<std::string> StoredShape::names_or_nothing(const std::string& at) const {
  return reader_.has(at) ? reader_.names(at) : std::vector<std::string>{};
}

std::vector<double> StoredShape::reals_or_nothing(const std::string& at) const {
  return reader_.has(at) ? reader_.reals(at) : std::vector<double>{};
}

void StoredShape::read_parts() {
  const std::string at = kRoot + "parts/";
  const auto names = names_or_nothing(at + "name"), types = names_or_nothing(at + "type");
  const auto diameters = reals_or_nothing(at + "diameter"), bars = reals_or_nothing(at + "bar"),
             axes = reals_or_nothing(at + "twine_axes"), sheet = reals_or_nothing(at + "sheet");
  for (std::size_t p = 0; p < names.size(); ++p) {
    StoredPart part = nameless_part();
    part.name = names[p];
    part.type = p < types.size() ? types[p] : "";
    part.diameter = at_or_none(diameters, p);
    part.bar = at_or_none(bars, p);
    for (std::size_t k = 0; k < 4; ++k) part.twine_axes[k] = at_or_none(axes, 4 * p + k);
    double* const place[] = {&part.sheet.x,        &part.sheet.y,      &part.sheet.x_across,
                             &part.sheet.y_across, &part.sheet.x_deep, &part.sheet.y_deep};
    for (std::size_t k = 0; k < 6; ++k) *place[k] = at_or_none(sheet, 6 * p + k);
    parts.push_back(part);
  }
}

void StoredShape::read_mesh() {
  times = reader_.times();
  require(!times.empty(), path_, "it counts no states");
  stages = names_or_nothing(kRoot + "stages");
  if (stages.size() != times.size()) stages.clear();
  mesh.n_points = static_cast<std::size_t>(reader_.integer("/VTKHDF/NumberOfPoints"));
  mesh.n_cells = static_cast<std::size_t>(reader_.integer("/VTKHDF/NumberOfCells"));
  constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();
  const auto to_index = [](double value) {
    return value >= 0 && value < kNoIndex ? static_cast<std::uint32_t>(value) : kNoIndex;
  };
  const auto by_cell = reader_.field(formats::Location::kCell, "part", 0);
  for (const double part : by_cell) mesh.cell_part.push_back(to_index(part));
  for (const double part : reader_.field(formats::Location::kPoint, "part", 0))
    mesh.node_part.push_back(to_index(part));
  for (const double number : reader_.field(formats::Location::kPoint, "node", 0))
    mesh.node_number.push_back(to_index(number));
  for (auto* of : {&mesh.cell_part, &mesh.node_part})
    for (const auto part : *of)
      while (part >= parts.size() && part < 100000) parts.push_back(nameless_part());
  require(mesh.cell_part.size() == mesh.n_cells && mesh.node_part.size() == mesh.n_points &&
              mesh.node_number.size() == mesh.n_points,
          path_, "its parts do not fit its mesh");
  for (auto* of : {&mesh.cell_part, &mesh.node_part})
    require(std::all_of(of->begin(), of->end(), [&](auto part) { return part < parts.size(); }), path_,
            "it has a part without a number");
  read_cells();
}

void StoredShape::read_cells() {
  const auto connectivity = reader_.integers("/VTKHDF/Connectivity"),
             offsets = reader_.integers("/VTKHDF/Offsets"), types = reader_.integers("/VTKHDF/Types");
  require(offsets.size() == mesh.n_cells + 1 && types.size() == mesh.n_cells, path_, "its cells are cut off");
  const bool has_corners = reader_.has("/VTKHDF/CellData/panel_corners");
  const auto corners = has_corners ? whole(reader_.field(formats::Location::kCell, "panel_corners", 0),
                                           6 * mesh.n_cells, "places on panels")
                                   : std::vector<double>(6 * mesh.n_cells, kNone);
  const std::size_t count = connectivity.size();
  for (std::size_t c = 0; c < mesh.n_cells; ++c) {
    const auto first = static_cast<std::size_t>(offsets[c]), end = static_cast<std::size_t>(offsets[c + 1]);
    require(first <= end && end <= count && end - first <= 3, path_, "its cells are cut off");
    const std::size_t nodes = end - first;
    std::array<std::uint32_t, 3> corner{};
    for (std::size_t k = 0; k < nodes; ++k) {
      const auto node = static_cast<std::size_t>(connectivity[first + k]);
      require(node < mesh.n_points, path_, "a cell refers to a node that does not exist");
      corner[k] = static_cast<std::uint32_t>(node);
    }
    const auto cell = static_cast<std::uint32_t>(c);
    if (nodes == 3) {
      mesh.triangles.push_back(corner);
      mesh.triangle_cells.push_back(cell);
      std::array<double, 6> uv;
      std::copy_n(corners.begin() + 6 * static_cast<std::ptrdiff_t>(c), 6, uv.begin());
      mesh.corners.push_back(uv);
    } else if (nodes == 2) {
      mesh.bars.push_back({corner[0], corner[1]});
      mesh.bar_cells.push_back(cell);
    } else if (nodes == 1) {
      mesh.dots.push_back(corner[0]);
      mesh.dot_cells.push_back(cell);
    }
  }
}

void StoredShape::read_bodies() {
  const std::string at = kRoot + "bodies/";
  if (!reader_.has(at)) return;
  const auto names = reader_.names(at + "name");
  const auto nodes = reader_.integers(at + "origin");
  const auto sides = reals_or_nothing(at + "side");
  require(nodes.size() == names.size(), path_, "its rigid bodies are cut off");
  for (std::size_t b = 0; b < names.size(); ++b) {
    const auto origin = static_cast<std::size_t>(nodes[b]);
    require(origin < mesh.n_points, path_, "a rigid body refers to a node that does not exist");
    bodies.push_back({names[b], static_cast<std::uint32_t>(origin), at_or_none(sides, b) < 0, {}});
  }
  if (!reader_.has(at + "outline/body")) return;
  const auto of = reader_.integers(at + "outline/body");
  const auto places = whole(reals_or_nothing(at + "outline/place"), 3 * of.size(), "outlines of bodies");
  for (std::size_t i = 0; i < of.size(); ++i) {
    const auto body = static_cast<std::size_t>(of[i]);
    require(body < bodies.size(), path_, "an outline refers to a body that does not exist");
    bodies[body].outline.push_back({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
  }
}

/// Returns the values, or throws FileError if their number does not fit the mesh.
std::vector<double> StoredShape::whole(std::vector<double> values, std::size_t count,
                                       const std::string& what) const {
  require(values.size() == count, path_,
          "its " + what + " holds " + std::to_string(values.size()) + " numbers, its mesh has " +
              std::to_string(count));
  return values;
}

void StoredShape::read_bed() {
  if (!reader_.has(kRoot + "seabed/depth")) return;
  bed = StoredBed{known(kRoot + "seabed/depth"), known(kRoot + "seabed/slope_x"),
                  known(kRoot + "seabed/slope_y")};
  read_relief();
}

void StoredShape::read_relief() {
  const std::string at = kRoot + "seabed/relief/";
  if (!reader_.has(at)) return;
  bed->relief_x = reader_.reals(at + "x");
  bed->relief_y = reader_.reals(at + "y");
  require(bed->relief_x.size() > 1 && bed->relief_y.size() > 1, path_, "the relief of its bed is cut off");
  for (const auto* places : {&bed->relief_x, &bed->relief_y})
    require(std::is_sorted(places->begin(), places->end(), std::less_equal<>()), path_,
            "the places of the relief of its bed do not ascend");
  bed->relief = whole(reader_.reals(at + "height"), bed->relief_x.size() * bed->relief_y.size(), "relief");
}

void StoredShape::read_series(const std::string& below) {
  const std::string folder = kRoot + "series/" + below;
  if (!reader_.has(folder)) return;
  for (const auto& member : reader_.list(folder)) {
    const std::string at = folder + member;
    if (reader_.is_group(at)) {
      read_series(below + member + "/");
      continue;
    }
    series.push_back({below + member,
                      reader_.has_attribute(at, "unit") ? reader_.text_attribute(at, "unit") : "1",
                      reader_.reals(at)});
    series.back().values.resize(std::min(series.back().values.size(), times.size()));
  }
}

std::optional<std::uint32_t> find_part(const StoredShape& shape, const std::string& name) {
  for (std::uint32_t p = 0; p < shape.parts.size(); ++p)
    if (shape.parts[p].name == name) return p;
  return {};
}

}  // namespace netloft::results
