// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of rigid bodies: position, attitude, and the forces on them.
#include <netloft/attitude.hpp>

#include <algorithm>

#include "io/results/figures/gear_view.hpp"

namespace netloft::results {

namespace {

void add_place(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer,
               std::size_t b, const std::string& own, std::vector<Figure>& figures) {
  const RigidBody& body = loaded.scene.bodies[b];
  const auto psi = assembler.rotation(b, answer.x);
  const Attitude turned = attitude_of(turned_axes(Vector{psi[0], psi[1], psi[2]}), loaded.bodies[b].side);
  const auto at = assembler.node_position(body.origin, answer.x);
  figures.push_back(
      {own + "heading", "rad", "angle by which the nose of the body is turned outward", turned.heading});
  figures.push_back({own + "heel", "rad", "angle by which the top of the body leans outward", turned.heel});
  figures.push_back({own + "trim", "rad", "angle by which the nose of the body is up", turned.trim});
  figures.push_back({own + "x", "m", "position of the origin of the body, aft", at[0]});
  figures.push_back({own + "y", "m", "position of the origin of the body, to starboard", at[1]});
  figures.push_back(
      {own + "z", "m", "height of the origin of the body over the surface of the water", at[2]});
  if (loaded.scene.bed.is_there)
    figures.push_back({own + "above_bed", "m", "height of the origin of the body over the bed",
                       at[2] - loaded.scene.bed.at(at[0], at[1])[0]});
}

/// Adds the outputs of the body's own element, such as the angle of attack of a board. Outputs that flag a
/// doubtful result (NETLOFT_OUTPUT_DOUBT) become warnings instead.
void add_outputs(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer,
                 std::size_t b, const std::string& own, std::vector<Figure>& figures) {
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    const auto [first, last] = family.elements_of(loaded.bodies[b].part);
    for (std::size_t e = first; e < last; ++e) {
      const auto& outputs = family.type().outputs;
      for (std::size_t k = 0; k < outputs.size(); ++k)
        if (outputs[k].role != NETLOFT_OUTPUT_DOUBT)
          figures.push_back(
              {own + outputs[k].name, outputs[k].unit, outputs[k].doc, answer.outputs[f][k][e]});
    }
  }
}

/// Whether all nodes of a part belong to rigid bodies. This is true for a board and its shoe, but not for a
/// rope.
bool rides_on_bodies(const Scene& scene, const Part& part) {
  return std::ranges::all_of(part.nodes, [&](std::uint32_t node) {
    return std::ranges::any_of(scene.bodies, [&](const RigidBody& body) {
      return node == body.origin ||
             std::ranges::any_of(body.points, [&](const auto& point) { return point.node == node; });
    });
  });
}

/// Whether elements of a part can have contact with the ground. Such elements have an output for the normal
/// force.
bool rests_on_ground(const Assembler& assembler, std::uint32_t part) {
  return std::ranges::any_of(assembler.families(), [&](const auto& family) {
    const auto& outputs = family->type().outputs;
    const auto& parts = family->parts();
    return std::ranges::find(parts, part) != parts.end() &&
           std::ranges::any_of(outputs, [](const auto& o) { return is_output(o, output::kNormalForce); });
  });
}

/// The name under which the report adds up a force on a body: "water", "weight" or "ground" for the forces of
/// parts whose nodes all belong to bodies; the name of the part, such as a warp, for other forces.
std::string source_of(const scenes::LoadedScene& loaded, const Assembler& assembler, const BodyForce& force) {
  const Part& part = loaded.scene.parts[force.part];
  if (!rides_on_bodies(loaded.scene, part)) return part.name;
  if (force.of.is_drag()) return "water";
  if (force.of.is_weight()) return "weight";
  const bool reads_ground = force.of.traits & (NETLOFT_READS_BED | NETLOFT_READS_GROUND);
  return reads_ground || rests_on_ground(assembler, force.part) ? "ground" : part.name;
}

void add_budget(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer,
                std::size_t b, std::vector<Figure>& figures) {
  const RigidBody& body = loaded.scene.bodies[b];
  std::vector<std::pair<std::string, Vector>> sums;
  for (const BodyForce& force : answer.body_forces) {
    if (force.body != b) continue;
    const std::string source = source_of(loaded, assembler, force);
    auto at = std::find_if(sums.begin(), sums.end(), [&](const auto& s) { return s.first == source; });
    if (at == sums.end()) at = sums.insert(at, {source, {}});
    at->second += Vector{force.of.force[0], force.of.force[1], force.of.force[2]};
  }
  for (const auto& [source, force] : sums) {
    const std::string at = "body_forces/" + body.name + "/" + source + "/",
                      doc = "force on the body by " + source;
    figures.push_back({at + "x", "N", doc + ", aft", force.x});
    figures.push_back({at + "out", "N", doc + ", outward", loaded.bodies[b].side * force.y});
    figures.push_back({at + "z", "N", doc + ", upwards", force.z});
  }
}

}  // namespace

void add_body_figures(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer,
                      std::vector<Figure>& figures) {
  for (std::size_t b = 0; b < loaded.scene.bodies.size(); ++b) {
    const std::string own = "bodies/" + loaded.scene.bodies[b].name + "/";
    add_place(loaded, assembler, answer, b, own, figures);
    add_outputs(loaded, assembler, answer, b, own, figures);
    add_budget(loaded, assembler, answer, b, figures);
  }
}

}  // namespace netloft::results
