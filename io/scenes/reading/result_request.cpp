// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/result_request.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/scenes/reading/part_names.hpp"

#include <netloft/attitude.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace netloft::scenes {

namespace {

const std::vector<std::string> kHow = {"min", "max", "mean", "sum", "range"};

/// A quantity of nodes that can be requested by `take`.
struct NodeQuantity {
  const char *name, *unit, *doc;
  ResultRequest::Source source;
  int axis;
};

using Source = ResultRequest::Source;
const NodeQuantity kNodeQuantities[] = {
    {"x", "m", "position along x", Source::position, 0},
    {"y", "m", "position along y", Source::position, 1},
    {"z", "m", "height above the water surface", Source::position, 2},
    {"displacement", "m", "distance from the start", Source::displacement, 3},
    {"reaction", "N", "force of the hold on the gear", Source::reaction, 3},
    {"reaction x", "N", "force of the hold on the gear, along x", Source::reaction, 0},
    {"reaction y", "N", "force of the hold on the gear, along y", Source::reaction, 1},
    {"reaction z", "N", "force of the hold on the gear, along z", Source::reaction, 2},
};

/// The angles of rigid bodies (netloft/attitude.hpp).
const NodeQuantity kAngles[] = {
    {"heading", "rad", "angle by which the nose is turned outward", Source::attitude, 0},
    {"heel", "rad", "angle by which the top leans outward", Source::attitude, 1},
    {"trim", "rad", "angle by which the nose is up", Source::attitude, 2},
};

/// Splits "max reaction z" into `how` ("max") and `quantity` ("reaction z"); `how` is empty if the text has
/// no such word.
void split_take(ResultRequest& request) {
  const auto space = request.take.find(' ');
  const std::string first = request.take.substr(0, space);
  if (space != std::string::npos && std::find(kHow.begin(), kHow.end(), first) != kHow.end()) {
    request.how = first;
    request.quantity = request.take.substr(space + 1);
  } else {
    request.quantity = request.take;
  }
}

std::vector<std::string> quantity_names(const ElementType* type) {
  std::vector<std::string> names;
  for (const auto& q : kNodeQuantities) names.push_back(q.name);
  if (type && type->is_on_body())
    for (const auto& q : kAngles) names.push_back(q.name);
  if (type)
    for (const auto& o : type->outputs) names.push_back(o.name);
  return names;
}

bool find_quantity(ResultRequest& request, const ElementType* type) {
  const auto is_wanted = [&](const NodeQuantity& q) {
    if (request.quantity != q.name) return false;
    request.source = q.source;
    request.axis = q.axis;
    request.unit = q.unit;
    request.doc = q.doc;
    return true;
  };
  if (std::any_of(std::begin(kNodeQuantities), std::end(kNodeQuantities), is_wanted)) return true;
  if (type && type->is_on_body() && std::any_of(std::begin(kAngles), std::end(kAngles), is_wanted))
    return true;
  if (type)
    for (const auto& o : type->outputs)
      if (request.quantity == o.name) {
        request.source = Source::output;
        request.unit = o.unit;
        request.doc = o.doc;
        return true;
      }
  return false;
}

bool has_name(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A hint for a wrong `take`: for a word such as "minimum z", for a quantity of elements such as "tension" of
/// an edge, or for a misspelt name such as "min heigth".
std::string take_hint(const ResultRequest& request, const ElementType& type, bool whole) {
  const auto names = quantity_names(whole ? &type : nullptr);
  if (has_name(quantity_names(&type), request.quantity))
    return formats::in_quotes(request.quantity) +
           " is a quantity of elements, not of nodes: take it of the whole part, of = \"" +
           request.of.substr(0, request.of.find('.')) + "\"";
  const auto space = request.quantity.find(' ');
  const std::string first = request.quantity.substr(0, space);
  const std::string rest = space == std::string::npos ? "" : request.quantity.substr(space + 1);
  for (const auto& how : kHow)
    if (request.how.empty() && first.starts_with(how) && has_name(names, rest))
      return "did you mean \"" + how + " " + rest + "\"?";
  if (const auto near = nearest(request.quantity, names))
    return "did you mean \"" + (request.how.empty() ? "" : request.how + " ") + *near + "\"?";
  std::string hint = "write one of min, max, mean, sum, range and one of ";
  for (const auto& name : names) hint += (&name == names.data() ? "" : ", ") + name;
  return hint;
}

double node_value(const ResultRequest& r, std::uint32_t node, const Scene& scene, const Assembler& assembler,
                  const Solution& s) {
  std::array<double, 3> v = r.source == Source::reaction ? assembler.reaction(node, s.residual)
                                                         : assembler.node_position(node, s.x);
  if (r.source == Source::displacement)
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis] -= scene.positions[3 * std::size_t{node} + axis];
  return r.axis == 3 ? std::hypot(v[0], v[1], v[2]) : v[static_cast<std::size_t>(r.axis)];
}

std::vector<double> output_values(const ResultRequest& r, const Assembler& assembler,
                                  const std::vector<std::vector<std::vector<double>>>& outputs) {
  std::vector<double> values;
  for (std::size_t f = 0; f < outputs.size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    const auto [first, last] = family.elements_of(r.part);
    for (std::size_t k = 0; k < family.type().outputs.size(); ++k)
      if (r.quantity == family.type().outputs[k].name)
        for (std::size_t e = first; e < last; ++e) values.push_back(outputs[f][k][e]);
  }
  return values;
}

double reduce(const std::string& how, const std::vector<double>& v) {
  if (v.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto [lo, hi] = std::minmax_element(v.begin(), v.end());
  const double sum = std::accumulate(v.begin(), v.end(), 0.0);
  if (how == "min") return *lo;
  if (how == "max") return *hi;
  if (how == "range") return *hi - *lo;
  if (how == "mean") return sum / static_cast<double>(v.size());
  return sum;
}

}  // namespace

bool understand(ResultRequest& request, const ElementType& type, formats::TableReader& entry) {
  split_take(request);
  const bool whole = request.of.find('.') == std::string::npos;
  if (!find_quantity(request, whole ? &type : nullptr)) {
    entry.error(
        "take",
        formats::in_quotes(request.quantity) + " cannot be taken of " + formats::in_quotes(request.of),
        take_hint(request, type, whole));
    return false;
  }
  const bool many = request.source == Source::output
                        ? !type.is_on_body()
                        : request.source != Source::attitude && request.nodes.size() > 1;
  if (request.how.empty() && many) {
    entry.error("take", formats::in_quotes(request.of) + " has many values; say which of them to take",
                "write \"min " + request.quantity + "\", or max, mean, sum, range");
    return false;
  }
  if (request.how.empty()) request.how = "sum";
  return true;
}

namespace {

double angle_of(const ResultRequest& request, double side, const Assembler& assembler,
                const Solution& solution) {
  const auto psi = assembler.rotation(request.body, solution.x);
  const Attitude at = attitude_of(turned_axes(Vec3<double>{psi[0], psi[1], psi[2]}), side);
  return request.axis == 0 ? at.heading : request.axis == 1 ? at.heel : at.trim;
}

}  // namespace

double value_of(const ResultRequest& request, const LoadedScene& loaded, const Assembler& assembler,
                const Solution& solution, const std::vector<std::vector<std::vector<double>>>& outputs) {
  const Scene& scene = loaded.scene;
  if (request.source == Source::attitude)
    return angle_of(request, loaded.bodies[request.body].side, assembler, solution);
  if (request.source == Source::output)
    return reduce(request.how, output_values(request, assembler, outputs));
  std::vector<double> values;
  for (const auto node : request.nodes)
    values.push_back(node_value(request, node, scene, assembler, solution));
  return reduce(request.how, values);
}

}  // namespace netloft::scenes
