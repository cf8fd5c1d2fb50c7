// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/stored_result.hpp"

#include "io/results/file/groups.hpp"
#include "io/results/file/no_number.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace netloft::results {

namespace {

constexpr std::ptrdiff_t kDeepest = 16;  // of groups within groups: one that holds itself has no end
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

StoredResult::StoredResult(const std::filesystem::path& file) : path(file), reader_(file) {
  check_format();
  read_status();
  read_parts();
  read_mesh();
  read_bodies();
  read_fields();
  find_contacts();
  read_scalars("gear/", "gear/", figures);
  read_scalars("scalars/", "", scalars);
  put_in_order("gear", figures);
  put_in_order("scalars", scalars);
  std::vector<NamedScalar> costs;
  read_scalars("cost/", "none/", costs);
  for (const auto& one : costs) cost[one.name] = one;
  read_forces();
  read_surroundings();
  read_series();
  read_convergence();
  read_origins();
}

void StoredResult::check_format() const {
  if (!reader_.has("/netloft"))
    throw formats::FileError(path.string() +
                             " is an HDF5 file, but not a result of netloft: it has no group /netloft");
  reader_.require_known_format();
  if (!reader_.has("/VTKHDF/Points") || !reader_.has("/VTKHDF/Steps"))
    throw formats::FileError(path.string() + " holds no shape: the run ended before its first output");
}

std::string StoredResult::title() const {
  if (!origins.files.empty() && !origins.files.front().first.empty())
    return std::filesystem::path(origins.files.front().first).stem().string();
  return path.stem().string();
}

double StoredResult::known(const std::string& at) const {
  return reader_.has(at) && !reader_.is_group(at) ? reader_.real(at) : kNone;
}

std::string StoredResult::text_or_nothing(const std::string& at) const {
  return reader_.has(at) ? reader_.text(at) : "";
}

std::vector<std::string> StoredResult::strings_or_nothing(const std::string& at) const {
  return reader_.has(at) ? reader_.strings(at) : std::vector<std::string>{};
}

std::vector<double> StoredResult::reals_or_nothing(const std::string& at) const {
  return reader_.has(at) ? reader_.reals(at) : std::vector<double>{};
}

void StoredResult::read_status() {
  const std::string at = kRoot + "status";
  const auto attribute = [&](const char* name) {
    return reader_.has(at) && reader_.has_attribute(at, name) ? reader_.text_attribute(at, name) : "";
  };
  outcome = attribute("outcome");
  sentence = attribute("sentence");
  stability = attribute("stability");
  is_motion = reader_.has(kRoot + "series");
  const std::string gear = kRoot + "gear";
  if (!reader_.has(gear)) return;
  is_half = reader_.has_attribute(gear, "times") && reader_.real_attribute(gear, "times") == 2;
  if (reader_.has_attribute(gear, "headline")) headline = reader_.text_attribute(gear, "headline");
  if (reader_.has_attribute(gear, "footrope")) footrope = reader_.text_attribute(gear, "footrope");
}

void StoredResult::read_parts() {
  const std::string at = kRoot + "parts/";
  const auto names = strings_or_nothing(at + "name"), types = strings_or_nothing(at + "type");
  const auto diameters = reals_or_nothing(at + "diameter"), bars = reals_or_nothing(at + "bar"),
             axes = reals_or_nothing(at + "twine_axes"), sheet = reals_or_nothing(at + "sheet");
  if (axes.empty()) notes.push_back("it was written by an older version, which did not say how twines lie");
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

void StoredResult::read_mesh() {
  times = reader_.times();
  require(!times.empty(), path, "it counts no states");
  stages = strings_or_nothing(kRoot + "stages");
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
          path, "its parts do not fit its mesh");
  for (auto* of : {&mesh.cell_part, &mesh.node_part})
    require(std::all_of(of->begin(), of->end(), [&](auto part) { return part < parts.size(); }), path,
            "it has a part without a number");
  read_cells();
}

void StoredResult::read_cells() {
  const auto connectivity = reader_.integers("/VTKHDF/Connectivity"),
             offsets = reader_.integers("/VTKHDF/Offsets"), types = reader_.integers("/VTKHDF/Types");
  require(offsets.size() == mesh.n_cells + 1 && types.size() == mesh.n_cells, path, "its cells are cut off");
  const bool has_corners = reader_.has("/VTKHDF/CellData/panel_corners");
  if (!has_corners)
    notes.push_back("it was written by an older version, without the places of cells on their panels");
  const auto corners = has_corners ? whole(reader_.field(formats::Location::kCell, "panel_corners", 0),
                                           6 * mesh.n_cells, "places on panels")
                                   : std::vector<double>(6 * mesh.n_cells, kNone);
  const std::size_t count = connectivity.size();
  for (std::size_t c = 0; c < mesh.n_cells; ++c) {
    const auto first = static_cast<std::size_t>(offsets[c]), end = static_cast<std::size_t>(offsets[c + 1]);
    require(first <= end && end <= count && end - first <= 3, path, "its cells are cut off");
    const std::size_t nodes = end - first;
    std::array<std::uint32_t, 3> corner{};
    for (std::size_t k = 0; k < nodes; ++k) {
      const auto node = static_cast<std::size_t>(connectivity[first + k]);
      require(node < mesh.n_points, path, "a cell stands on a node that it has not");
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

void StoredResult::read_bodies() {
  const std::string at = kRoot + "bodies/";
  if (!reader_.has(at)) return;
  const auto names = reader_.strings(at + "name");
  const auto nodes = reader_.integers(at + "origin");
  const auto sides = reals_or_nothing(at + "side");
  require(nodes.size() == names.size(), path, "its rigid bodies are cut off");
  for (std::size_t b = 0; b < names.size(); ++b) {
    const auto origin = static_cast<std::size_t>(nodes[b]);
    require(origin < mesh.n_points, path, "a rigid body is at a node that it has not");
    bodies.push_back({names[b], static_cast<std::uint32_t>(origin), at_or_none(sides, b) < 0, {}});
  }
  if (!reader_.has(at + "outline/body")) return;
  const auto of = reader_.integers(at + "outline/body");
  const auto places = whole(reals_or_nothing(at + "outline/place"), 3 * of.size(), "outlines of bodies");
  for (std::size_t i = 0; i < of.size(); ++i) {
    const auto body = static_cast<std::size_t>(of[i]);
    require(body < bodies.size(), path, "an outline belongs to a body that it has not");
    bodies[body].outline.push_back({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
  }
}

/// As many numbers as the mesh has room for, or the file is damaged.
std::vector<double> StoredResult::whole(std::vector<double> values, std::size_t count,
                                        const std::string& what) const {
  require(values.size() == count, path,
          "its " + what + " holds " + std::to_string(values.size()) + " numbers, its mesh has " +
              std::to_string(count));
  return values;
}

void StoredResult::read_scalars(const std::string& group, const std::string& errors,
                                std::vector<NamedScalar>& into, const std::string& below) {
  const std::string folder = kRoot + group + below;
  if (!reader_.has(folder)) return;
  require(std::count(below.begin(), below.end(), '/') < kDeepest, path, folder + " holds itself");
  for (const auto& member : reader_.list(folder)) {
    const std::string name = below + member, at = kRoot + group + name;
    if (reader_.is_group(at)) {
      read_scalars(group, errors, into, name + "/");
      continue;
    }
    NamedScalar scalar{name, "1", "", reader_.real(at)};
    if (reader_.has_attribute(at, "unit")) scalar.unit = reader_.text_attribute(at, "unit");
    if (reader_.has_attribute(at, "doc")) scalar.doc = reader_.text_attribute(at, "doc");
    scalar.solver_error = known(kErrors + errors + "solver/" + name);
    scalar.mesh_error = known(kErrors + errors + "mesh/" + name);
    scalar.mesh_order = known(kErrors + errors + "mesh_order/" + name);
    scalar.least = known(kSpread + errors + "least/" + name);
    scalar.largest = known(kSpread + errors + "largest/" + name);
    scalar.per_swing = known(kSwing + errors + "per_metre/" + name);
    into.push_back(scalar);
  }
}

/// Names that the file does not list, as in one of an older version, follow by the alphabet.
void StoredResult::put_in_order(const std::string& group, std::vector<NamedScalar>& named) const {
  std::map<std::string, std::size_t> places;
  for (const auto& name : strings_or_nothing(kRoot + "order/" + group)) places.emplace(name, places.size());
  const auto place = [&](const NamedScalar& s) {
    const auto at = places.find(s.name);
    return at == places.end() ? places.size() : at->second;
  };
  std::stable_sort(named.begin(), named.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
}

void StoredResult::read_forces() {
  const std::string at = kRoot + "forces/";
  mesh_note = text_or_nothing(kErrors + "mesh_note");
  node_error = known(kErrors + "nodes");
  swings_most = text_or_nothing(kSwing + "furthest");
  if (!reader_.has(at)) return;
  const auto vector_at = [](const std::vector<double>& rows, std::size_t row) {
    return std::array<double, 3>{rows[3 * row], rows[3 * row + 1], rows[3 * row + 2]};
  };
  for (const auto& load : reader_.list(at)) {
    if (load == "held_name" || load == "balance" || load == "held") continue;
    const auto rows = reader_.reals(at + load);
    for (std::size_t p = 0; p < parts.size() && 3 * p + 2 < rows.size(); ++p)
      part_forces.push_back({parts[p].name, load, vector_at(rows, p), 0});
  }
  const auto names = strings_or_nothing(at + "held_name");
  const auto held = reals_or_nothing(at + "held"), sum = reals_or_nothing(at + "balance");
  for (std::size_t h = 0; h < names.size() && 3 * h + 2 < held.size(); ++h)
    hold_forces.push_back({names[h], vector_at(held, h)});
  if (sum.size() == 3) balance = vector_at(sum, 0);
}

void StoredResult::read_surroundings() {
  if (reader_.has(kRoot + "seabed/depth"))
    bed = StoredBed{known(kRoot + "seabed/depth"), known(kRoot + "seabed/slope_x"),
                    known(kRoot + "seabed/slope_y")};
  if (bed) read_relief();
  const std::string at = kRoot + "bill/";
  if (!reader_.has(at)) return;
  const auto kinds = reader_.strings(at + "kind"), names = reader_.strings(at + "name"),
             of = reader_.strings(at + "part");
  const auto number = reader_.reals(at + "number"), length = reader_.reals(at + "length"),
             diameter = reader_.reals(at + "diameter"), load = reader_.reals(at + "breaking_load"),
             mass = reals_or_nothing(at + "mass"), area = reals_or_nothing(at + "area");
  require(names.size() == kinds.size() && of.size() == kinds.size(), path,
          "its bill of materials is cut off");
  for (std::size_t i = 0; i < kinds.size(); ++i)
    bill.push_back({kinds[i], names[i], of[i], at_or_none(number, i), at_or_none(length, i),
                    at_or_none(diameter, i), at_or_none(load, i), at_or_none(mass, i), at_or_none(area, i)});
}

void StoredResult::read_relief() {
  const std::string at = kRoot + "seabed/relief/";
  if (!reader_.has(at)) return;
  bed->relief_x = reader_.reals(at + "x");
  bed->relief_y = reader_.reals(at + "y");
  require(bed->relief_x.size() > 1 && bed->relief_y.size() > 1, path, "the relief of its bed is cut off");
  for (const auto* places : {&bed->relief_x, &bed->relief_y})
    require(std::is_sorted(places->begin(), places->end(), std::less_equal<>()), path,
            "the places of the relief of its bed do not ascend");
  bed->relief = whole(reader_.reals(at + "height"), bed->relief_x.size() * bed->relief_y.size(), "relief");
}

void StoredResult::read_series(const std::string& below) {
  const std::string folder = kRoot + "series/" + below;
  if (!reader_.has(folder)) return;
  require(std::count(below.begin(), below.end(), '/') < kDeepest, path, folder + " holds itself");
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

void StoredResult::read_convergence() {
  const std::string at = kRoot + "convergence/";
  if (!reader_.has(at)) return;
  convergence.iteration = reader_.integers(at + "iteration");
  convergence.factorisations = reader_.integers(at + "factorisations");
  convergence.residual = reader_.reals(at + "residual");
  convergence.load = reader_.reals(at + "load");
  convergence.note = strings_or_nothing(at + "note");
}

void StoredResult::read_origins() {
  const std::string at = kRoot + "provenance/";
  origins.version = text_or_nothing(at + "version");
  origins.machine = text_or_nothing(at + "machine");
  origins.compiler = text_or_nothing(at + "compiler");
  origins.started = text_or_nothing(at + "started");
  origins.finished = text_or_nothing(at + "finished");
  origins.command = strings_or_nothing(at + "command");
  const auto paths = strings_or_nothing(at + "files/path"), texts = strings_or_nothing(at + "files/text");
  for (std::size_t i = 0; i < paths.size() && i < texts.size(); ++i)
    origins.files.emplace_back(paths[i], texts[i]);
  origins.plan = text_or_nothing(kRoot + "plan");
}

std::optional<std::uint32_t> find_part(const StoredResult& result, const std::string& name) {
  for (std::uint32_t p = 0; p < result.parts.size(); ++p)
    if (result.parts[p].name == name) return p;
  return {};
}

}  // namespace netloft::results
