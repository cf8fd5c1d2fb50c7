// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/gear_view.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/results/figures/named_scalar.hpp"

namespace netloft::results {

const std::uint32_t* GearView::find_rope(const std::string& wanted) const {
  const auto& ropes = gear().ropes;
  const auto at = std::find_if(ropes.begin(), ropes.end(), [&](auto rope) { return name(rope) == wanted; });
  return at == ropes.end() ? nullptr : &*at;
}

Vector GearView::at(std::uint32_t node) const {
  const auto [x, y, z] = assembler_.node_position(node, answer_.x);
  return {x, y, z};
}

std::vector<double> GearView::rest_lengths(std::uint32_t rope) const {
  const auto* lengths = find_data(loaded_.scene.parts[rope].data, datum::kRestLength);
  return lengths ? *lengths : std::vector<double>(nodes_of(rope).size() - 1, 1.0);
}

Vector GearView::middle_of(std::uint32_t rope) const {
  const auto& nodes = nodes_of(rope);
  if (is_half()) return at(nodes.front());
  const auto lengths = rest_lengths(rope);
  double left = std::accumulate(lengths.begin(), lengths.end(), 0.0) / 2;
  std::size_t bar = 0;
  while (bar + 1 < lengths.size() && left > lengths[bar]) left -= lengths[bar++];
  const Vector start = at(nodes[bar]);
  return start + (left / lengths[bar]) * (at(nodes[bar + 1]) - start);
}

template <class IsWanted>
std::vector<double> GearView::first_output(std::uint32_t part, const IsWanted& is_wanted) const {
  std::vector<double> values;
  for (std::size_t f = 0; f < answer_.outputs.size(); ++f) {
    const ElementFamily& family = *assembler_.families()[f];
    if (std::ranges::count(family.parts(), part) == 0) continue;
    const auto& outputs = family.type().outputs;
    const auto wanted = std::ranges::find_if(outputs, is_wanted);
    if (wanted == outputs.end()) continue;
    const auto& of_elements = answer_.outputs[f][static_cast<std::size_t>(wanted - outputs.begin())];
    const auto [first, last] = family.elements_of(part);
    for (std::size_t e = first; e < last; ++e) values.push_back(of_elements[e]);
  }
  return values;
}

std::vector<double> GearView::output(std::uint32_t part, const KnownOutput& known) const {
  return first_output(part, [&](const netloft_output& one) { return is_output(one, known); });
}

std::vector<double> GearView::tensions(std::uint32_t part) const { return first_output(part, is_tension); }

double GearView::largest_twine_tension(std::uint32_t panel) const {
  double largest = NamedScalar::kUnknown;
  for (std::size_t f = 0; f < answer_.outputs.size(); ++f) {
    const ElementFamily& family = *assembler_.families()[f];
    const auto [first, last] = family.elements_of(panel);
    if (first == last || family.nodes_per_element() != 3) continue;
    for (std::size_t k = 0; k < family.type().outputs.size(); ++k)
      for (std::size_t e = first; e < last && is_tension(family.type().outputs[k]); ++e)
        largest = std::fmax(largest, answer_.outputs[f][k][e]);
  }
  return largest;
}

GearView::GearView(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer)
    : loaded_(loaded), assembler_(assembler), answer_(answer) {
  for (const PartForce& force : answer.forces) forces_[force.part].push_back(&force);
}

const std::vector<const PartForce*>& GearView::forces_on(const std::string& part) const {
  static const std::vector<const PartForce*> none;
  const auto at = forces_.find(part);
  return at == forces_.end() ? none : at->second;
}

Vector GearView::force(const std::string& part, const Kind& is_of_kind) const {
  Vector sum;
  for (const PartForce* f : forces_on(part))
    if (is_of_kind(*f)) sum += {f->force[0], f->force[1], f->force[2]};
  return sum;
}

bool GearView::has_force(const std::string& part, const Kind& is_of_kind) const {
  return std::ranges::any_of(forces_on(part), [&](const PartForce* f) { return is_of_kind(*f); });
}

Vector GearView::current_at(const Vector& place) const {
  std::array<double, 3> flow{}, dz{};
  loaded_.scene.current.at(place.z, flow, dz);
  const Vector v{flow[0], flow[1], flow[2]};
  return norm(v) > 0 ? (1 / norm(v)) * v : Vector{1, 0, 0};
}

Vector whole_of(const Vector& modelled, double times) {
  return {times * modelled.x, modelled.y, times * modelled.z};
}

std::vector<Figure> find_gear_figures(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer) {
  std::vector<Figure> figures;
  add_body_figures(loaded, assembler, answer, figures);
  if (!loaded.gear) return figures;
  const GearView gear(loaded, assembler, answer);
  add_mouth_figures(gear, figures);
  add_rope_figures(gear, figures);
  add_pair_figures(gear, figures);
  add_towing_figures(gear, figures);
  add_force_figures(gear, figures);
  add_ground_figures(gear, figures);
  add_netting_figures(gear, figures);
  return figures;
}

}  // namespace netloft::results
