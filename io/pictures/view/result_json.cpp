// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/result_json.hpp"

#include "io/pictures/picture/colour_map.hpp"
#include "io/pictures/picture/view_projection.hpp"
#include "io/pictures/view/ground_json.hpp"
#include "io/pictures/view/key_figures.hpp"
#include "io/pictures/view/packed_array.hpp"
#include "io/results/diff/varied_key.hpp"
#include "io/results/file/body_plates.hpp"
#include "io/results/file/catch_body.hpp"
#include "io/results/file/dimensions.hpp"
#include "io/results/file/field_scale.hpp"
#include "io/results/file/ship.hpp"
#include "io/results/text/measured.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace netloft::pictures {

namespace {

using Json = nlohmann::ordered_json;

/// Writes a number; infinities and NaN become null, because JSON has neither.
Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class Numbers>
Json numbers(const Numbers& values) {
  Json all = Json::array();
  for (const auto value : values) all.push_back(json_number(static_cast<double>(value)));
  return all;
}

/// The numbers as an array; null unless all of them are known.
template <class Numbers>
Json known_numbers(const Numbers& values) {
  const bool known = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  return known ? numbers(values) : Json(nullptr);
}

Json parts_json(const results::StoredShape& stored) {
  Json parts = Json::array();
  for (const auto& part : stored.parts) {
    const scenes::SheetPlace& s = part.sheet;
    const std::array<double, 6> sheet{s.x, s.y, s.x_across, s.y_across, s.x_deep, s.y_deep};
    parts.push_back({{"name", part.name},
                     {"type", part.type},
                     {"diameter", json_number(part.diameter)},
                     {"bar", json_number(part.bar)},
                     {"contact", part.is_contact},
                     {"axes", known_numbers(part.twine_axes)},
                     {"sheet", known_numbers(sheet)}});
  }
  return parts;
}

template <std::size_t n>
std::vector<std::uint32_t> flat(const std::vector<std::array<std::uint32_t, n>>& rows) {
  std::vector<std::uint32_t> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// The indices of the parts to which the cells belong.
Json parts_of(const results::StoredMesh& mesh, const std::vector<std::uint32_t>& cells) {
  std::vector<std::uint32_t> parts;
  for (const auto cell : cells) parts.push_back(mesh.cell_part[cell]);
  return packed(parts);
}

void put_mesh(const results::StoredMesh& mesh, Json& json) {
  std::vector<double> corners;
  for (const auto& six : mesh.corners) corners.insert(corners.end(), six.begin(), six.end());
  json["nPoints"] = mesh.n_points;
  json["nCells"] = mesh.n_cells;
  json["tri"] = packed(flat(mesh.triangles));
  json["triUV"] = packed(corners);
  json["triCell"] = packed(mesh.triangle_cells);
  json["triPart"] = parts_of(mesh, mesh.triangle_cells);
  json["bar"] = packed(flat(mesh.bars));
  json["barCell"] = packed(mesh.bar_cells);
  json["barPart"] = parts_of(mesh, mesh.bar_cells);
  json["dot"] = packed(mesh.dots);
  json["dotCell"] = packed(mesh.dot_cells);
  json["dotPart"] = parts_of(mesh, mesh.dot_cells);
  json["nodePart"] = packed(mesh.node_part);
  json["nodeNumber"] = packed(mesh.node_number);
}

using Origin = std::array<double, 3>;

/// Positions relative to the origin, rounded to multiples of a power of two that is below a millionth of the
/// gear's size, because further digits would not compress.
std::vector<double> shifted(std::vector<double> points, const Origin& origin) {
  double size = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] -= origin[i % 3];
    if (std::isfinite(points[i])) size = std::max(size, std::abs(points[i]));
  }
  const double step = size > 0 ? std::exp2(std::floor(std::log2(size * 1e-6))) : 1;
  for (double& x : points) x = std::nearbyint(x / step) * step;
  return points;
}

