// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/materials.hpp"

#include "framework/parameters/find_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>

namespace netloft::results {

namespace {

// A load above this fraction of the breaking load causes a warning, because knots and splices reduce the
// strength of a line by about a half.
constexpr double kHighLoad = 0.5;

/// The values of the figures `group`/<part>/`what`, where <part> is the part `name` of the plan, or its port
/// or starboard copy.
std::vector<double> figures_of(const std::vector<NamedScalar>& figures, const std::string& group,
                               const std::string& name, const std::string& what) {
  std::vector<double> values;
  for (const auto& figure : figures) {
    if (!figure.name.starts_with(group + "/") || !figure.name.ends_with("/" + what)) continue;
    const std::size_t begin = group.size() + 1, end = figure.name.size() - what.size() - 1;
    if (end > begin && is_called(figure.name.substr(begin, end - begin), name))
      values.push_back(figure.value);
  }
  return values;
}

double sum_of(const std::vector<double>& values) {
  double sum = values.empty() ? NamedScalar::kUnknown : 0;
  for (const double value : values) sum += value;
  return sum;
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? NamedScalar::kUnknown : *std::max_element(values.begin(), values.end());
}

/// The value of the first parameter `TABLE.name`, such as `board.mass`; NaN if there is none.
double number_called(const Part& part, const std::string& name) {
  for (const auto& [parameter, value] : part.parameters)
    if (parameter.ends_with("." + name)) return number_or(NamedScalar::kUnknown, part.parameters, parameter);
  return NamedScalar::kUnknown;
}

scenes::BillItem item_of(const scenes::LoadedScene& loaded, const std::string& name, std::uint32_t part,
                         double number) {
  const Part& body = loaded.scene.parts[part];
  const auto known = loaded.strengths.find(name);
  return {"body",
          name,
          known == loaded.strengths.end() ? "" : known->second.material,
          number,
          NamedScalar::kUnknown,
          NamedScalar::kUnknown,
          NamedScalar::kUnknown,
          number_called(body, "mass"),
          number_called(body, "area")};
}

/// Makes one row for each pair of bodies to port and to starboard, and one for each other body.
std::vector<scenes::BillItem> items_of_bodies(const scenes::LoadedScene& loaded) {
  std::vector<scenes::BillItem> items;
  std::set<std::uint32_t> paired;
  for (const auto& [name, parts] : loaded.gear->pairs) {
    if (parts.empty()) continue;
    items.push_back(item_of(loaded, name, parts.front(), 2));
    paired.insert(parts.begin(), parts.end());
  }
  for (const auto& body : loaded.bodies)
    if (!paired.contains(body.part))
      items.push_back(item_of(loaded, loaded.scene.parts[body.part].name, body.part, 1));
  return items;
}

}  // namespace

bool is_called(const std::string& part, const std::string& name) {
  return part == name || part == "port-" + name || part == "starboard-" + name;
}

std::vector<Material> find_bill(const scenes::LoadedScene& loaded) {
  std::vector<Material> bill;
  if (!loaded.gear) return bill;
  for (const auto& items : {loaded.gear->bill, items_of_bodies(loaded)})
    for (const auto& item : items) bill.push_back({item});
  return bill;
}

void add_loads(const std::vector<NamedScalar>& figures, std::vector<Material>& materials) {
  for (Material& row : materials) {
    const scenes::BillItem& item = row.item;
    if (item.kind == "rope") {
      row.length = item.number * item.length;
      row.mass = sum_of(figures_of(figures, "ropes", item.name, "mass"));
      row.load = largest_of(figures_of(figures, "ropes", item.name, "tension_largest"));
    } else if (item.kind == "netting") {
      row.area = sum_of(figures_of(figures, "panels", item.name, "twine_area"));
      row.length = row.area / item.diameter;
      row.mass = sum_of(figures_of(figures, "panels", item.name, "mass"));
      row.load = largest_of(figures_of(figures, "panels", item.name, "tension_largest"));
    } else {
      row.mass = item.number * item.mass;
      row.area = item.number * item.area;
    }
  }
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
