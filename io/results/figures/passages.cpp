// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/passages.hpp"

#include "framework/parameters/find_number.hpp"
#include "framework/registry/element_data.hpp"
#include "framework/registry/element_outputs.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

namespace netloft::results {

namespace {

// Least depth of a passage, relative to the longest side of the triangle: that of layers which lie on each
// other but for the solver's error. The value is chosen.
constexpr double kOfSide = 1e-6;

using Point = std::array<double, 3>;

Point minus(const double* a, const double* b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double times(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Finds the passages of one gear; the member functions are steps in the order of execution.
class PassageFinder {
 public:
  PassageFinder(const Layers& layers, std::span<const double> positions)
      : layers_(layers), positions_(positions), tree_(layers.triangles, positions) {}

  std::vector<Passage> find() {
    std::vector<Layers::Line> lines;
    for (std::size_t t = 0; t < layers_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto side = side_of(layers_.triangles[t][k], layers_.triangles[t][(k + 1) % 3]);
        if (sides_.insert(side).second) lines.push_back({side, layers_.part_of_triangle[t]});
      }
    for (const auto& line : lines) try_line(line);
    for (const auto& bar : layers_.bars) try_line(bar);
    std::vector<Passage> all;
    for (auto& [parts, found] : found_) {
      found.passage.places = found.pierced.size();
      all.push_back(found.passage);
    }
    return all;
  }

 private:
  using Side = std::array<std::uint32_t, 2>;
  static Side side_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }
  const double* x(std::uint32_t node) const { return &positions_[3 * std::size_t{node}]; }

  double gauge(std::uint32_t part) const { return part < layers_.gauge.size() ? layers_.gauge[part] : 0; }

  void try_line(const Layers::Line& line) {
    AxisBox box = AxisBox::none();
    for (const auto end : line.ends) box.include(x(end));
    tree_.visit(box, [&](std::uint32_t t) { try_triangle(line, t); });
  }

  void try_triangle(const Layers::Line& line, std::uint32_t t) {
    if (line.part == layers_.part_of_triangle[t]) return;
    const auto& [a, b, c] = layers_.triangles[t];
    const Point ab = minus(x(b), x(a)), ac = minus(x(c), x(a)), bc = minus(x(c), x(b));
    const Point normal = cross(ab, ac);
    const double area = std::sqrt(times(normal, normal));
    if (!(area > 0)) return;
    const double from = times(normal, minus(x(line.ends[0]), x(a))) / area,
                 to = times(normal, minus(x(line.ends[1]), x(a))) / area;
    const double side = std::sqrt(std::max({times(ab, ab), times(ac, ac), times(bc, bc)}));
    const double depth = std::min(std::abs(from), std::abs(to));
    const double touching =
        std::max(kOfSide * side, 0.5 * (gauge(line.part) + gauge(layers_.part_of_triangle[t])));
    if (!(from * to < 0) || !(depth > touching)) return;
    const double s = from / (from - to);
    Point at;
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] = std::lerp(x(line.ends[0])[axis], x(line.ends[1])[axis], s);
    const Point inside = minus(at.data(), x(a));
    const double v = times(normal, cross(inside, ac)) / (area * area),
                 w = times(normal, cross(ab, inside)) / (area * area);
    if (v >= 0 && w >= 0 && v + w <= 1 && !are_neighbours(line, t)) keep(line.part, t, depth, at);
  }

  /// Whether a line and a triangle share a node, or have nodes that one side joins. Netting on both sides of
  /// a seam is neighbouring, and folds about the seam.
  bool are_neighbours(const Layers::Line& line, std::uint32_t t) const {
    for (const auto end : line.ends)
      for (const auto corner : layers_.triangles[t])
        if (end == corner || sides_.contains(side_of(end, corner))) return true;
    return false;
  }

  void keep(std::uint32_t part, std::uint32_t t, double depth, const Point& at) {
    const std::uint32_t through = layers_.part_of_triangle[t];
    Found& found = found_[{std::min(part, through), std::max(part, through)}];
    found.pierced.insert(t);
    if (depth > found.passage.depth) found.passage = {part, through, 0, depth, at};
  }

  struct Found {
    Passage passage;
    std::set<std::uint32_t> pierced;
  };

  const Layers& layers_;
  std::span<const double> positions_;
  TriangleTree tree_;
  std::set<Side> sides_;                                 // of all triangles
  std::map<std::array<std::uint32_t, 2>, Found> found_;  // by the two parts
};

double gauge_of(const Part& part) {
  if (const auto* bars = find_data(part.data, datum::kBarLength); bars && !bars->empty())
    return bars->front();
  const double* diameter = find_number(part.parameters, scenes::parameter::kRopeDiameter.name);
  return diameter && std::isfinite(*diameter) ? *diameter : 0;
}

/// The netting and the ropes of a scene: elements of three and of two nodes that have a tension.
Layers layers_of(const Scene& scene, const Assembler& assembler) {
  Layers layers;
  for (const Part& part : scene.parts) layers.gauge.push_back(gauge_of(part));
  for (const auto& one : assembler.families()) {
    const ElementFamily& family = *one;
    const auto& outputs = family.type().outputs;
    if (family.repeated() || std::none_of(outputs.begin(), outputs.end(), is_tension)) continue;
    for (std::size_t e = 0; e < family.size(); ++e) {
      if (family.nodes_per_element() == 3) {
        layers.triangles.push_back({family.node(e, 0), family.node(e, 1), family.node(e, 2)});
        layers.part_of_triangle.push_back(family.part(e));
      } else if (family.nodes_per_element() == 2) {
        layers.bars.push_back({{family.node(e, 0), family.node(e, 1)}, family.part(e)});
      }
    }
  }
  return layers;
}

}  // namespace

std::vector<Passage> find_passages(const Layers& layers, std::span<const double> positions) {
  return PassageFinder(layers, positions).find();
}

std::vector<std::string> passage_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                          const Response& answer) {
  const Layers layers = layers_of(loaded.scene, assembler);
  const std::vector<double> positions = assembler.node_positions(answer.x);
  std::vector<std::string> warnings;
  for (const Passage& p : find_passages(layers, positions))
    warnings.push_back(fmt::format(
        "{} passes through {}, deepest at ({:.2f}, {:.2f}, {:.2f}) m, by {:.2g} m{}: the model has no "
        "contact "
        "between parts of the gear",
        loaded.scene.parts[p.part].name, loaded.scene.parts[p.through].name, p.at[0], p.at[1], p.at[2],
        p.depth, p.places > 1 ? fmt::format(", and in {} triangles in all", p.places) : ""));
  return warnings;
}

}  // namespace netloft::results