/// The centre of the bounding box of the last state's nodes; for a half gear, moved onto its plane of
/// symmetry.
Origin origin_of(const results::StoredShape& stored) {
  const auto points = stored.points(stored.times.size() - 1);
  Origin origin{};
  for (std::size_t axis = 0; axis < 3 && points.size() >= 3; ++axis) {
    double lo = INFINITY, hi = -INFINITY;
    for (std::size_t i = axis; i < points.size(); i += 3) {
      lo = std::min(lo, points[i]);
      hi = std::max(hi, points[i]);
    }
    if (std::isfinite(lo + hi) && !(axis == 1 && stored.result.is_half()))
      origin[axis] = std::round((lo + hi) / 2);
  }
  return origin;
}

using Corners = std::vector<std::array<double, 3>>;

Json packed_corners(const Corners& corners, const Origin& origin) {
  std::vector<double> numbers;
  for (const auto& corner : corners) numbers.insert(numbers.end(), corner.begin(), corner.end());
  return packed(shifted(std::move(numbers), origin));
}

/// Adds the triangles of the ship, and of boards in their orientation at this state.
void put_solids(const results::StoredShape& stored, std::size_t state, const Origin& origin, Json& json) {
  Corners plates, hulls;
  for (const auto& plate : results::plates_of(stored, state))
    plates.insert(plates.end(), plate.triangles.begin(), plate.triangles.end());
  for (const auto& ship : results::ships_of(stored, state)) {
    const auto triangles = results::triangles_of(ship);
    hulls.insert(hulls.end(), triangles.begin(), triangles.end());
  }
  json["plates"] = packed_corners(plates, origin);
  json["hulls"] = packed_corners(hulls, origin);
}

/// For each triangle of a board: the index of the board among the elements on single nodes.
Json plate_dots(const results::StoredShape& stored) {
  std::vector<std::uint32_t> dots;
  for (const auto& plate : results::plates_of(stored, stored.times.size() - 1))
    dots.insert(dots.end(), plate.triangles.size() / 3, plate.dot);
  return packed(dots);
}

void put_states(const results::StoredShape& stored, const std::vector<std::size_t>& kept, Json& json) {
  const Origin origin = origin_of(stored);
  Json states = Json::array(), times = Json::array();
  for (const std::size_t state : kept) {
    Json one = {{"points", packed(shifted(stored.points(state), origin))}, {"fields", Json::array()}};
    for (const char* name : {"residual", "reaction"})
      if (const auto values = stored.node_field(name, state);
          state + 1 == stored.times.size() && !values.empty())
        one[name] = packed(values);
    put_solids(stored, state, origin, one);
    for (std::size_t f = 0; f < stored.fields.size(); ++f) {
      one["fields"].push_back(packed_as_shown(stored.field(stored.fields[f].name, state)));
    }
    states.push_back(one);
    times.push_back(json_number(stored.times[state]));
  }
  json["origin"] = origin;
  json["times"] = times;
  json["states"] = states;
}

Json scale_json(const std::optional<results::Scale>& scale) {
  if (!scale) return nullptr;
  return {
      {"lo", scale->lo}, {"hi", scale->hi}, {"below", scale->is_cut_below}, {"above", scale->is_cut_above}};
}

Json scales_json(const results::FieldScales& scales) {
  Json all = Json::array();
  for (const auto& scale : scales) all.push_back(scale_json(scale));
  return all;
}

Json fields_json(const results::StoredShape& stored) {
  Json all = Json::array();
  for (const auto& field : stored.fields) {
    const auto spreads = results::spreads_of(stored, field.name);
    all.push_back({{"name", field.name},
                   {"units", field.units},
                   {"doc", field.doc},
                   {"total", field.is_total},
                   {"linear", scales_json(results::scales_of(spreads, false))},
                   {"log", scales_json(results::scales_of(spreads, true))}});
  }
  return all;
}

Json catch_json(const results::StoredShape& stored) {
  const results::CatchBody body = results::catch_body_of(stored, stored.times.size() - 1);
  if (body.triangles.empty()) return nullptr;
  return {{"triangles", packed(body.triangles)}, {"rim", packed(flat(body.rim))}};
}

/// An end of a dimension line: its node, and whether the node or its mirror image is the end; null for an end
/// on the bed, below the other end.
Json end_json(const results::DimensionEnd& end) {
  if (end.where == results::DimensionEnd::Where::bed) return nullptr;
  return {{"node", end.node}, {"mirrored", end.where == results::DimensionEnd::Where::mirrored}};
}

