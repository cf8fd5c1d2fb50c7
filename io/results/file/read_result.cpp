// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/read_result.hpp"

#include "io/results/figures/materials.hpp"
#include "io/results/file/layout.hpp"
#include "io/results/file/records.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::results {

namespace {

void require_result(const formats::Reader& reader, const std::string& path) {
  if (!reader.has("/netloft"))
    throw formats::FileError(path + " is not a result of netloft: it has no group /netloft");
  reader.require_known_format();
}

std::vector<std::string> names_or_nothing(const formats::Reader& reader, const std::string& at) {
  return reader.has(at) ? reader.names(at) : std::vector<std::string>{};
}

/// Calls `take` for every dataset below a group, at any depth, with its name relative to `group` and its full
/// path.
template <class Take>
void walk(const formats::Reader& reader, const std::string& group, const Take& take,
          const std::string& below = "") {
  if (!reader.has(group + below)) return;
  for (const auto& member : reader.list(group + below)) {
    const std::string name = below + member;
    if (reader.is_group(group + name))
      walk(reader, group, take, name + "/");
    else
      take(name, group + name);
  }
}

/// Puts numbers in the order of a list of names. Numbers that are not in the list follow in alphabetical
/// order. (Older versions wrote no list.)
void put_in_order(const std::vector<std::string>& order, std::vector<NamedScalar>& named) {
  std::map<std::string, std::size_t> places;
  for (const auto& name : order) places.emplace(name, places.size());
  const auto place = [&](const NamedScalar& s) {
    const auto at = places.find(s.name);
    return at == places.end() ? places.size() : at->second;
  };
  std::stable_sort(named.begin(), named.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
}

std::vector<NamedScalar> read_scalars(const formats::Reader& reader, const std::string& path,
                                      const std::string& group, const std::string& errors) {
  std::vector<NamedScalar> scalars;
  walk(reader, kRoot + group + "/", [&](const std::string& name, const std::string& at) {
    NamedScalar scalar{name, "1", "", reader.real(at)};
    if (reader.has_attribute(at, "unit")) scalar.unit = reader.text_attribute(at, "unit");
    if (reader.has_attribute(at, "doc")) scalar.doc = reader.text_attribute(at, "doc");
    visit_errors(RecordReader(reader, path), errors, scalar);
    scalars.push_back(scalar);
  });
  put_in_order(names_or_nothing(reader, kRoot + "order/" + group), scalars);
  return scalars;
}

void read_forces(const formats::Reader& reader, Result& result) {
  const std::string at = kRoot + "forces/";
  if (!reader.has(at)) return;
  const auto row_of = [](const std::vector<double>& rows, std::size_t row) {
    return std::array<double, 3>{rows[3 * row], rows[3 * row + 1], rows[3 * row + 2]};
  };
  const auto parts = names_or_nothing(reader, kRoot + "parts/name");
  for (const auto& term : reader.list(at)) {
    if (term == "held_name" || term == "balance" || term == "held") continue;
    const auto rows = reader.reals(at + term);
    for (std::size_t p = 0; p < parts.size() && 3 * p + 2 < rows.size(); ++p)
      result.part_forces.push_back({parts[p], term, row_of(rows, p)});
  }
  const auto names = names_or_nothing(reader, at + "held_name");
  const auto held = reader.has(at + "held") ? reader.reals(at + "held") : std::vector<double>{};
  for (std::size_t h = 0; h < names.size() && 3 * h + 2 < held.size(); ++h)
    result.hold_forces.push_back({names[h], row_of(held, h)});
  if (const auto sum = reader.has(at + "balance") ? reader.reals(at + "balance") : std::vector<double>{};
      sum.size() == 3)
    result.balance = row_of(sum, 0);
}

/// Reads the last value of every energy series.
void read_energies(const formats::Reader& reader, Motion& motion) {
  walk(reader, kRoot + "series/energy/", [&](const std::string& name, const std::string& at) {
    if (const auto values = reader.reals(at); !values.empty()) motion.energies[name] = values.back();
  });
}

/// The largest tensions of twines as figures, from their tensions in the last state: older versions stored no
/// such figures.
std::vector<NamedScalar> read_twine_tensions(const formats::Reader& reader) {
  std::map<std::string, double> largest;
  if (!reader.has("/VTKHDF/Types") || !reader.has("/VTKHDF/Steps")) return {};
  const auto names = names_or_nothing(reader, kRoot + "parts/name");
  const auto types = reader.integers("/VTKHDF/Types");
  const auto parts = reader.field(formats::Location::kCell, "part", 0);
  for (const auto name : kTensions) {
    if (!reader.has("/VTKHDF/CellData/" + std::string(name))) continue;
    const auto tension = reader.field(formats::Location::kCell, std::string(name), reader.times().size() - 1);
    for (std::size_t c = 0; c < std::min({tension.size(), types.size(), parts.size()}); ++c) {
      if (types[c] != formats::kTriangle || !(parts[c] >= 0 && parts[c] < static_cast<double>(names.size())))
        continue;
      auto& of_part =
          largest.try_emplace(names[static_cast<std::size_t>(parts[c])], NamedScalar::kUnknown).first->second;
      of_part = std::fmax(of_part, tension[c]);
    }
  }
  std::vector<NamedScalar> figures;
  for (const auto& [part, tension] : largest)
    figures.push_back({"panels/" + part + "/tension_largest", "N", "", tension});
  return figures;
}

/// Adds loads to the materials, from the figures of the file and, if it is older, from its fields.
void add_stored_loads(const formats::Reader& reader, Result& result) {
  std::vector<NamedScalar> figures = result.figures;
  if (std::ranges::none_of(figures, [](const auto& f) {
        return f.name.starts_with("panels/") && f.name.ends_with("/tension_largest");
      }))
    for (NamedScalar& figure : read_twine_tensions(reader)) figures.push_back(std::move(figure));
  add_loads(figures, result.materials);
}

void note_age(const formats::Reader& reader, Result& result) {
  if (!reader.has(kRoot + "parts/twine_axes"))
    result.notes.push_back(
        "it was written by an older version, which did not store the directions of twines");
  if (reader.has("/VTKHDF") && !reader.has("/VTKHDF/CellData/panel_corners"))
    result.notes.push_back("it was written by an older version, without the places of cells on their panels");
}

}  // namespace

Result read_result(const formats::Reader& reader, const std::filesystem::path& path) {
  require_result(reader, path.string());
  Result result;
  result.path = path.string();
  RecordReader file(reader, result.path);
  visit_inputs(file, result);
  visit_ending(file, result);
  const std::string scene = result.origins.files.empty() ? "" : result.origins.files.front().path;
  result.title = (scene.empty() ? path : std::filesystem::path(scene)).stem().string();
  if (reader.has("/VTKHDF/NumberOfPoints"))
    result.nodes = static_cast<std::size_t>(reader.integer("/VTKHDF/NumberOfPoints"));
  if (reader.has("/VTKHDF/Steps")) result.states = reader.times().size();
  result.scalars = read_scalars(reader, result.path, "scalars", "");
  result.figures = read_scalars(reader, result.path, "gear", "gear/");
  if (reader.has(kErrors + "mesh_note")) result.mesh_note = reader.text(kErrors + "mesh_note");
  read_forces(reader, result);
  if (reader.has(kRoot + "series")) {
    visit_motion(file, result.motion.emplace());
    read_energies(reader, *result.motion);
  }
  if (!result.materials.empty()) add_stored_loads(reader, result);
  if (!reader.has(kRoot + "cost/work")) result.warnings = load_warnings(result.materials);
  note_age(reader, result);
  return result;
}

Result read_result(const std::filesystem::path& path) { return read_result(formats::Reader(path), path); }

}  // namespace netloft::results
