// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/case_scene.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace netloft::real_gears {

namespace {

LawChoice morison(double cd_normal, double cd_tangent) {
  return {"hydro/morison", {{"normal", cd_normal}, {"tangential", cd_normal * cd_tangent}}};
}

template <std::size_t N>
void append(std::vector<double>& to, const std::array<double, N>& numbers) {
  to.insert(to.end(), numbers.begin(), numbers.end());
}

template <std::size_t N>
void append(std::vector<std::uint32_t>& to, const std::array<std::uint32_t, N>& nodes) {
  to.insert(to.end(), nodes.begin(), nodes.end());
}

Part make_part(std::string name, std::string type, Values parameters) {
  Part part;
  part.name = std::move(name), part.type = std::move(type), part.parameters = std::move(parameters);
  return part;
}

Values netting_parameters(const NeutralMaterial& m) {
  return {{"twine.EA", m.EA},
          {"twine.EA_compression", m.EA_compression},
          {"twine.diameter", m.diameter},
          {"twine.density", m.density}};
}

Values rope_parameters(const NeutralBar& b) {
  return {{"rope.EA", b.EA},
          {"rope.EA_compression", b.EA_compression},
          {"rope.diameter", b.diameter},
          {"rope.density", b.density}};
}

void add_triangle(Part& part, const NeutralTriangle& t, double bar_length) {
  append(part.nodes, t.nodes);
  for (const auto& [u, v] : t.twine_uv) part.data["u"].push_back(u), part.data["v"].push_back(v);
  part.data["bar_length"].push_back(bar_length);
}

/// One part per material.
std::vector<Part> netting_of(const NeutralCase& gear) {
  std::vector<Part> parts;
  for (const NeutralMaterial& m : gear.materials) {
    Part part =
        make_part("netting " + std::to_string(parts.size()), "priour/triangle", netting_parameters(m));
    part.laws["drag"] = gear.drags_netting ? morison(m.cd_normal, m.cd_tangent) : morison(0, 0);
    parts.push_back(std::move(part));
  }
  for (const NeutralTriangle& t : gear.triangles)
    add_triangle(parts.at(t.material), t, gear.materials[t.material].bar_length);
  std::erase_if(parts, [](const Part& part) { return part.nodes.empty(); });
  return parts;
}

/// Makes one part for each kind of rope.
std::vector<Part> ropes_of(const NeutralCase& gear) {
  std::vector<Part> parts;
  for (const NeutralBar& b : gear.bars) {
    Part fresh = make_part("rope " + std::to_string(parts.size()), "rope/bar", rope_parameters(b));
    fresh.laws["drag"] = morison(b.cd_normal, b.cd_tangent);
    auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& other) {
      return other.parameters == fresh.parameters && other.laws == fresh.laws;
    });
    if (part == parts.end()) part = parts.insert(part, std::move(fresh));
    append(part->nodes, b.nodes);
    part->data["rest_length"].push_back(b.rest_length);
  }
  return parts;
}

/// A part with the elements of `wet`, which computes the forces that the elements of `wet` lose above the
/// surface.
Part dry(const Part& wet) {
  const bool netting = wet.type == "priour/triangle";
  const std::string diameter = netting ? "twine.diameter" : "rope.diameter";
  Part part = make_part("dry " + wet.name, netting ? "femnet/dry_netting" : "femnet/dry_bar",
                        {{diameter, wet.parameters.at(diameter)}});
  part.nodes = wet.nodes, part.data = wet.data, part.laws = wet.laws;
  return part;
}

double rest_length(const NeutralCase& gear, std::uint32_t a, std::uint32_t b) {
  for (const NeutralBar& bar : gear.bars)
    if (std::minmax(bar.nodes[0], bar.nodes[1]) == std::minmax(a, b)) return bar.rest_length;
  throw std::runtime_error(gear.name + ": bends where there is no bar");
}

/// One part per bending stiffness.
std::vector<Part> bends_of(const NeutralCase& gear, const Modelling& modelling) {
  std::map<double, Part> parts;
  for (const NeutralBend& b : gear.bends) {
    Part& part = parts[b.EI];
    if (part.nodes.empty())
      part =
          make_part("bends", modelling.shipped_bending ? "rope/bending" : "femnet/bend", {{"rope.EI", b.EI}});
    append(part.nodes, b.nodes);
    append(part.data["rest_length"],
           std::array{rest_length(gear, b.nodes[0], b.nodes[1]), rest_length(gear, b.nodes[1], b.nodes[2])});
  }
  std::vector<Part> all;
  for (auto& [EI, part] : parts) all.push_back(std::move(part));
  return all;
}

bool is_bare(const NeutralNode& n) {
  return n.force == Vector{} && n.box == Vector{} && n.sense == Vector{} && n.mass == 0;
}

std::vector<Part> loads_of(const NeutralCase& gear) {
  Part part = make_part("loads", "femnet/node",
                        {{"limit.stiffness", gear.bed_stiffness}, {"limit.friction", gear.bed_friction}});
  for (std::uint32_t i = 0; i < gear.nodes.size(); ++i) {
    const NeutralNode& n = gear.nodes[i];
    if (is_bare(n)) continue;
    part.nodes.push_back(i);
    append(part.data["force"], n.force), append(part.data["box"], n.box);
    append(part.data["limit"], n.limit), append(part.data["sense"], n.sense);
    part.data["mass"].push_back(n.mass), part.data["share"].push_back(n.symmetry ? 0.5 : 1);
  }
  return part.nodes.empty() ? std::vector<Part>{} : std::vector{part};
}

/// Labels each node by the first part that contains it.
void label_nodes(Scene& scene) {
  scene.labels.resize(scene.node_count());
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) scene.labels[n].id = n;
  for (std::uint32_t p = static_cast<std::uint32_t>(scene.parts.size()); p-- > 0;)
    for (const auto node : scene.parts[p].nodes) scene.labels[node].part = p;
}

void add_nodes(Scene& scene, const NeutralCase& gear) {
  for (const NeutralNode& n : gear.nodes) {
    scene.positions.insert(scene.positions.end(), n.initial.begin(), n.initial.end());
    scene.held.push_back(n.fixed | n.symmetry);
  }
}

void add_parts(Scene& scene, std::vector<Part> parts) {
  std::move(parts.begin(), parts.end(), std::back_inserter(scene.parts));
}

}  // namespace

Scene make_scene(const NeutralCase& gear, const Modelling& modelling) {
  Scene scene;
  scene.name = gear.name;
  scene.water.density = gear.water_density, scene.water.gravity = gear.gravity;
  scene.current.samples = {{0, gear.current}};
  add_nodes(scene, gear);
  add_parts(scene, netting_of(gear));
  add_parts(scene, ropes_of(gear));
  const std::vector<Part> shipped = scene.parts;
  if (modelling.surface)
    for (const Part& part : shipped) scene.parts.push_back(dry(part));
  add_parts(scene, bends_of(gear, modelling));
  add_parts(scene, loads_of(gear));
  label_nodes(scene);
  return scene;
}

void place_nodes(Scene& scene, const std::vector<Vector>& positions) {
  for (std::size_t n = 0; n < positions.size(); ++n)
    std::copy(positions[n].begin(), positions[n].end(), scene.positions.begin() + std::ptrdiff_t(3 * n));
}

}  // namespace netloft::real_gears
