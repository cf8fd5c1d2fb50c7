// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/comparison.hpp"

#include "framework/assembler/reports.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::real_gears {

namespace {

double norm(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector at_node(const Assembler& assembler, std::uint32_t node, std::span<const double> field) {
  Vector v{};
  for (int axis = 0; axis < 3; ++axis)
    v[static_cast<std::size_t>(axis)] = field[assembler.numbering().dof(node, axis).at()];
  return v;
}

Vector free_part(const NeutralNode& node, Vector force) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((node.fixed | node.symmetry) >> axis & 1) force[axis] = 0;
    if (node.symmetry) force[axis] *= 2;
  }
  return force;
}

}  // namespace

OutOfBalance out_of_balance(const NeutralCase& gear, const Assembler& assembler,
                            std::span<const double> residual) {
  OutOfBalance all;
  for (std::uint32_t n = 0; n < gear.nodes.size(); ++n) {
    const Vector force = free_part(gear.nodes[n], at_node(assembler, n, residual));
    all.mean += norm(force) / static_cast<double>(gear.nodes.size());
    for (const double component : force)
      all.largest_component = std::max(all.largest_component, std::abs(component));
  }
  return all;
}

std::vector<Vector> nodal(const NeutralCase& gear, const Assembler& assembler, std::span<const double> x) {
  std::vector<Vector> positions;
  for (std::uint32_t n = 0; n < gear.nodes.size(); ++n) positions.push_back(at_node(assembler, n, x));
  return positions;
}

std::vector<double> over_dofs(const Assembler& assembler, const std::vector<Vector>& positions) {
  std::vector<double> x(assembler.numbering().dofs());
  for (std::uint32_t n = 0; n < positions.size(); ++n)
    for (int axis = 0; axis < 3; ++axis)
      x[assembler.numbering().dof(n, axis).at()] = positions[n][static_cast<std::size_t>(axis)];
  return x;
}

double distance(const Vector& a, const Vector& b) { return norm(minus(a, b)); }

Furthest furthest(const std::vector<Vector>& positions, const std::vector<Vector>& reference) {
  Furthest worst;
  for (std::uint32_t n = 0; n < positions.size(); ++n) {
    const double away = distance(positions[n], reference[n]);
    if (away > worst.distance) worst = {away, n};
  }
  return worst;
}

namespace {

double tension(double length, double rest_length, double EA, double EA_compression) {
  return (length >= rest_length ? EA : EA_compression) * (length - rest_length) / rest_length;
}

double tension(const NeutralBar& b, const std::vector<Vector>& x) {
  return tension(distance(x[b.nodes[1]], x[b.nodes[0]]), b.rest_length, b.EA, b.EA_compression);
}

/// Tensions along u and v, implemented independently from the description of the format.
std::array<double, 2> tensions(const NeutralCase& gear, const NeutralTriangle& t,
                               const std::vector<Vector>& x) {
  const auto& [a, b, c] = t.twine_uv;
  const double u2 = b[0] - a[0], v2 = b[1] - a[1], u3 = c[0] - a[0], v3 = c[1] - a[1];
  const double d = u2 * v3 - u3 * v2;
  const Vector side2 = minus(x[t.nodes[1]], x[t.nodes[0]]), side3 = minus(x[t.nodes[2]], x[t.nodes[0]]);
  Vector along_u{}, along_v{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along_u[axis] = (v3 * side2[axis] - v2 * side3[axis]) / d;
    along_v[axis] = (u2 * side3[axis] - u3 * side2[axis]) / d;
  }
  const NeutralMaterial& m = gear.materials[t.material];
  return {tension(norm(along_u), m.bar_length, m.EA, m.EA_compression),
          tension(norm(along_v), m.bar_length, m.EA, m.EA_compression)};
}

}  // namespace

Branches branches(const NeutralCase& gear, const std::vector<Vector>& x) {
  Branches all;
  for (const NeutralBar& b : gear.bars)
    if (distance(x[b.nodes[1]], x[b.nodes[0]]) < b.rest_length)
      ++(b.EA_compression > 1e-3 * b.EA ? all.pressed_bars : all.slack_bars);
  for (const NeutralTriangle& t : gear.triangles)
    for (const double T : tensions(gear, t, x)) all.slack_twines += T <= 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    all.dry_nodes += x[n][2] > 0;
    all.nodes_on_bed += gear.nodes[n].sense[2] > 0 && x[n][2] < gear.nodes[n].limit[2];
  }
  return all;
}

double largest_tension(const NeutralCase& gear, const std::vector<Vector>& x) {
  double largest = 0;
  for (const NeutralBar& b : gear.bars) largest = std::max(largest, tension(b, x));
  for (const NeutralTriangle& t : gear.triangles)
    for (const double T : tensions(gear, t, x)) largest = std::max(largest, T);
  return largest;
}

namespace {

/// The first output of this name for each element of a type; the key is the nodes of the element.
std::map<std::vector<std::uint32_t>, double> output_by_nodes(Assembler& assembler, std::span<const double> x,
                                                             const std::string& type,
                                                             const std::string& name) {
  std::map<std::vector<std::uint32_t>, double> by_nodes;
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    if (family.type().type != type) continue;
    std::vector<std::vector<double>> values;
    assembler.reports().outputs(x, f, values);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (family.type().outputs[k].name == name)
        for (std::size_t e = 0; e < family.size(); ++e) {
          std::vector<std::uint32_t> nodes;
          for (int corner = 0; corner < family.nodes_per_element(); ++corner)
            nodes.push_back(family.node(e, corner));
          by_nodes[nodes] = values[k][e];
        }
  }
  return by_nodes;
}

template <std::size_t N>
std::vector<std::uint32_t> as_key(const std::array<std::uint32_t, N>& nodes) {
  return {nodes.begin(), nodes.end()};
}

void widen(double& worst, double a, double b) { worst = std::max(worst, std::abs(a - b)); }

}  // namespace

ForceDifference compare_forces(const NeutralCase& gear, Assembler& assembler, std::span<const double> x,
                               std::span<const double> residual) {
  ForceDifference worst;
  const auto bars = output_by_nodes(assembler, x, "rope/bar", "tension");
  for (std::size_t b = 0; b < gear.bars.size(); ++b)
    widen(worst.bars, bars.at(as_key(gear.bars[b].nodes)), gear.reference.bar_tensions[b]);
  const auto netting = output_by_nodes(assembler, x, "priour/triangle", "tension");
  for (std::size_t t = 0; t < gear.triangles.size(); ++t) {
    const auto& [Tu, Tv] = gear.reference.twine_tensions[t];
    widen(worst.twines, netting.at(as_key(gear.triangles[t].nodes)), std::max(Tu, Tv));
  }
  for (const auto& reaction : gear.reference.reactions)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (gear.nodes[reaction.node].fixed >> axis & 1)
        widen(worst.reactions, at_node(assembler, reaction.node, residual)[axis], reaction.force[axis]);
  return worst;
}

}  // namespace netloft::real_gears
