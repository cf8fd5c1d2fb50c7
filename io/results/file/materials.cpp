// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/materials.hpp"
#include "io/results/file/no_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::results {

namespace {

constexpr double kHighLoad =
    0.5;  // of the breaking load: knots and splices take about half of a line's strength

/// Whether a part of the gear is the one of this name in the plan, or its port or starboard copy.
bool is_called(const std::string& part, const std::string& name) {
  return part == name || part == "port-" + name || part == "starboard-" + name;
}

/// The figures `group`/<part>/`what` of all copies of a part.
std::vector<double> figures_of(const StoredResult& result, const std::string& group, const std::string& name,
                               const std::string& what) {
  std::vector<double> values;
  for (const auto& figure : result.figures) {
    if (!figure.name.starts_with(group + "/") || !figure.name.ends_with("/" + what)) continue;
    const std::size_t begin = group.size() + 1, end = figure.name.size() - what.size() - 1;
    if (end > begin && is_called(figure.name.substr(begin, end - begin), name))
      values.push_back(figure.value);
  }
  return values;
}

double sum_of(const std::vector<double>& values) {
  double sum = values.empty() ? kNone : 0;
  for (const double value : values) sum += value;
  return sum;
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? kNone : *std::max_element(values.begin(), values.end());
}

/// The largest tension of the twines of a panel.
double largest_twine_tension(const StoredResult& result, const std::vector<double>& tension,
                             const std::string& name) {
  double largest = kNone;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const auto cell = result.mesh.triangle_cells[t];
    if (cell < tension.size() && is_called(result.parts[result.mesh.cell_part[cell]].name, name) &&
        !(largest >= tension[cell]))
      largest = tension[cell];
  }
  return largest;
}

std::vector<double> newest_tension(const StoredResult& result) {
  for (const auto& field : result.fields)
    if (field.name == "tension") return result.field("tension", result.times.size() - 1);
  return {};
}

}  // namespace

std::vector<Material> materials_of(const StoredResult& result) {
  std::vector<Material> rows;
  const auto tension = newest_tension(result);
  for (const auto& item : result.bill) {
    Material row{item, kNone, kNone, kNone, kNone};
    if (item.kind == "rope") {
      row.length = item.number * item.length;
      row.mass = sum_of(figures_of(result, "ropes", item.name, "mass"));
      row.load = largest_of(figures_of(result, "ropes", item.name, "tension_largest"));
    } else if (item.kind == "netting") {
      row.area = sum_of(figures_of(result, "panels", item.name, "twine_area"));
      row.length = row.area / item.diameter;
      row.mass = sum_of(figures_of(result, "panels", item.name, "mass"));
      row.load = largest_twine_tension(result, tension, item.name);
    } else {
      row.mass = item.number * item.mass;
      row.area = item.number * item.area;
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> load_warnings(const std::vector<Material>& materials) {
  std::vector<std::string> warnings;
  for (const auto& row : materials)
    if (row.utilisation() > kHighLoad)
      warnings.push_back(fmt::format("{} carries {:.4g} N, {:.0f} % of the breaking load of {}{}",
                                     row.item.name, row.load, 100 * row.utilisation(),
                                     row.item.part_name.empty() ? "its material" : row.item.part_name,
                                     row.utilisation() > 1 ? ": it would break" : ""));
  return warnings;
}

}  // namespace netloft::results