Json dimensions_json(const results::StoredShape& stored) {
  Json all = Json::array();
  for (const auto& one : results::dimensions_of(stored))
    all.push_back({{"name", one.name}, {"from", end_json(one.from)}, {"to", end_json(one.to)}});
  return all;
}

/// Colours and views, which are the same on pages and in pictures.
Json style_json() {
  Json views = Json::object();
  for (const auto& [name, view] : {std::pair{"side", View::side},
                                   {"top", View::top},
                                   {"front", View::front},
                                   {"oblique", View::oblique}})
    views[name] = {{"azimuth", angles_of(view).azimuth}, {"elevation", angles_of(view).elevation}};
  return {{"stops", colour_stops()}, {"parts", part_colours()}, {"noValue", kNoValue},
          {"float", kFloatColour},   {"catch", kCatchColour},   {"body", kBodyColour},
          {"ship", kShipColour},     {"views", views}};
}

Json figures_json(const results::StoredShape& stored) {
  Json all = Json::array();
  for (const auto* group : {&stored.result.scalars, &stored.result.figures})
    for (const auto& f : *group)
      all.push_back({{"name", f.name},
                     {"unit", f.unit},
                     {"value", json_number(f.value)},
                     {"error", json_number(results::total_error(f))},
                     {"text", card_text(f)}});
  return all;
}

Json series_json(const results::StoredShape& stored, const std::vector<std::size_t>& kept) {
  Json all = Json::array();
  for (const auto& series : stored.series) {
    Json values = Json::array();
    for (const std::size_t state : kept)
      values.push_back(state < series.values.size() ? json_number(series.values[state]) : Json(nullptr));
    all.push_back({{"name", series.name}, {"unit", series.unit}, {"values", values}});
  }
  return all;
}

Json result_json(const results::StoredShape& stored, std::size_t most_states) {
  const auto kept = kept_states(stored.times.size(), most_states);
  Json json = {{"file", std::filesystem::path(stored.result.path).filename().string()},
               {"title", stored.result.title},
               {"half", stored.result.is_half()},
               {"motion", stored.result.motion.has_value()},
               {"answer", stored.result.is_answer()},
               {"dimensions", dimensions_json(stored)},
               {"fields", fields_json(stored)},
               {"catch", catch_json(stored)},
               {"plateDot", plate_dots(stored)},
               {"nodeError", json_number(stored.result.node_error)},
               {"parts", parts_json(stored)},
               {"ground", ground_json(stored)}};
  if (!stored.stages.empty()) {
    json["stages"] = Json::array();
    for (const auto state : kept) json["stages"].push_back(stored.stages[state]);
  }
  put_mesh(stored.mesh, json);
  put_states(stored, kept, json);
  json["figures"] = figures_json(stored);
  json["series"] = series_json(stored, kept);
  std::vector<double> residual, load;
  for (const auto& at : stored.result.iterations) {
    residual.push_back(at.residual);
    load.push_back(at.load);
  }
  json["convergence"] = {{"residual", numbers(residual)}, {"load", numbers(load)}};
  return json;
}

}  // namespace

std::vector<std::size_t> kept_states(std::size_t states, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t n = std::min(states, std::max<std::size_t>(most, 1));
  for (std::size_t i = 0; i < n; ++i) kept.push_back(n == 1 ? states - 1 : i * (states - 1) / (n - 1));
  return kept;
}

std::string results_json(const std::vector<const results::StoredShape*>& results, std::size_t most_states) {
  Json all = Json::array();
  std::vector<const results::Result*> plain;
  for (const auto* stored : results) plain.push_back(&stored->result);
  const results::VariedKey varied = results::find_varied_key(plain);
  for (std::size_t i = 0; i < results.size(); ++i) {
    all.push_back(result_json(*results[i], most_states));
    if (varied.path.empty()) continue;
    all.back()["varied"] = varied.path + " = " + varied.values[i];
    all.back()["variedName"] = varied.path + (varied.unit.empty() ? "" : " [" + varied.unit + "]");
    all.back()["variedBy"] = varied.numbers[i];
  }
  const std::string text = Json{{"style", style_json()}, {"results", std::move(all)}}.dump(
      -1, ' ', true, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

}  // namespace netloft::pictures
