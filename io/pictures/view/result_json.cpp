// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/result_json.hpp"

#include "io/pictures/picture/colour_map.hpp"
#include "io/pictures/picture/view_projection.hpp"
#include "io/pictures/view/ground_json.hpp"
#include "io/pictures/view/packed_array.hpp"
#include "io/pictures/view/sweep.hpp"
#include "io/results/file/body_plates.hpp"
#include "io/results/file/catch_body.hpp"
#include "io/results/file/dimensions.hpp"
#include "io/results/file/field_scale.hpp"
#include "io/results/file/ship.hpp"
#include "io/results/text/gear_text.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace netloft::pictures {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinities and no NaN: null.
Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class Numbers>
Json numbers(const Numbers& values) {
  Json all = Json::array();
  for (const auto value : values) all.push_back(json_number(static_cast<double>(value)));
  return all;
}

/// All or nothing: null unless every number is known.
template <class Numbers>
Json known_numbers(const Numbers& values) {
  const bool known = std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  return known ? numbers(values) : Json(nullptr);
}

Json parts_json(const results::StoredResult& result) {
  Json parts = Json::array();
  for (const auto& part : result.parts) {
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

/// The part of each of some cells.
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

/// Positions from the origin, in multiples of a power of two below a millionth of the gear's size: digits
/// beyond those do not deflate.
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

/// The middle of the box around the last state's nodes; of a half on its plane of symmetry.
Origin origin_of(const results::StoredResult& result) {
  const auto points = result.points(result.times.size() - 1);
  Origin origin{};
  for (std::size_t axis = 0; axis < 3 && points.size() >= 3; ++axis) {
    double lo = INFINITY, hi = -INFINITY;
    for (std::size_t i = axis; i < points.size(); i += 3) {
      lo = std::min(lo, points[i]);
      hi = std::max(hi, points[i]);
    }
    if (std::isfinite(lo + hi) && !(axis == 1 && result.is_half)) origin[axis] = std::round((lo + hi) / 2);
  }
  return origin;
}

using Corners = std::vector<std::array<double, 3>>;

Json packed_corners(const Corners& corners, const Origin& origin) {
  std::vector<double> numbers;
  for (const auto& corner : corners) numbers.insert(numbers.end(), corner.begin(), corner.end());
  return packed(shifted(std::move(numbers), origin));
}

/// Boards as they are turned, and the ship.
void put_solids(const results::StoredResult& result, std::size_t state, const Origin& origin, Json& json) {
  Corners plates, hulls;
  for (const auto& plate : results::plates_of(result, state))
    plates.insert(plates.end(), plate.triangles.begin(), plate.triangles.end());
  for (const auto& ship : results::ships_of(result, state)) {
    const auto triangles = results::triangles_of(ship);
    hulls.insert(hulls.end(), triangles.begin(), triangles.end());
  }
  json["plates"] = packed_corners(plates, origin);
  json["hulls"] = packed_corners(hulls, origin);
}

/// Which single node each triangle of the plates belongs to.
Json plate_dots(const results::StoredResult& result) {
  std::vector<std::uint32_t> dots;
  for (const auto& plate : results::plates_of(result, result.times.size() - 1))
    dots.insert(dots.end(), plate.triangles.size() / 3, plate.dot);
  return packed(dots);
}

void put_states(const results::StoredResult& result, const std::vector<std::size_t>& kept, Json& json) {
  const Origin origin = origin_of(result);
  Json states = Json::array(), times = Json::array();
  for (const std::size_t state : kept) {
    Json one = {{"points", packed(shifted(result.points(state), origin))}, {"fields", Json::array()}};
    for (const char* name : {"residual", "reaction"})
      if (const auto values = result.node_field(name, state);
          state + 1 == result.times.size() && !values.empty())
        one[name] = packed(values);
    put_solids(result, state, origin, one);
    for (std::size_t f = 0; f < result.fields.size(); ++f) {
      one["fields"].push_back(packed_as_shown(result.field(result.fields[f].name, state)));
    }
    states.push_back(one);
    times.push_back(json_number(result.times[state]));
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

Json fields_json(const results::StoredResult& result) {
  Json all = Json::array();
  for (const auto& field : result.fields) {
    const auto spreads = results::spreads_of(result, field.name);
    all.push_back({{"name", field.name},
                   {"units", field.units},
                   {"doc", field.doc},
                   {"total", field.is_total},
                   {"linear", scales_json(results::scales_of(spreads, false))},
                   {"log", scales_json(results::scales_of(spreads, true))}});
  }
  return all;
}

Json catch_json(const results::StoredResult& result) {
  const results::CatchBody body = results::catch_body_of(result, result.times.size() - 1);
  if (body.triangles.empty()) return nullptr;
  return {{"triangles", packed(body.triangles)}, {"rim", packed(flat(body.rim))}};
}

/// An end is a node, and whether it is the mirrored one; null: the bed below the other end.
Json end_json(const results::DimensionEnd& end) {
  if (end.where == results::DimensionEnd::Where::bed) return nullptr;
  return {{"node", end.node}, {"mirrored", end.where == results::DimensionEnd::Where::mirrored}};
}

Json dimensions_json(const results::StoredResult& result) {
  Json all = Json::array();
  for (const auto& one : results::dimensions_of(result))
    all.push_back({{"name", one.name}, {"from", end_json(one.from)}, {"to", end_json(one.to)}});
  return all;
}

/// What pictures and pages have in common.
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

Json figures_json(const results::StoredResult& result) {
  Json all = Json::array();
  for (const auto* group : {&result.scalars, &result.figures})
    for (const auto& f : *group)
      all.push_back({{"name", f.name},
                     {"unit", f.unit},
                     {"value", json_number(f.value)},
                     {"error", results::error_text(f)}});
  return all;
}

Json series_json(const results::StoredResult& result, const std::vector<std::size_t>& kept) {
  Json all = Json::array();
  for (const auto& series : result.series) {
    Json values = Json::array();
    for (const std::size_t state : kept)
      values.push_back(state < series.values.size() ? json_number(series.values[state]) : Json(nullptr));
    all.push_back({{"name", series.name}, {"unit", series.unit}, {"values", values}});
  }
  return all;
}

Json result_json(const results::StoredResult& result, std::size_t most_states) {
  const auto kept = kept_states(result.times.size(), most_states);
  Json json = {{"file", result.path.filename().string()},
               {"title", result.title()},
               {"half", result.is_half},
               {"motion", result.is_motion},
               {"answer", result.is_answer()},
               {"dimensions", dimensions_json(result)},
               {"fields", fields_json(result)},
               {"catch", catch_json(result)},
               {"plateDot", plate_dots(result)},
               {"nodeError", json_number(result.node_error)},
               {"parts", parts_json(result)},
               {"ground", ground_json(result)}};
  if (!result.stages.empty()) {
    json["stages"] = Json::array();
    for (const auto state : kept) json["stages"].push_back(result.stages[state]);
  }
  put_mesh(result.mesh, json);
  put_states(result, kept, json);
  json["figures"] = figures_json(result);
  json["series"] = series_json(result, kept);
  json["convergence"] = {{"residual", numbers(result.convergence.residual)},
                         {"load", numbers(result.convergence.load)}};
  return json;
}

/// The setting of a sweep; two results are no sweep.
Varied varied_among(const std::vector<const results::StoredResult*>& results) {
  std::vector<SweepInput> inputs;
  for (const auto* result : results) {
    const auto& [command, files] = std::tie(result->origins.command, result->origins.files);
    inputs.push_back({command, files.empty() ? "" : files.front().second});
  }
  return results.size() > 2 ? varied_setting(inputs) : Varied{};
}

}  // namespace

std::vector<std::size_t> kept_states(std::size_t states, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t n = std::min(states, std::max<std::size_t>(most, 1));
  for (std::size_t i = 0; i < n; ++i) kept.push_back(n == 1 ? states - 1 : i * (states - 1) / (n - 1));
  return kept;
}

std::string results_json(const std::vector<const results::StoredResult*>& results, std::size_t most_states) {
  Json all = Json::array();
  const Varied varied = varied_among(results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    all.push_back(result_json(*results[i], most_states));
    if (varied.name.empty()) continue;
    all.back()["varied"] = varied.name + " = " + varied.values[i];
    all.back()["variedName"] = varied.name + (varied.unit.empty() ? "" : " [" + varied.unit + "]");
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
